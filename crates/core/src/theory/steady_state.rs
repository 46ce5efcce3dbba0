//! Steady sliding: θ = D_c/V for both evolution laws, with friction μ0 + (a − b)·ln(V/V0).

use super::Equations;
use super::notation::{any, formula};
use crate::friction::EvolutionLaw;
use slipmode_algebra::{Domain, Proof, Refutation, Toward};

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

fn with_ratio() -> Domain {
    Domain::positive("a b D_c V V_0 x")
}
