//! A certified enclosure of one real root of y³ + Py + Q, to any precision.
//!
//! Newton's iteration doubles its precision from a 64-bit start; the last step is done in balls (an interval Newton step):
//! when its result lies inside the interval it started from, a root exists there and is enclosed.

use rug::{Float, Integer};

use super::depressed::Depressed;
use crate::number::{Ball, Field};

/// Correct bits of the 64-bit start, relative to 2^k: its Newton iteration ends within a few units of 2^-53.
const START_BITS: u32 = 44;

/// Bits by which each doubling may fall short of twice the accuracy: f''/(2f') is at most 2^3 in the scaled variable.
const DOUBLING_LOSS: u32 = 4;

/// Steps after which the enclosure is given up; quadratic convergence needs far fewer.
const MAX_REPAIRS: u32 = 64;

/// A ball around the outermost real root y of the depressed cubic, with an absolute error of about 2^(k − bits).
///
/// The enclosure is unbounded if it cannot be certified, which the conditioning of that root excludes.
pub(super) fn outermost_real_root(depressed: &Depressed, bits: u32) -> Ball {
    let scale = depressed.scale_log2();
    let mut root = Float::with_val(53, scaled_start(depressed, scale)) << scale;
    for accuracy in accuracies(bits) {
        newton_step(depressed, &mut root, accuracy);
    }
    let half = bits / 2 + DOUBLING_LOSS;
    for _ in 0..MAX_REPAIRS {
        if let Some(enclosure) = interval_newton_step(depressed, &root, half, bits, scale) {
            return enclosure;
        }
        newton_step(depressed, &mut root, half);
    }
    Ball::unbounded(bits)
}

/// The accuracies of the steps before the last, ascending: each about half of the next, the last half of `bits`.
fn accuracies(bits: u32) -> impl Iterator<Item = u32> {
    let before = |accuracy: u32| accuracy / 2 + DOUBLING_LOSS;
    let falling = std::iter::successors(Some(before(bits)), |next| Some(before(*next)));
    let falling: Vec<u32> = falling.take_while(|accuracy| *accuracy > START_BITS).collect();
    falling.into_iter().rev()
}

/// One Newton step to this many correct bits; the derivative and the quotient need only half of them.
fn newton_step(depressed: &Depressed, root: &mut Float, accuracy: u32) {
    let precision = accuracy + 8;
    let half = precision / 2 + 8;
    let square = root.square_ref();
    let mut value = Float::with_val(precision, square);
    let mut slope = Float::with_val(half, &value * 3u32);
    value += &depressed.linear;
    value *= &*root;
    value += &depressed.constant;
    slope += &depressed.linear;
    value.set_prec(half);
    value /= &slope;
    root.set_prec(precision);
    *root -= value;
}

/// Y − f(y)/f'(Y) for the ball Y of radius 2^(k − half + 2) around y: a certified enclosure if it lies within Y.
fn interval_newton_step(
    depressed: &Depressed,
    root: &Float,
    half: u32,
    bits: u32,
    scale: i32,
) -> Option<Ball> {
    let precision = bits + 8;
    let coarse = half + 8;
    let ball = |value: &Integer, bits: u32| Ball::from_short_integer(value, bits);
    let radius = Float::with_val(32, 1) << (scale + 2 - half as i32);
    let square = Ball::exact(Float::with_val(2 * root.prec(), root.square_ref()));
    let value = (square.with_precision(precision) + ball(&depressed.linear, precision))
        * Ball::exact(root.clone())
        + ball(&depressed.constant, precision);
    let interval = Ball::new(root.clone(), radius.clone()).with_precision(coarse);
    let slope = interval.square() * Ball::from(3) + ball(&depressed.linear, coarse);
    let correction = value.with_precision(coarse) / slope;
    // |correction| ≤ radius at every point means that y − correction lies within Y.
    let reach = correction.centre().clone().abs() + correction.radius();
    (reach < radius).then(|| Ball::exact(root.clone()).with_precision(precision) - correction)
}

/// The outermost real root of the cubic in y/2^k, in 64-bit.
fn scaled_start(depressed: &Depressed, scale: i32) -> f64 {
    let scaled = |value: &Integer, shift: i32| {
        let (mantissa, exponent) = Float::with_val(53, value).to_f64_exp();
        libm::ldexp(mantissa, exponent - shift)
    };
    outermost_root_f64(scaled(&depressed.linear, 2 * scale), scaled(&depressed.constant, 3 * scale))
}

/// The real root of y³ + py + q farthest from zero, for |p|, |q| ≤ 1: Newton's iteration from outside, where it is monotone.
pub(super) fn outermost_root_f64(p: f64, q: f64) -> f64 {
    let magnitude = q.abs();
    let start =
        if p > 0.0 { libm::cbrt(magnitude).min(magnitude / p) } else { (-p).sqrt() + libm::cbrt(magnitude) };
    // Rounding ends the descent; an underflow to 0/0 ends it too, as no comparison with it holds.
    let (mut root, mut next) = (f64::INFINITY, start);
    while next < root {
        root = next;
        next = root - ((root * root + p) * root - magnitude) / (3.0 * root * root + p);
    }
    if q > 0.0 { -root } else { root }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_64_bit_start_is_as_good_as_assumed(p in -1.0f64..1.0, q in -1.0f64..1.0, e in 0i32..40) {
            let q = libm::ldexp(q, -e);
            let root = outermost_root_f64(p, q);
            let (p, q, y) = (Float::with_val(200, p), Float::with_val(200, q), Float::with_val(200, root));
            let value = (y.clone().square() + &p) * &y + &q;
            let slope = y.square() * 3u32 + &p;
            prop_assume!(!slope.is_zero());
            prop_assert!((value / slope).abs() < libm::exp2(-f64::from(START_BITS)));
        }
    }
}
