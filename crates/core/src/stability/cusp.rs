//! The cusp of the boundary: the one point of the lower arc where all three roots of eq 8 coincide.

use std::cmp::Ordering;

use rug::{Float, Rational};

use crate::friction::Groups;
use crate::number::{Ball, Field};
use crate::polynomial::{horner, polish};

/// κ of the cusp at η: κ = (1+η)³/(27η²).
#[must_use]
pub fn stiffness_group<R: Field>(inertial_parameter: &R) -> R {
    let base = R::from(1) + inertial_parameter;
    base.square() * &base / (R::from(27) * inertial_parameter.square())
}

/// The triple root at η: r = −(1+η)/(3η).
#[must_use]
pub fn triple_root<R: Field>(inertial_parameter: &R) -> R {
    -((R::from(1) + inertial_parameter) / (R::from(3) * inertial_parameter))
}

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

/// The cusp of a given β, enclosed: the groups and the triple root.
///
/// With x of [`cusp_abscissa`] η = 1/(3x + 2), which solves (1−2η)³ = 27βη². The relative radius of each number is at most 2^−bits.
#[must_use]
pub fn cusp(effect_ratio: &Rational, bits: u32) -> (Groups<Ball>, Ball) {
    let bits = bits.saturating_add(8);
    let abscissa = cusp_abscissa(effect_ratio, bits);
    let inertial_parameter = Ball::from(1) / (Ball::from(3) * &abscissa + Ball::from(2));
    let groups = Groups {
        stiffness_group: stiffness_group(&inertial_parameter),
        effect_ratio: Ball::from_rational(effect_ratio, bits),
        inertial_parameter,
    };
    (groups, -(abscissa + Ball::from(1)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// β of the cusp at η: β = (1−2η)³/(27η²), 0 < η < 1/2.
    fn effect_ratio(inertial_parameter: &Rational) -> Rational {
        let base = Rational::from(1) - Rational::from(2) * inertial_parameter;
        base.clone().square() * &base / (Rational::from(27) * inertial_parameter.clone().square())
    }

    #[test]
    fn at_equal_effects_the_cusp_is_rational() {
        let eta = Rational::from((1, 8));
        assert_eq!(effect_ratio(&eta), 1);
        assert_eq!(stiffness_group(&eta), Rational::from((27, 8)));
        assert_eq!(triple_root(&eta), -3);
        let (groups, root) = cusp(&Rational::from(1), 200);
        assert!(groups.inertial_parameter.contains(&eta) && root.contains(&Rational::from(-3)));
    }

    proptest! {
        #[test]
        fn at_the_cusp_the_cubic_is_a_cube(numerator in 1_i64..5_000) {
            let eta = Rational::from((numerator, 10_001));
            let groups = Groups {
                inertial_parameter: eta.clone(),
                stiffness_group: stiffness_group(&eta),
                effect_ratio: effect_ratio(&eta),
            };
            let r = triple_root(&eta);
            let [c0, c1, c2, c3] = groups.characteristic_cubic();
            prop_assert_eq!(c2, Rational::from(-3) * &r * &c3);
            prop_assert_eq!(c1, Rational::from(3) * r.clone().square() * &c3);
            prop_assert_eq!(c0, -(r.clone().square() * &r) * &c3);
            let (found, _) = cusp(&groups.effect_ratio, 300);
            prop_assert!(found.inertial_parameter.contains(&eta));
            prop_assert!(found.inertial_parameter.relative_radius_log2() < -300.0);
        }
    }
}
