//! Steady sliding: θ = D_c/V for both evolution laws, with friction μ0 + (a − b)·ln(V/V0).

use super::Equations;
use super::notation::{any, formula};
use crate::friction::EvolutionLaw;
use crate::polynomial::{Domain, Proof, Refutation, Toward};

/// Both laws rest at θ_ss = D_c/V and nowhere else, with friction μ_ss (eqs 1-3, claim F1).
///
/// # Errors
/// When a law does not vanish there, or eq 1 gives another friction.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let friction = equations.right("1").with("theta", &equations.right("steady-state"));
    let ratio = |number: &str| equations.right(number).with("theta", &formula("x*D_c/V"));
    let proof = Proof::new(
        "steady-state",
        "Both evolution laws have exactly one steady state at velocity V, θ = D_c/V, with \
             friction μ0 + (a − b) ln(V/V0).",
    );
    laws_rest(proof, equations)?
        .identity(
            "in x = Vθ/D_c the aging law is 1 − x, zero at x = 1 only",
            &["2"],
            &ratio("2"),
            &formula("1 - x"),
            &with_ratio(),
        )?
        .identity(
            "in x = Vθ/D_c the slip law is −x ln x, zero for x > 0 at x = 1 only",
            &["3"],
            &ratio("3"),
            &formula("-x*ln(x)"),
            &with_ratio(),
        )?
        .identity(
            "eq 1 at θ = D_c/V",
            &["1", "steady-state", "steady-friction"],
            &friction,
            &equations.right("steady-friction"),
            &any(),
        )
}

/// Adds that both laws rest at the steady state, which every linearisation about it presupposes.
///
/// # Errors
/// When θ_ss is not positive, or a law has another rate there than zero.
pub(super) fn laws_rest(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let steady = equations.right("steady-state");
    let mut proof = proof.positive("θ_ss is positive", &["steady-state"], &steady, &any())?;
    for law in EvolutionLaw::ALL {
        let number = law.equation();
        let says = format!("the {} law rests at θ = D_c/V", law.as_str());
        let rate = equations.right(number).with("theta", &steady);
        proof = proof.identity(&says, &[number, "steady-state"], &rate, &formula("0"), &any())?;
    }
    Ok(proof)
}

/// Far from steady state the laws part: at V → 0 the aging law heals at rate 1, the slip law not at all (claim F3).
///
/// # Errors
/// When eq 2 or 3 has another limit.
pub fn laws_differ_at_rest(equations: &Equations) -> Result<Proof, Refutation> {
    let in_ratio = |number: &str| equations.right(number).with("theta", &formula("x*D_c/V"));
    let difference = in_ratio("2") - in_ratio("3");
    let slip = formula("y/(1 + y + y^2/2)");
    Proof::new(
        "laws-differ-at-rest",
        "At V = 0 the aging law gives dθ/dt = 1 for every θ, while the slip law's rate tends \
             to 0 as V → 0; the aging law's rate is the larger one everywhere but at steady \
             state.",
    )
    .limit("aging law at V → 0", &["2"], &equations.right("2"), ("V", Toward::Zero), &formula("1"), &any())?
    .identity("slip law in x = Vθ/D_c", &["3"], &in_ratio("3"), &formula("-x*ln(x)"), &with_ratio())?
    .growth(
        "e^y − 1 − y − y²/2 is positive for y > 0",
        &[],
        (&formula("exp(y) - 1 - y - y^2/2"), "y", 3),
        &Domain::positive("y"),
    )?
    .limit(
        "with y = −ln x the slip law's rate y e^(−y) is below a bound that vanishes as x → 0",
        &[],
        &slip,
        ("y", Toward::Infinity),
        &formula("0"),
        &Domain::positive("y"),
    )?
    .identity("difference of the laws", &["2", "3"], &difference, &formula("1 - x + x*ln(x)"), &with_ratio())?
    .identity(
        "its derivative is ln x: negative below x = 1, positive above, so that the least \
             value is at x = 1",
        &[],
        &formula("1 - x + x*ln(x)").derivative(&"x".into()),
        &formula("ln(x)"),
        &with_ratio(),
    )?
    .identity(
        "and that least value is 0",
        &[],
        &formula("1 - x + x*ln(x)").with("x", &formula("1")),
        &formula("0"),
        &with_ratio(),
    )
}

/// Without slip the aging law adds b·ln of time to the state's part of friction, while eq 1 has no value (claim F5).
///
/// # Errors
/// When eq 1 or 2 gives another rate.
pub fn healing(equations: &Equations) -> Result<Proof, Refutation> {
    let domain = any().and_positive("t theta_0 z");
    let friction = equations.right("1");
    let rate = formula("t") * friction.with("theta", &formula("theta_0 + t")).derivative(&"t".into());
    let slower = friction.with("V", &formula("V/z")) - friction;
    let expected = formula("b*t/(theta_0 + t)");
    Proof::new(
        "healing-without-slip",
        "At V = 0 the aging law gives θ = θ0 + t, and the state's part of eq 1 grows as b ln t. At V/z eq 1 is lower by \
             a ln z than at V, for every z, so it has no value at V = 0.",
    )
    .limit("aging law at V → 0", &["2"], &equations.right("2"), ("V", Toward::Zero), &formula("1"), &any())?
    .identity("t dμ/dt with θ = θ0 + t, at any velocity", &["1"], &rate, &expected, &domain)?
    .positive("it is positive for b > 0", &["1"], &rate, &domain)?
    .limit("and tends to b", &["1"], &expected, ("t", Toward::Infinity), &formula("b"), &domain)?
    .identity("eq 1 at V/z minus eq 1 at V", &["1"], &slower, &formula("-a*ln(z)"), &domain)
}

/// Another reference velocity in eq 1 is another μ0, which eq 8 does not contain (claim F6).
///
/// # Errors
/// When eq 1 changes otherwise, or eq 8 contains μ0.
pub fn reference_velocity(equations: &Equations) -> Result<Proof, Refutation> {
    let domain = any().and_positive("V_1 mu_1");
    let friction = equations.right("1");
    let shifted = equations.right("steady-friction").with("V", &formula("V_1"));
    let other = friction.with("V_0", &formula("V_1")).with("mu_0", &shifted);
    let eq8 = equations.residual("8");
    Proof::new(
        "reference-velocity",
        "Eq 1 with the reference velocity V_1 and μ_ss(V_1) in place of μ0 is the same friction; eq 8 contains no μ0. \
             So the reference velocity may be the loading velocity.",
    )
    .identity("eq 1 with another reference velocity", &["1", "steady-friction"], &other, &friction, &domain)?
    .identity("eq 8 with another μ0", &["8"], &eq8, &eq8.with("mu_0", &formula("mu_1")), &domain)
}

fn with_ratio() -> Domain {
    Domain::positive("a b D_c V V_0 x")
}
