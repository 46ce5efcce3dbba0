//! The stability transition K = K_c of eq 9.

use super::Equations;
use super::notation::{any, coefficients, formula, rational, stronger_direct_effect};
use super::root_location::positive_coefficients;
use slipmode_algebra::{Expression, Proof, Refutation, Symbol};

/// The system is stable exactly when K > K_c of eq 9, and a pair is imaginary exactly when K = K_c (claim S1).
///
/// # Errors
/// When eq 9 is not where eq 8's Hurwitz determinant vanishes.
pub fn stability(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "stability-transition",
        "All roots of eq 8 have negative real parts exactly when K > K_c (eq 9), two have \
             positive real parts exactly when K < K_c, and a pair is imaginary exactly when K = \
             K_c.",
    );
    let [c0, c1, c2, c3] = coefficients(&proof, &["8"], &equations.residual("8"), "s")?;
    let hurwitz = c2.clone() * c1 - c3.clone() * c0.clone();
    let margin = formula("a/(V_0*sigma)") * (formula("K") - equations.right("9"));
    let critical = critical_stiffness(&proof, &hurwitz)?;
    positive_coefficients(proof)?
        .positive("the cubic coefficient of eq 8", &["8"], &c3, &any())?
        .positive("the quadratic coefficient of eq 8", &["8"], &c2, &any())?
        .positive("the constant coefficient of eq 8", &["8"], &c0, &any())?
        .identity(
            "the stiffness at which c2 c1 − c3 c0 vanishes",
            &["8", "9"],
            &critical,
            &equations.right("9"),
            &any(),
        )?
        .identity("c2 c1 − c3 c0 is a positive factor times K − K_c", &["8", "9"], &hurwitz, &margin, &any())
}

/// The stiffness at which the Hurwitz determinant, linear in K, vanishes.
fn critical_stiffness(proof: &Proof, hurwitz: &Expression) -> Result<Expression, Refutation> {
    let function = rational(proof, &["8"], hurwitz, &any())?;
    let slope = function.derivative(&Symbol::from("K"));
    let rest = rational(proof, &["8"], &hurwitz.with("K", &formula("0")), &any())?;
    (-rest)
        .checked_div(&slope)
        .map(|critical| Expression::from(&critical))
        .ok_or_else(|| proof.refute("the Hurwitz determinant depends on K", &["8"], hurwitz.to_string()))
}

/// For a ≥ b there is no transition: K_c ≤ 0 and every K > 0 is stable (claim S5).
///
/// # Errors
/// When K_c can be positive.
pub fn intrinsically_stable(equations: &Equations) -> Result<Proof, Refutation> {
    let critical = equations.right("9");
    let proof = Proof::new(
        "intrinsically-stable",
        "For a ≥ b, K_c ≤ 0 < K at every normal stress and velocity: no transition, and all \
             roots have negative real parts.",
    )
    .using(stability(equations)?);
    proof.positive("−K_c for a > b", &["9"], &(-critical.clone()), &stronger_direct_effect())?.identity(
        "K_c for a = b",
        &["9"],
        &critical.with("b", &formula("a")),
        &formula("0"),
        &any(),
    )
}
