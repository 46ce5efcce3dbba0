//! The cusp of the boundary: the one point of the lower arc where all three roots of eq 8 coincide.

use std::cmp::Ordering;

use rug::{Float, Rational};

use crate::number::Ball;
use slipmode_algebra::{horner, polish};

/// x = −1 − r of the cusp of a given β: the only positive root of x³ = β(3x + 2). The relative radius is at most 2^−bits.
#[must_use]
pub fn cusp_abscissa(effect_ratio: &Rational, bits: u32) -> Ball {
    let coefficients = |precision: u32| {
        let ratio = Ball::from_rational(effect_ratio, precision);
        vec![-(Ball::from(2) * &ratio), -(Ball::from(3) * ratio), Ball::from(0), Ball::from(1)]
    };
    let start = approximate_abscissa(effect_ratio);
    let radius = Float::with_val(START_BITS, &start) >> CERTAIN_START_BITS;
    let sign = |x: Float| horner(coefficients(2 * START_BITS), &Ball::exact(x)).sign();
    let (below, above) =
        (Float::with_val(START_BITS, &start - &radius), Float::with_val(START_BITS, &start + &radius));
    if sign(below) != Some(Ordering::Less) || sign(above) != Some(Ordering::Greater) {
        return Ball::unbounded(bits);
    }
    polish(&coefficients, Ball::new(start, radius * 2_u32), 2 * START_BITS, bits)
}

/// Precision of the start, in MPFR for its range of exponents.
const START_BITS: u32 = 64;

/// Relative bits of the start whose sign is certain.
const CERTAIN_START_BITS: u32 = 48;

/// Newton steps from above, which descend to the root and converge quadratically.
const MOST_STEPS: u32 = 16;

fn approximate_abscissa(effect_ratio: &Rational) -> Float {
    let ratio = Float::with_val(START_BITS, effect_ratio);
    // With c³ = 2β and x = √(3β) + c, x(x² − 3β) is at least c³: x is above the root.
    let mut x = Float::with_val(START_BITS, &ratio * 3_u32).sqrt()
        + Float::with_val(START_BITS, &ratio * 2_u32).cbrt();
    for _ in 0..MOST_STEPS {
        let square = Float::with_val(START_BITS, x.square_ref());
        let slope = Float::with_val(START_BITS, &square - &ratio) * 3_u32;
        let value = square * &x - (Float::with_val(START_BITS, &x * 3_u32) + 2_u32) * &ratio;
        let step = value / slope;
        let is_small = step.clone().abs() <= Float::with_val(START_BITS, &x) >> (START_BITS / 2);
        x -= step;
        if is_small {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::friction::Groups;

    proptest! {
        /// κ = (1+η)³/(27η²), β = (1−2η)³/(27η²), and the triple root r = −(1+η)/(3η), for 0 < η < 1/2.
        #[test]
        fn at_the_cusp_the_cubic_is_a_cube(numerator in 1_i64..5_000) {
            let eta = Rational::from((numerator, 10_001));
            let cube = |base: Rational| base.clone().square() * base / (Rational::from(27) * eta.clone().square());
            let groups = Groups {
                inertial_parameter: eta.clone(),
                stiffness_group: cube(Rational::from(1) + &eta),
                effect_ratio: cube(Rational::from(1) - Rational::from(2) * &eta),
            };
            let r = -(Rational::from(1) + &eta) / (Rational::from(3) * &eta);
            let [c0, c1, c2, c3] = groups.characteristic_cubic();
            prop_assert_eq!(c2, Rational::from(-3) * &r * &c3);
            prop_assert_eq!(c1, Rational::from(3) * r.clone().square() * &c3);
            prop_assert_eq!(c0, -(r.clone().square() * &r) * &c3);
            let found = cusp_abscissa(&groups.effect_ratio, 300);
            prop_assert!(found.contains(&(-r - 1)));
            prop_assert!(found.relative_radius_log2() < -300.0);
        }
    }
}
