//! The limits of small and of large critical slip distance: eqs 17-20.

use super::notation::{
    SQUARE_MASS, SQUARE_STIFFNESS, any, coefficients, formula, in_parameters, strengthening, weakening,
};
use super::{Equation, Equations};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Toward};

/// D_c → 0 turns eq 8 into eq 17, whose roots are complex exactly for velocities above eq 18 (claim B4).
///
/// # Errors
/// When the limit or the velocity is another one.
pub fn small_slip_distance(equations: &Equations) -> Result<Proof, Refutation> {
    let scaled = equations.residual("8") * formula("sigma*D_c/V_0");
    let toward = ("D_c", Toward::Zero);
    let proof = Proof::new(
        "small-slip-distance",
        "Eq 8 times σ D_c/V0 tends to eq 17 as D_c → 0 (the third root, of sum −aσ/(M V0) − \
             V0/D_c with the others, goes to −∞). Its imaginary part vanishes exactly where V0 is \
             at most that of eq 18.",
    )
    .limit(
        "eq 8 times σ D_c/V0 as D_c → 0",
        &["8", "17"],
        &scaled,
        toward,
        &equations.residual("17"),
        &any(),
    )?;
    let proof = critical_damping(proof, equations, ("17", "18"), "(a - b)^2*sigma^2", &weakening(), "a < b")?;
    critical_damping(proof, equations, ("17", "18"), "(a - b)^2*sigma^2", &strengthening(), "a > b")
}

/// D_c → ∞ turns eq 8 into s times eq 19, whose roots are complex exactly for velocities above eq 20 (claim B5).
///
/// # Errors
/// When the limit or the velocity is another one.
pub fn large_slip_distance(equations: &Equations) -> Result<Proof, Refutation> {
    let scaled = equations.residual("8") * formula("sigma");
    let value = formula("s") * equations.residual("19");
    let toward = ("D_c", Toward::Infinity);
    let proof = Proof::new(
        "large-slip-distance",
        "Eq 8 times σ tends to s times eq 19 as D_c → ∞: eq 19 after dividing by s (a root of \
             order −V0/D_c goes to 0). Its imaginary part vanishes exactly where V0 is at most \
             that of eq 20.",
    )
    .limit("eq 8 times σ as D_c → ∞", &["8", "19"], &scaled, toward, &value, &any())?;
    let domain = in_parameters(any(), &[SQUARE_STIFFNESS, SQUARE_MASS]);
    critical_damping(proof, equations, ("19", "20"), "a^2*sigma^2", &domain, "any a and b")
}

/// The discriminant of a quadratic is a positive factor times 1 − L², where L = 1 is the equation of its boundary.
fn critical_damping(
    proof: Proof,
    equations: &Equations,
    (quadratic, boundary): (&str, &str),
    factor: &str,
    domain: &Domain,
    case: &str,
) -> Result<Proof, Refutation> {
    let [c0, c1, c2]: [Expression; 3] =
        coefficients(&proof, &[quadratic], &equations.residual(quadratic), "s")?;
    let discriminant = (c1.power(2) - formula("4") * c2 * c0) * formula("V_0^2");
    let ratio = velocity_ratio(equations.equation(boundary));
    let product = formula(factor) * (formula("1") - ratio.clone().power(2));
    let says = format!(
        "discriminant times V0² for {case}, with L the ratio of V0 to the velocity of eq \
             {boundary}"
    );
    let proof = proof.identity(&says, &[quadratic, boundary], &discriminant, &product, domain)?;
    // The identity has L as a square: an equation that asks for a negative velocity satisfies it too.
    proof.positive(&format!("L for {case}, so that L = 1 at a velocity"), &[boundary], &ratio, domain)
}

/// left/right of an equation "ratio = 1": for eqs 18 and 20 the ratio of V0 to the velocity at which they hold.
pub(super) fn velocity_ratio(equation: &Equation) -> Expression {
    equation.left.clone() / equation.right.clone()
}
