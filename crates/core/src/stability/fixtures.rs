//! Parameters that the tests of this folder share.

use proptest::prelude::*;
use rug::Rational;

use crate::friction::Slider;
use crate::number::Field;

/// The paper's slider (fig 1).
pub fn paper() -> Slider<Rational> {
    with_effects(Rational::from((4, 1000)), Rational::from((6, 1000)))
}

/// The paper's machine with other friction parameters a and b.
pub fn with_effects(direct_effect: Rational, evolution_effect: Rational) -> Slider<Rational> {
    Slider {
        direct_effect,
        evolution_effect,
        critical_slip_distance_m: Rational::from((1, 100_000)),
        stiffness_pa_per_m: Rational::from(10_000_000),
        mass_per_area_kg_per_m2: Rational::from(1000),
    }
}

/// Positive rationals over twelve decades.
pub fn positive_rational() -> impl Strategy<Value = Rational> {
    (1_i64..1_000_000, 1_i64..1_000_000).prop_map(Rational::from)
}

/// A double root of the boundary and β: both arcs, a < b and a > b (every r that is proposed lies on its arc).
pub fn double_root_and_effect_ratio() -> impl Strategy<Value = (Rational, Rational)> {
    let fraction = || (1_i64..1000, 1_i64..2000).prop_map(|(n, d)| Rational::from((n, n + d)));
    let lower = (positive_rational(), positive_rational()).prop_map(|(excess, beta)| {
        // r < −1 − √β, as √β ≤ (1 + β)/2.
        (-(excess + (beta.clone() + 3u32) / 2u32), beta)
    });
    let upper =
        (fraction(), positive_rational()).prop_filter("a = b has no upper arc", |(_, beta)| *beta != 1);
    let upper = upper.prop_map(|(fraction, beta)| {
        // 0 < r < √β − 1 or √β − 1 < r < 0, as √β − 1 = (β−1)/(√β+1) lies beyond (β−1)/(β+1) and below (β−1)/2.
        let divisor = if beta > 1 { Rational::from(&beta + 1) } else { Rational::from(2) };
        ((beta.clone() - 1u32) * fraction / divisor, beta)
    });
    prop_oneof![lower, upper]
}

/// η at which p = r is a double root of eq 8: η(r) = (β − (r+1)²)/(2r(r+1)²).
pub fn inertial_parameter<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    (effect_ratio.clone() - &square) / (R::from(2) * double_root * &square)
}

/// κ at which p = r is a double root of eq 8: κ(r) = r((2r+1)β − (r+1)²)/(2(r+1)²).
pub fn stiffness_group<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    double_root.clone() * (stretched(double_root, effect_ratio) - &square) / (R::from(2) * &square)
}

/// The third root next to the double root r: t(r) = ((2r+1)β − (r+1)²)/((r+1)² − β).
pub fn third_root<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    (stretched(double_root, effect_ratio) - &square) / (square - effect_ratio)
}

/// (2r+1)β.
fn stretched<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    (R::from(2) * double_root + R::from(1)) * effect_ratio
}

mod tests {
    use super::*;
    use crate::friction::Groups;

    proptest! {
        #[test]
        fn the_cubic_on_the_curve_is_the_product_of_its_factors(
            numerator in -400_i32..400, denominator in 1_i32..50, beta in 1_i32..4_000,
        ) {
            let r = Rational::from((numerator, denominator));
            let beta = Rational::from((beta, 100));
            let shifted = Rational::from(&r + 1).square();
            prop_assume!(r != 0 && shifted != 0 && shifted != beta);
            let t = third_root(&r, &beta);
            let groups = Groups {
                inertial_parameter: inertial_parameter(&r, &beta),
                stiffness_group: stiffness_group(&r, &beta),
                effect_ratio: beta,
            };
            let [c0, c1, c2, c3] = groups.characteristic_cubic();
            // (p − r)²(p − t)·η, coefficient by coefficient.
            prop_assert_eq!(c0, -(r.clone().square() * &t) * &c3);
            prop_assert_eq!(c1, (r.clone().square() + Rational::from(2) * &r * &t) * &c3);
            prop_assert_eq!(c2, -(Rational::from(2) * &r + &t) * &c3);
        }
    }
}
