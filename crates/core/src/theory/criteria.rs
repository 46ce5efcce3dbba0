//! The criterion η > 1 for vibration.

use super::boundary::cubic_discriminant;
use super::notation::{formula, in_groups};
use super::sufficient_inertia::sharp_bound;
use super::{Equations, transition};
use slipmode_algebra::{Certificate, Domain, Expression, Proof, Refutation, Symbol};

/// η > 1 as a criterion of underdamped oscillation: where it is sufficient, and that it is not necessary (claim Z2).
///
/// # Errors
/// When eq 8 has another discriminant.
pub fn inertial_parameter(equations: &Equations) -> Result<Proof, Refutation> {
    let margin = formula("kappa") - in_groups(&equations.right("9"));
    let oscillates_without = [("beta", "3/2"), ("eta", "1/10"), ("kappa", "1")];
    let real_though_above = [("beta", "1/2"), ("eta", "2"), ("kappa", "1/50")];
    let real_unstable = [("beta", "3/2"), ("eta", "2"), ("kappa", "1/100")];
    let proof = Proof::new(
        "inertial-parameter-criterion",
        "In the stable zone of a < b all roots are real for some κ exactly for η ≤ η_c: η > η_c is sufficient for a \
             complex pair, and no smaller bound is. η_c is the root of (1 − 2η)³ = 27βη², which is \
             1/(2 + 6√β cos(arccos(1/√β)/3)) for β = b/a > 1. It is less than 1/8 and tends to 1/8 as b/a → 1, so η ≥ 1/8 is \
             sufficient for all a < b. η > 1 is not sufficient in the upper real area, which exists at every η for a ≠ b.",
    )
    .using(transition::stability(equations)?);
    let proof = sharp_bound(proof, equations)?;
    let proof = at_point(
        proof,
        "K − K_c (in units of aσ/D_c) at a stable point with η = 1/10",
        &margin,
        &oscillates_without,
    )?;
    let discriminant = Expression::from(&cubic_discriminant(equations)?);
    let proof = at_point(
        proof,
        "discriminant there: negative, a complex pair without η > 1",
        &discriminant,
        &oscillates_without,
    )?;
    let proof = at_point(
        proof,
        "discriminant for a > b at η = 2: positive, all roots real",
        &discriminant,
        &real_though_above,
    )?;
    at_point(
        proof,
        "discriminant for a < b at η = 2: positive, all roots real (and K < K_c)",
        &discriminant,
        &real_unstable,
    )
}

/// Adds the exact value of an expression at a rational point, whose sign the step's words name.
fn at_point(
    proof: Proof,
    says: &str,
    expression: &Expression,
    point: &[(&'static str, &str)],
) -> Result<Proof, Refutation> {
    let negative = says.contains("negative");
    let point: Vec<_> = point.iter().map(|(name, value)| (Symbol::from(*name), formula(value))).collect();
    let values = point.iter().cloned().collect();
    let value =
        super::notation::rational(&proof, &["8"], &expression.substitute(&values), &Domain::default())?;
    let sign = if negative { -1 } else { 1 };
    if value.coefficient_sign() != Some(sign) {
        return Err(proof.refute(says, &["8", "9"], format!("the value is {}", Expression::from(&value))));
    }
    let certificate =
        Certificate::Value { expression: expression.clone(), point, value: Expression::from(&value) };
    proof.certify(says, &["8", "9"], certificate)
}
