//! The least η that excludes real roots left of −1, and with them every stable point without oscillation for a < b.

use super::notation::formula;
use crate::number::{Ball, Rational};
use slipmode_algebra::{Domain, Expression, Symbol, UnivariatePolynomial};

/// S(η), positive for η below η_c and negative above.
const THRESHOLD: &str = "(1 - 2*eta)^3 - 27*beta*eta^2";

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
