//! How the frequency compares with ω_n = √(K/M), and the zone of low frequencies.

use super::Equations;
use super::notation::{
    any, coefficients, crossing, cubic, formula, given_nonzero, given_positive, in_groups, in_parameters,
    weakening_by_square,
};
use slipmode_algebra::{Domain, Expression, Proof, Refutation};

/// Im(s) never reaches ω_n: |s|² = ω_n²/|t| with a real root t < −1 (claim Q1).
///
/// # Errors
/// When eq 8 is not of that form.
pub fn bounded(equations: &Equations) -> Result<Proof, Refutation> {
    let eq8 = equations.residual("8");
    let at_rate = eq8.with("s", &formula("-V_0/D_c"));
    let roots = formula("M/sigma*(s + u*V_0/D_c)*(s^2 - T*s + Q)");
    let modulus = formula("K/(M*u)");
    let natural = equations.right("natural-frequency").power(2);
    let left = given_positive(Domain::positive("u"), "u - 1", &[("u", "2")]);
    let with_root = any().and_positive("u");
    let proof = Proof::new(
        "frequency-bound",
        "Eq 8 always has a real root −u V0/D_c with u > 1, and a complex pair obeys |s|² = \
             ω_n²/u < ω_n²: the angular frequency never reaches ω_n, at any parameters.",
    )
    .positive("eq 8 at s = −V0/D_c", &["8"], &at_rate, &any())?;
    let [c0, _, _, c3]: [Expression; 4] = coefficients(&proof, &["8"], &eq8, "s")?;
    let proof = proof
        .positive("its leading coefficient", &["8"], &c3, &any())?
        .root(
            "so it has a real root −u V0/D_c with u > 1",
            &["8"],
            (&eq8, "s"),
            [None, Some(&formula("-V_0/D_c"))],
            &any(),
        )?
        .identity(
            "constant coefficient of the product of factors, T and Q the sum and product of the other two",
            &[],
            &roots.with("s", &formula("0")),
            &formula("M*u*V_0*Q/(sigma*D_c)"),
            &any(),
        )?
        .identity(
            "so Q = K/(M u) makes it that of eq 8",
            &["8"],
            &formula("M*u*V_0*Q/(sigma*D_c)").with("Q", &modulus),
            &c0,
            &with_root,
        )?
        .identity("ω_n²/u", &["natural-frequency"], &(natural / formula("u")), &modulus, &with_root)?
        .positive(
            "1 − 1/u for u = 1 + w",
            &[],
            &formula("1 - 1/u"),
            &in_parameters(left, &[("u", "1 + w", "w", "u - 1")]),
        )?;
    complex_pair(proof)
}

/// Where the low frequencies end: on K = K_c, (ω/ω_n)² = η/(1+η); eq 23 meets ω_n at V_c (claim Q6).
///
/// # Errors
/// When eqs 9, 12, 13 and 23 do not fit together so.
pub fn low_frequency_zone(equations: &Equations) -> Result<Proof, Refutation> {
    let natural = equations.right("natural-frequency");
    let pair = Expression::integer(-1) * equations.right("23").power(2);
    let ratio = pair.clone() / natural.clone().power(2).with("K", &equations.right("9"));
    let eta = equations.right("inertial-parameter");
    let domain = weakening_by_square();
    let meeting = pair.with("V_0", &equations.right("13"));
    let corner = eta.with("V_0", &equations.right("13")).with("sigma", &equations.right("12"));
    let probe = cubic(equations).with("p", &formula("-1/(2*eta)"));
    let left_of_eq20 = in_parameters(
        given_positive(
            given_positive(Domain::positive("beta eta kappa"), "1 - 2*eta", &[("eta", "1/8")]),
            "1/(4*eta) - kappa",
            &[],
        ),
        &[
            ("eta", "1/(2*(1 + e))", "e", "(1 - 2*eta)/(2*eta)"),
            ("kappa", "(1 + e)/2 - d", "d", "1/(4*eta) - kappa"),
        ],
    );
    let proof = Proof::new(
        "low-frequency-zone",
        "On K = K_c, (ω/ω_n)² = η/(1 + η): one half at η = 1, a line that crosses σ = σ_c at \
             V0 = V_c, where eq 23 equals ω_n. Everywhere left of eq 20 with η < 1/2 a complex \
             pair has (ω/ω_n)² < 2η: the low-frequency zone is η ≪ 1.",
    )
    .identity(
        "(ω/ω_n)² on K = K_c",
        &["9", "23", "inertial-parameter"],
        &ratio,
        &(eta.clone() / (formula("1") + eta)),
        &crossing(),
    )?
    .identity(
        "eq 23 at V0 = V_c is ω_n",
        &["13", "23", "natural-frequency"],
        &meeting,
        &natural.power(2),
        &domain,
    )?
    .identity("η at V0 = V_c, σ = σ_c", &["12", "13", "inertial-parameter"], &corner, &formula("1"), &domain)?
    .identity(
        "eq 20 in groups is 4ηκ = 1",
        &["20"],
        &in_groups(&equations.equation("20").left.clone().power(2)),
        &formula("4*eta*kappa"),
        &Domain::positive("eta kappa"),
    )?
    .positive(
        "F(−1/(2η)) for η = 1/(2(1 + e)) and κ = 1/(4η) − d, d > 0",
        &["8"],
        &probe,
        &left_of_eq20,
    )?;
    let root = formula("-(1 + w)/(2*eta)");
    let factors = formula("eta*(p - t)*(p^2 - T*p + Q)");
    let proof = proof
        .root(
            "F has a root t < −1/(2η), the only real one besides a complex pair",
            &["8"],
            (&cubic(equations), "p"),
            [None, Some(&formula("-1/(2*eta)"))],
            &left_of_eq20,
        )?
        .identity(
            "with Q = −κ/(ηt) the product of the factors has F's constant coefficient",
            &[],
            &factors.with("p", &formula("0")).with("Q", &formula("-kappa/(eta*t)")),
            &formula("kappa"),
            &given_nonzero(Domain::positive("eta kappa"), &["t"], &[("t", "-1")]),
        )?
        .positive(
            "2η − Q/(κ/η) for t = −(1 + w)/(2η), w > 0, where κ/η = (ω_n D_c/V0)²",
            &[],
            &(formula("2*eta + 1/t").with("t", &root)),
            &Domain::positive("eta w"),
        )?;
    complex_pair(proof)
}

/// A pair x ± iy of sum T and product Q has Q = x² + y², at least y².
fn complex_pair(proof: Proof) -> Result<Proof, Refutation> {
    proof.identity(
        "a complex pair x ± iy has |s|² = Q = x² + y², and Im(s)² = y² is not larger",
        &[],
        &formula("(s - x - i*y)*(s - x + i*y)"),
        &formula("s^2 - 2*x*s + (x^2 + y^2)"),
        &Domain::default(),
    )
}
