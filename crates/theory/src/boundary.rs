//! The exact boundary max Im(s) = 0: a rational curve with one cusp.

use crate::notation::{coefficients, discriminant_of_cubic, formula, rational};
use crate::stated_proofs::stated_domain;
use crate::{Equations, Role};
use slipmode_algebra::{Domain, Expression, Polynomial, Proof, RationalFunction, Refutation, Symbol};

/// The parametrisation of the boundary by its double root r, as derived from eq 8.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Curve {
    /// η(r) in r and β.
    pub inertial_parameter: RationalFunction,
    /// κ(r) in r and β.
    pub stiffness_group: RationalFunction,
    /// The third root t(r) in r and β.
    pub third_root: RationalFunction,
}

/// Solves F(r) = F'(r) = 0 for η and κ, in which both are linear.
///
/// # Errors
/// When eq 8 is no cubic that is linear in η and κ.
pub fn curve(equations: &Equations) -> Result<Curve, Refutation> {
    let proof = Proof::new("boundary-curve", "");
    let value = equations.cubic().with("p", &formula("r"));
    let slope = value.derivative(&Symbol::from("r"));
    let cited = equations.numbers([Role::Characteristic]);
    let [inertial_parameter, stiffness_group] = solve_for_groups(&proof, &cited, [&value, &slope])?;
    let [_, _, c2, c3]: [Expression; 4] = coefficients(&proof, &cited, &equations.cubic(), "p")?;
    let sum = (Expression::integer(-1) * c2 / c3 - formula("2*r"))
        .with("eta", &Expression::from(&inertial_parameter))
        .with("kappa", &Expression::from(&stiffness_group));
    let at_double_root = stated_domain("double root");
    let third_root = rational(&proof, &cited, &sum, &at_double_root)?;
    Ok(Curve { inertial_parameter, stiffness_group, third_root })
}

/// η and κ at which two expressions that are linear in both are zero.
///
/// # Errors
/// When an expression is not linear, or the two do not determine η and κ.
pub(super) fn solve_for_groups(
    proof: &Proof,
    cited: &[&str],
    zeros: [&Expression; 2],
) -> Result<[RationalFunction; 2], Refutation> {
    let [first, second] = [linear_parts(proof, cited, zeros[0])?, linear_parts(proof, cited, zeros[1])?];
    let minor =
        |left: usize, right: usize| &(&first[left] * &second[right]) - &(&first[right] * &second[left]);
    let [determinant, eta, kappa] = [minor(0, 1), minor(1, 2), minor(2, 0)];
    let solved = eta.checked_div(&determinant).zip(kappa.checked_div(&determinant));
    solved.map(|(eta, kappa)| [eta, kappa]).ok_or_else(|| {
        proof.refute("η and κ of two equal roots or a pair are determined", cited, "the determinant vanishes")
    })
}

/// The coefficients of η and of κ, and the rest, of an expression linear in both.
fn linear_parts(
    proof: &Proof,
    cited: &[&str],
    expression: &Expression,
) -> Result<[RationalFunction; 3], Refutation> {
    let domain = Domain::default();
    let part = |name: &'static str| rational(proof, cited, &expression.derivative(&name.into()), &domain);
    let rest = expression.with("eta", &formula("0")).with("kappa", &formula("0"));
    let parts = [part("eta")?, part("kappa")?, rational(proof, cited, &rest, &domain)?];
    let linear = formula("0")
        + Expression::from(&parts[0]) * formula("eta")
        + Expression::from(&parts[1]) * formula("kappa");
    proof.clone().identity("linear in η and κ", cited, expression, &(linear + rest), &domain)?;
    Ok(parts)
}

/// The discriminant of F as a polynomial in η, κ, β.
///
/// # Errors
/// When eq 8 is no polynomial.
pub fn cubic_discriminant(equations: &Equations) -> Result<Polynomial, Refutation> {
    let proof = Proof::new("discriminant", "");
    let cited = equations.numbers([Role::Characteristic]);
    discriminant_of_cubic(&proof, &cited, &equations.cubic(), "p", &Domain::default())
}
