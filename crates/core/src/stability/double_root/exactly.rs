//! The double roots of an arc where 64-bit numbers do not decide: the roots of F over ℚ, isolated exactly.
//!
//! A root of F is a double root of eq 8. On the upper arc 1 + r is between 1 and √β, on the lower one x is above √β.
//! At the cusp F has a double root, which counts once.

use std::cmp::Ordering;

use rug::Rational;
use slipmode_algebra::{AlgebraicRoot, MOST_BITS, UnivariatePolynomial};

use super::GivenGroup;
use super::equation::coefficients;
use super::line::parameter_at;
use super::unknown::Factors;
use crate::number::{Ball, Real};
use crate::stability::Arc;

/// Bits of the first attempt beyond those requested.
const SPARE_BITS: u32 = 64;

/// The unknown group and λ at each point of an arc where κ or g is `value`, from the quasi-static end on, to 2^−bits.
pub(in crate::stability) fn exactly(
    (arc, given): (Arc, GivenGroup),
    value: &Rational,
    effect_ratio: &Rational,
    bits: u32,
) -> Vec<[Ball; 2]> {
    let excess = Rational::from(effect_ratio - 1_u32);
    let in_x = UnivariatePolynomial::new(coefficients(arc, given, value, effect_ratio, &excess));
    let from_end = vec![Rational::from(-effect_ratio), Rational::new(), Rational::from(1)];
    let from_end = UnivariatePolynomial::new(from_end);
    let (equation, place, on_arc) = match arc {
        Arc::Upper => {
            let in_next = (-1..4).map(|x| in_x.evaluate(&Rational::from(x))).collect();
            let from_ends = from_end.times(&UnivariatePolynomial::from_integers(&[-1, 1]));
            (UnivariatePolynomial::interpolating(in_next), from_ends, Ordering::Less)
        }
        Arc::Lower => (in_x, from_end, Ordering::Greater),
    };
    let point = |root: &AlgebraicRoot, precision: u32| {
        let [effect_ratio, excess, value] =
            [effect_ratio, &excess, value].map(|number| Ball::from_rational(number, precision));
        let root = root.enclosed(precision);
        let x = if arc == Arc::Upper { root - Ball::from(1) } else { root };
        let unknown = Factors::of(arc, x.clone(), &effect_ratio, &excess).unknown(given, &value);
        let inertial_parameter = given.inertial_parameter(&value, &unknown);
        [unknown, parameter_at(arc, x, inertial_parameter, &effect_ratio.sqrt())]
    };
    let to_bits = |root: &AlgebraicRoot| {
        let mut precision = bits + SPARE_BITS;
        loop {
            let found = point(root, precision);
            let is_known = found.iter().all(|ball| ball.relative_radius_log2() <= -f64::from(bits));
            if is_known || precision > MOST_BITS.max(bits.saturating_mul(64)) {
                return found;
            }
            precision *= 2;
        }
    };
    let roots = AlgebraicRoot::positive(&equation);
    roots.iter().filter(|root| root.sign_of(&place) == Some(on_arc)).map(to_bits).collect()
}
