//! In which direction K, M V0² and σ change the ratio ω/ω_n of a complex pair at a threshold: where it is crossed once.

use super::Equations;
use super::notation::{cubic, formula, given_nonzero};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

/// (ω/ω_n)² of the roots −q and x ± iy with W = x² + y²: y²/(q W).
const RATIO: &str = "(W - x^2)/(q*W)";

/// |p + q|².
const DISTANCE: &str = "(W + 2*q*x + q^2)";

/// (ω/ω_n)² ≥ T of a pair is up in K, M and V0 and down in σ, for 1/5 ≤ T < 1.
///
/// # Errors
/// When eq 8 does not have the form that the ratio rests on.
pub fn threshold(equations: &Equations) -> Result<Proof, Refutation> {
    let free = given_nonzero(Domain::positive("q W"), &["q - 2*x - 1", "W + 2*q*x + q^2"], &[("q", "4")]);
    let [eta, kappa, beta] =
        ["1/(q - 2*x - 1)", "q*W/(q - 2*x - 1)", "(q - 1)*(W + 2*x + 1)/(q - 2*x - 1)"].map(formula);
    let groups = |f: &Expression| f.with("eta", &eta).with("kappa", &kappa).with("beta", &beta);
    let proof = Proof::new(
        "frequency-threshold-is-crossed-once",
        "Let T be a threshold of (ω/ω_n)² from 1/5 to 1. Greater K, M and V0 and less σ lead to pairs above the threshold and never \
             back, at constant a, b and D_c: (ω/ω_n)² grows with κ and with η wherever it is T. There q > 1, because \
             β = η (q − 1) |1 + p|² is positive, and T q ≤ 1, because W (1 − T q) = x². Where x = 0, the numerator for K is \
             (1 − T) W. Less σ is more κ and more η by the same factor, and ω/ω_n does not contain σ otherwise.",
    )
    .identity(
        "Roots −q and x ± iy with W = x² + y² determine η, κ and β",
        &["8"],
        &groups(&cubic(equations)),
        &formula("(p + q)*(p^2 - 2*x*p + W)/(q - 2*x - 1)"),
        &free,
    )?;
    let values = [eta, kappa, beta];
    let stiffness = formula(&format!("W + (1 + q)*x + q - {RATIO}*{DISTANCE}"));
    let proof = along(
        proof,
        "K",
        ["-W*q*(q - 1)/2", "W*q*(W + 2*x + q)", "-W*q*(q - 1)"],
        (&values, 1),
        &(stiffness.clone() / formula(DISTANCE)),
        &free,
    )?;
    let inertia = with_ratio("x^2 + x*(1 + q - 2*T*q^2) + q*(1 - 2*T*q + T*q^2)");
    let proof = along(
        proof,
        "M V0²",
        ["(-2*W*x + W*q - W - 4*x^2*q - 2*x*q)/2", "-W*(W + 2*x*q + q)", "-q^2*(q - 1)"],
        (&values, 0),
        &(inertia.clone() / formula(&format!("q*{DISTANCE}"))),
        &free,
    )?;
    let proof = proof
        .identity(
            "4 (1 − T) W times the numerator for K is a square and x² times a bracket",
            &[],
            &(with_ratio("4*(1 - T)*W") * stiffness),
            &with_ratio("(2*(1 - T)*W + (1 + q - 2*T*q)*x)^2 + x^2*(4*T*(1 - T)*q^2 - (q - 1)^2)"),
            &free,
        )?
        .identity(
            "4 times the numerator for M V0² is a square and a bracket",
            &[],
            &(formula("4") * inertia),
            &with_ratio("(2*x + 1 + q - 2*T*q^2)^2 + 4*q*(1 - 2*T*q + T*q^2) - (1 + q - 2*T*q^2)^2"),
            &free,
        )?;
    brackets(proof)
}

/// A formula in T with (ω/ω_n)² in its place.
fn with_ratio(text: &str) -> Expression {
    formula(text).with("T", &formula(RATIO))
}

/// The change of (ω/ω_n)² with the logarithm of one group; η, κ and β change as stated: the other two not at all.
fn along(
    proof: Proof,
    name: &str,
    direction: [&str; 3],
    (groups, changed): (&[Expression; 3], usize),
    expected: &Expression,
    domain: &Domain,
) -> Result<Proof, Refutation> {
    let changes = direction.map(|change| formula(&format!("({change})/{DISTANCE}")));
    let change_of = |f: &Expression| {
        let parts = ["x", "W", "q"].into_iter().zip(&changes);
        parts.fold(formula("0"), |sum, (variable, change)| {
            sum + f.derivative(&Symbol::from(variable)) * change.clone()
        })
    };
    let mut proof = proof;
    for (index, (group, symbol)) in groups.iter().zip(["η", "κ", "β"]).enumerate() {
        let wanted = if index == changed { group.clone() } else { formula("0") };
        let says = format!("along {name}, the change of {symbol}");
        proof = proof.identity(&says, &[], &change_of(group), &wanted, domain)?;
    }
    let says = format!("along {name}, the change of (ω/ω_n)²");
    proof.identity(&says, &[], &change_of(&formula(RATIO)), expected, domain)
}

/// Both brackets are positive for 1/5 ≤ T < 1 and 1 < q ≤ 1/T, but the first one at T = 1/5 = 1/q, where x = 0.
fn brackets(proof: Proof) -> Result<Proof, Refutation> {
    let brackets = [
        ("the bracket for K", "4*T*(1 - T)*q^2 - (q - 1)^2"),
        ("the bracket for M V0²", "4*q*(1 - 2*T*q + T*q^2) - (1 + q - 2*T*q^2)^2"),
    ];
    let threshold = |domain: Domain| domain.with("T", formula("(1 + 5*h)/(5 + 5*h)"));
    let at_least = |domain: Domain| domain.with("T", formula("1/5"));
    let mut proof = proof;
    for (name, text) in brackets {
        let bracket = formula(text);
        let of_root = |text: &str| bracket.with("q", &formula(text));
        let both = threshold(Domain::positive("h k"));
        proof = proof
            .positive(
                &format!("{name} for T = (1 + 5h)/(5 + 5h), q = (1 + k)/(T + k)"),
                &[],
                &of_root("(1 + k)/(T + k)"),
                &both,
            )?
            .positive(
                &format!("{name} for T = 1/5, q = (1 + k)/(T + k)"),
                &[],
                &of_root("(1 + k)/(T + k)"),
                &at_least(Domain::positive("k")),
            )?
            .positive(
                &format!("{name} for T = (1 + 5h)/(5 + 5h), q = 1/T"),
                &[],
                &of_root("1/T"),
                &threshold(Domain::positive("h")),
            )?;
    }
    let last = formula(brackets[1].1).with("q", &formula("1/T")).with("T", &formula("1/5"));
    proof.identity(
        "the bracket for M V0² for T = 1/5, q = 1/T",
        &[],
        &last,
        &formula("64"),
        &Domain::default(),
    )
}
