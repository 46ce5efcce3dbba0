//! Bounds under the largest errors of the coefficients that they allow for: the true roots still lie within them.
//!
//! Rounding alone seldom comes near a bound, so that a bound without one of its terms would pass; an error of the
//! coefficients, every sign of it tried, comes as near as first order allows.

use proptest::prelude::*;

use super::{Bounded, BoundedCubic, BranchlessRoots, Pair, Spectrum, Working};
use crate::number::Dd;

/// So much larger than rounding that each part of a bound is due to it, so small that its square is not seen.
const DATA_ERROR: f64 = 1e-9;

/// Covers the rounding of the cubic's coefficients and of the comparison.
const ROUNDED: f64 = 1e-6 * DATA_ERROR;

/// The roots that a cubic was made of.
#[derive(Debug, Clone, Copy)]
enum True {
    Real([f64; 3]),
    Complex { real: f64, re: f64, im: f64 },
}

impl True {
    fn cubic(self, lead: f64) -> [f64; 4] {
        let (t, sum, product) = match self {
            Self::Real([t, one, other]) => (t, one + other, one * other),
            Self::Complex { real, re, im } => (real, 2.0 * re, re * re + im * im),
        };
        [-lead * t * product, lead * (product + t * sum), -lead * (t + sum), lead]
    }
}

/// The cubic with each coefficient off by all that it may be, up or down as the bits of `signs` say.
fn disturbed<R: Working>(cubic: [f64; 4], signs: u32) -> BoundedCubic<R> {
    let off = |power: usize| if signs >> power & 1 == 1 { DATA_ERROR } else { -DATA_ERROR };
    let coefficients = std::array::from_fn(|power| cubic[power] * (1.0 + off(power)));
    BoundedCubic {
        coefficients: coefficients.map(R::from),
        magnitudes: coefficients.map(|value| value.abs() * (1.0 + 2.0 * DATA_ERROR)),
        relative_error: DATA_ERROR + ROUNDED,
    }
}

fn holds<R: Working>(bounded: &Bounded<R>, value: f64) -> bool {
    (bounded.value.leading() - value).abs() <= bounded.error + ROUNDED * value.abs()
}

/// Whether the bounds hold; none where the pair is left open.
fn hold<R: Working>(found: &Spectrum<R>, roots: True) -> Option<bool> {
    let all = match (found.pair, roots) {
        (Pair::NotSeparated, _) => return None,
        (Pair::Real(pair), True::Real(roots)) => {
            let mut found = [pair[0], pair[1], found.real];
            let mut roots = roots;
            found.sort_by(|one, other| one.value.leading().total_cmp(&other.value.leading()));
            roots.sort_by(f64::total_cmp);
            found.iter().zip(roots).all(|(found, root)| holds(found, root))
        }
        (Pair::Complex { re: found_re, im: found_im }, True::Complex { real, re, im }) => {
            holds(&found.real, real) && holds(&found_re, re) && holds(&found_im, im)
        }
        _ => false,
    };
    Some(all)
}

/// The same roots as an enumeration.
fn spectrum(found: BranchlessRoots) -> Spectrum<Dd> {
    let BranchlessRoots { real, first, second, sign } = found;
    let pair = if sign > 0.0 {
        Pair::Real([first, second])
    } else if sign < 0.0 {
        Pair::Complex { re: first, im: second }
    } else {
        Pair::NotSeparated
    };
    Spectrum { real, pair }
}

/// By division and by the depressed cubic.
fn branchless(cubic: &BoundedCubic<Dd>) -> [Spectrum<Dd>; 2] {
    [cubic.roots_by_deflation(), cubic.roots_by_shift()].map(spectrum)
}

fn size() -> impl Strategy<Value = f64> {
    (1.0f64..10.0, -4i32..5, prop::bool::ANY).prop_map(
        |(digits, power, minus)| if minus { -digits } else { digits } * libm::exp10(f64::from(power)),
    )
}

fn roots() -> impl Strategy<Value = True> {
    let pair = (size(), size(), size());
    prop_oneof![
        prop::array::uniform3(size()).prop_map(True::Real),
        pair.prop_map(|(real, re, im)| True::Complex { real, re, im: im.abs() }),
    ]
}

proptest! {
    #[test]
    fn bounds_hold_when_every_coefficient_is_off_by_all_that_it_may_be(
        roots in roots(), lead in prop_oneof![0.1f64..10.0, -10.0f64..-0.1],
    ) {
        for signs in 0..16 {
            let cubic = roots.cubic(lead);
            let in_64_bits = hold(&disturbed::<f64>(cubic, signs).spectrum(), roots);
            let in_double_double = hold(&disturbed::<Dd>(cubic, signs).spectrum(), roots);
            prop_assert!(in_64_bits != Some(false) && in_double_double != Some(false), "signs {signs:04b}");
            for found in branchless(&disturbed(cubic, signs)) {
                prop_assert!(hold(&found, roots) != Some(false), "signs {signs:04b} {found:?}");
            }
        }
    }
}

#[test]
fn roots_a_decade_apart_are_told_apart_in_spite_of_the_errors() {
    for roots in [True::Real([3.0, 40.0, -500.0]), True::Complex { real: 3.0, re: -40.0, im: 20.0 }] {
        for signs in 0..16 {
            assert_eq!(hold(&disturbed::<f64>(roots.cubic(-2.0), signs).spectrum(), roots), Some(true));
            assert_eq!(hold(&disturbed::<Dd>(roots.cubic(2.0), signs).spectrum(), roots), Some(true));
            for found in branchless(&disturbed(roots.cubic(2.0), signs)) {
                assert_eq!(hold(&found, roots), Some(true));
                assert!(found.real.error < 1e-5 * found.real.value.hi().abs(), "{found:?}");
            }
        }
    }
}

/// The error of a sum is at most its units of the sum of the terms' magnitudes: here by hand, |x| = 11 and reach 13.
#[test]
fn evaluation_errors_are_sums_of_magnitudes() {
    let cubic = BoundedCubic::<f64> {
        coefficients: [2.0, -3.0, 5.0, -7.0],
        magnitudes: [2.0, 3.0, 5.0, 7.0],
        relative_error: DATA_ERROR,
    };
    let [value, slope, curvature] = cubic.evaluation_errors(-11.0, 13.0);
    for (bound, exact) in [
        (value / DATA_ERROR, 7.0 * 1331.0 + 5.0 * 121.0 + 3.0 * 11.0 + 2.0),
        (slope / DATA_ERROR, 21.0 * 121.0 + 10.0 * 11.0 + 3.0),
        (curvature, 42.0 * 24.0 + 10.0),
    ] {
        assert!((1.0..1.1).contains(&(bound / exact)), "{bound} of {exact}");
    }
}

/// Δ's five terms of 2, 3, 5 and 7, by hand: 18·210, 225, 4·(125·2 + 27·7) and 27·196.
#[test]
fn the_magnitudes_of_the_discriminants_terms_are_summed() {
    let sum = super::discriminant_of_magnitudes(&[2.0, 3.0, 5.0, 7.0]);
    assert_eq!(sum.to_bits(), f64::to_bits(3780.0 + 225.0 + 1756.0 + 5292.0));
}
