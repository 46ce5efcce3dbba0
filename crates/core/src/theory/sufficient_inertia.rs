//! The least η that excludes real roots left of −1, and with them every stable point without oscillation for a < b.

use super::Equations;
use super::areas::Effects;
use super::notation::{cubic, formula, given_positive, in_parameters};
use super::real_roots::{below_minus_one, by_roots, case};
use crate::number::{Ball, Rational};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol, Toward, UnivariatePolynomial};

/// S(η), positive for η below η_c and negative above.
const THRESHOLD: &str = "(1 - 2*eta)^3 - 27*beta*eta^2";

/// Adds that three roots left of −1 exist exactly for η ≤ η_c, and what η_c is.
///
/// # Errors
/// When eq 8 does not have the form that the bound rests on.
pub(super) fn sharp_bound(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let threshold = formula(THRESHOLD);
    let between = cubic(equations).with("p", &formula("-1/(1 + e)"));
    let excess = formula("(x_1 + x_2 + x_3)^3 - 27*x_1*x_2*x_3");
    let squares = formula(
        "(x_1 + x_2 + x_3)/2*((x_1 - x_2)^2 + (x_2 - x_3)^2 + (x_3 - x_1)^2) \
         + 3*(x_1*(x_2 - x_3)^2 + x_2*(x_3 - x_1)^2 + x_3*(x_1 - x_2)^2)",
    );
    let below_half = given_positive(Domain::positive("beta eta"), "1 - 2*eta", &[("eta", "1/8")]);
    let below_half = in_parameters(below_half, &[("eta", "1/(2*(1 + e))", "e", "(1 - 2*eta)/(2*eta)")]);
    let slope = threshold.derivative(&Symbol::from("eta"));
    let proof = by_roots(proof, equations)?
        .positive(
            "F for a < b and −1 < p < 0: real roots of a stable point are left of −1",
            &["8"],
            &between,
            &case(Effects::Weakening).and_positive("eta kappa e"),
        )?
        .identity(
            "S/η³ with S = (1 − 2η)³ − 27βη², by three roots left of −1",
            &[],
            &(threshold.clone() / formula("eta^3")),
            &excess,
            &below_minus_one(),
        )?
        .identity(
            "it is a sum of squares times positive numbers: S ≥ 0",
            &[],
            &excess,
            &squares,
            &Domain::default(),
        )?
        .negative("dS/dη for η < 1/2: S = 0 at one η_c < 1/2, and η ≤ η_c", &[], &slope, &below_half)?;
    closed_form(existence(proof)?, &threshold)
}

/// For each η < η_c two equal roots left of −1, and a third one, exist for some κ.
fn existence(proof: Proof) -> Result<Proof, Refutation> {
    let relation = formula("y^2*(3*x + w - 2*y) - x^3/(3*x + 2)*(3*x + 2 + w)");
    let ends = [formula("0"), formula("x + w/3")];
    proof.root(
        "with β = x³/(3x + 2) and η = 1/(3x + 2 + w) < η_c: x_1 = x_2 = y and x_3 = 3x + w − 2y > y solve \
             x_1 x_2 x_3 = β/η",
        &[],
        (&relation, "y"),
        [Some(&ends[0]), Some(&ends[1])],
        &Domain::positive("x w"),
    )
}

/// η_c = 1/(3x + 2) with x³ = β (3x + 2), by a cosine, and its limit 1/8 for a < b.
fn closed_form(proof: Proof, threshold: &Expression) -> Result<Proof, Refutation> {
    let beta = formula("x^3/(3*x + 2)");
    let at_cusp = Domain::positive("x").with("eta", formula("1/(3*x + 2)")).with("beta", beta.clone());
    let bound = formula("1/(3*x + 2)").with("x", &formula("2 + g"));
    let excess = beta.with("x", &formula("2 + g")) - formula("1");
    let positive = Domain::positive("g");
    proof
        .identity(
            "S = 0 for η = 1/(3x + 2), β = x³/(3x + 2): the cusp",
            &[],
            threshold,
            &formula("0"),
            &at_cusp,
        )?
        .identity(
            "x = 2wC with w = √β solves x³ = β (3x + 2) for 4C³ − 3C = cos(3 arccos C) = 1/w",
            &[],
            &formula("x^3 - beta*(3*x + 2)").with("beta", &formula("w^2")).with("x", &formula("2*w*C")),
            &formula("2*w^3*(4*C^3 - 3*C - 1/w)"),
            &Domain::positive("w"),
        )?
        .positive("β − 1 for x = 2 + g: β > 1 is x > 2", &[], &excess, &positive)?
        .positive("1/8 − η_c there", &[], &(formula("1/8") - bound.clone()), &positive)?
        .limit("η_c as b/a → 1", &[], &bound, ("g", Toward::Zero), &formula("1/8"), &positive)
}

/// η_c at this b/a, with a relative radius of at most 2^−bits.
#[must_use]
pub fn sufficient_inertial_parameter(effect_ratio: &Rational, bits: u32) -> Option<Ball> {
    let threshold = formula(THRESHOLD).with("beta", &Expression::Number(effect_ratio.clone()));
    let function = Domain::default().rational_function(&threshold).ok()?;
    let coefficients = function.numerator().coefficients(&Symbol::from("eta"));
    let coefficients: Option<Vec<Rational>> = coefficients.iter().map(|value| value.as_constant()).collect();
    let polynomial = UnivariatePolynomial::new(coefficients?);
    let root = polynomial.isolate_positive_roots().into_iter().next()?;
    Some(polynomial.refine(&root, bits))
}
