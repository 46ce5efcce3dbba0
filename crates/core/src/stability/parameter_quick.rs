//! One root of an equation for λ in a few microseconds: 64-bit, one double-double step, one certified Newton step.
//!
//! The last step is the interval Newton test on a ball around the double-double root: when the image lies inside, the
//! ball holds exactly one root and the image encloses it, whatever the two steps before were worth.

use std::cmp::Ordering;

use rug::Float;

use crate::number::{Ball, Dd};
use crate::polynomial::newton;
use crate::stability::Arc;

/// The double-double root is trusted to 2^−PROVISIONAL_BITS of itself; the Newton test finds out.
const PROVISIONAL_BITS: u32 = 97;

/// How far, relative to the terms compared, two 64-bit numbers must lie apart for their order to be certain here: the
/// roundings before it are some dozens, each of 1.1e-16.
const MARGIN: f64 = 1e-12;

/// Newton steps in 64-bit before giving up; each at least halves the logarithmic bracket or converges quadratically.
const MOST_STEPS: u32 = 100;

/// λ of the places on an arc, descending, each with a relative radius of at most 2^−bits, for one root on each branch that is
/// well separated.
///
/// `quasi_static_branch` says whether the branch of the lower arc above the cusp's λ has a root wherever the other one has.
/// None when 64-bit cannot follow (range, or signs that it does not see) or the precision is not reached; the caller then
/// takes the general way.
pub(super) fn quick_roots(
    arc: Arc,
    coefficients: &[Ball],
    quasi_static_branch: bool,
    cusp: f64,
    bits: u32,
) -> Option<Vec<Ball>> {
    let rounded: Vec<f64> = coefficients.iter().map(Ball::to_f64).collect();
    let (low, high) = positive_range(&rounded)?;
    let root = |lower, upper| certified_root(coefficients, root_in_f64(&rounded, lower, upper)?, bits);
    if arc == Arc::Upper {
        return Some(vec![root(low, high)?]);
    }
    if certain_sign(&rounded, cusp)? == Ordering::Greater {
        return Some(Vec::new());
    }
    let mut roots = Vec::with_capacity(2);
    if quasi_static_branch {
        let above = root(cusp, high)?;
        (order(above.to_f64(), cusp)? == Ordering::Greater).then(|| roots.push(above))?;
    }
    let below = root(low, cusp)?;
    (order(below.to_f64(), cusp)? == Ordering::Less).then(|| roots.push(below))?;
    Some(roots)
}

/// Which of two positive numbers is larger, when that is clear.
pub(super) fn order(one: f64, other: f64) -> Option<Ordering> {
    // Written so that what is not a number has no order.
    ((one - other).abs() > MARGIN * (one + other)).then(|| one.total_cmp(&other))
}

/// The sign of the polynomial at x > 0, when it is beyond the rounding of its terms.
fn certain_sign(coefficients: &[f64], x: f64) -> Option<Ordering> {
    let terms = |(value, size): (f64, f64), c: &f64| (value * x + c, size * x + c.abs());
    let (value, size) = coefficients.iter().rev().fold((0.0, 0.0), terms);
    (value.abs() > MARGIN * size).then(|| value.total_cmp(&0.0))
}

/// The root next to a 64-bit one, to a relative radius of 2^−bits; none when that is not reached.
fn certified_root(coefficients: &[Ball], start: f64, bits: u32) -> Option<Ball> {
    let provisional = step_in_double_double(coefficients, start)?;
    let centre = Float::with_val(PROVISIONAL_BITS + 16, provisional.hi()) + provisional.lo();
    let radius = Float::with_val(32, provisional.hi()) >> PROVISIONAL_BITS;
    let enclosure = Ball::new(centre, radius);
    let image = newton(coefficients, &enclosure);
    let inside = image.is_bounded() && image.lower() > enclosure.lower() && image.upper() < enclosure.upper();
    (inside && image.relative_radius_log2() <= -f64::from(bits)).then_some(image)
}

/// Bounds of all positive roots in 64-bit (Cauchy's, for the polynomial and its reverse).
fn positive_range(coefficients: &[f64]) -> Option<(f64, f64)> {
    let largest = coefficients.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let (first, last) = (coefficients.first()?.abs(), coefficients.last()?.abs());
    let range = (first / (first + largest), 1.0 + largest / last);
    (range.0 > 1e-100 && range.1 < 1e100).then_some(range)
}

/// Newton's method on ln λ, kept inside a bracket that halves when a step leaves it.
fn root_in_f64(coefficients: &[f64], mut lower: f64, mut upper: f64) -> Option<f64> {
    let at_lower = value_and_slope(coefficients, lower).0;
    let at_upper = value_and_slope(coefficients, upper).0;
    let opposite = at_lower < 0.0 && at_upper > 0.0 || at_lower > 0.0 && at_upper < 0.0;
    if !opposite {
        return None;
    }
    let mut x = (lower * upper).sqrt();
    for _ in 0..MOST_STEPS {
        let (value, slope) = value_and_slope(coefficients, x);
        *(if (value < 0.0) == (at_lower < 0.0) { &mut lower } else { &mut upper }) = x;
        let next = x - value / slope;
        // A linear step is right next to the root; far from it the middle of the logarithms is as good as any.
        let next = if next > lower && next < upper { next } else { (lower * upper).sqrt() };
        let moved = (next - x).abs();
        x = next;
        if moved <= 1e-14 * x {
            return Some(x);
        }
    }
    None
}

fn value_and_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value))
}

/// x − f(x)/f′(x) with f in double-double.
fn step_in_double_double(coefficients: &[Ball], x: f64) -> Option<Dd> {
    let at = Dd::from(x);
    let zero = Dd::from(0.0);
    let (value, slope) = coefficients.iter().rev().fold((zero, zero), |(value, slope), coefficient| {
        let leading = coefficient.to_f64();
        let trailing = Float::with_val(64, coefficient.centre() - leading).to_f64();
        (value * at + Dd::exact_sum(leading, trailing), slope * at + value)
    });
    let next = at - value / slope;
    next.is_finite().then_some(next)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;

    fn coefficients(values: &[i32]) -> Vec<Ball> {
        values.iter().map(|value| Ball::from(*value).with_precision(200)).collect()
    }

    fn on_upper_arc(coefficients: &[Ball], bits: u32) -> Option<Vec<Ball>> {
        quick_roots(Arc::Upper, coefficients, true, 1.0, bits)
    }

    #[test]
    fn the_square_root_of_two_is_certified_to_190_bits() {
        let polynomial = coefficients(&[-2, 0, 1]);
        let root = on_upper_arc(&polynomial, 185).unwrap().remove(0);
        assert!((root.square() - Ball::from(2)).contains_zero());
        assert!(root.relative_radius_log2() <= -185.0);
    }

    #[test]
    fn without_a_change_of_sign_or_without_the_precision_there_is_no_answer() {
        assert!(on_upper_arc(&coefficients(&[1, 0, 1]), 100).is_none());
        assert!(on_upper_arc(&coefficients(&[-2, 0, 1]), 400).is_none());
        // A triple root: Newton's test cannot hold.
        assert!(on_upper_arc(&coefficients(&[-1, 3, -3, 1]), 100).is_none());
    }
}
