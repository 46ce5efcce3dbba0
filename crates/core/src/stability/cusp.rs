//! The cusp of the boundary: the one point of the lower arc where all three roots of eq 8 coincide.

use std::cmp::Ordering;

use rug::{Float, Rational};

use crate::number::Ball;
use slipmode_algebra::{horner, polish};

/// x = −1 − r of the cusp of a given β: the only positive root of x³ = β(3x + 2). The relative radius is at most 2^−bits.
pub(crate) fn cusp_abscissa(effect_ratio: &Rational, bits: u32) -> Ball {
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

/// η of the cusp. For a < b a larger one excludes real roots left of −1, and with them every stable point without oscillation.
///
/// There β = (1 − 2η)³/(27η²) and x = (1 − 2η)/(3η).
#[must_use]
pub fn cusp_inertial_parameter(effect_ratio: &Rational, bits: u32) -> Ball {
    Ball::from(1) / (Ball::from(3) * cusp_abscissa(effect_ratio, bits) + Ball::from(2))
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
    use crate::roots::discriminant;
    use slipmode_algebra::UnivariatePolynomial;

    #[test]
    fn at_the_inertial_parameter_of_the_cusp_sturm_sequences_lose_two_roots() {
        for beta in [(3, 2), (11, 10), (5, 1), (1, 2)].map(Rational::from) {
            let bound = cusp_inertial_parameter(&beta, 100);
            let near = bound.centre().to_rational().unwrap();
            // κ where the discriminant is zero at this η: a quartic.
            let ends = |eta: Rational| {
                let value = |kappa: i32| {
                    let groups = Groups {
                        inertial_parameter: eta.clone(),
                        stiffness_group: Rational::from(kappa),
                        effect_ratio: beta.clone(),
                    };
                    discriminant(&groups.characteristic_cubic())
                };
                let line = UnivariatePolynomial::interpolating((0..5).map(value).collect());
                line.isolate_positive_roots().len()
            };
            let step = Rational::from((1, 1_000_000_000));
            assert_eq!((ends(near.clone() - &step), ends(near.clone() + &step)), (3, 1), "{beta}");
            assert_eq!(beta > 1, near < Rational::from((1, 8)));
            // 1/(2 + 6√β cos(arccos(1/√β)/3)) for β > 1.
            let root = beta.to_f64().sqrt();
            let closed = 1.0 / (2.0 + 6.0 * root * libm::cos(libm::acos(1.0 / root) / 3.0));
            assert!(beta < 1 || (closed - bound.to_f64()).abs() < 1e-14, "{beta}: {closed}");
        }
    }

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
