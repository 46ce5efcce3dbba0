//! Parameters that the tests of this folder share.

use proptest::prelude::*;
use rug::Rational;

use crate::friction::Slider;

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
