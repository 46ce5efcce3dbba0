//! Error bounds of roots against certified roots.

use super::*;
use crate::number::{Dd, Rational};
use crate::roots::certified_roots;
use proptest::prelude::*;
use rug::Float;

/// A coefficient between 1e-12 and 1e12, either sign.
fn coefficient() -> impl Strategy<Value = f64> {
    (-12.0f64..12.0, prop::bool::ANY).prop_map(|(e, negative)| {
        let value = libm::exp10(e);
        if negative { -value } else { value }
    })
}

/// Checks every bound against the certified roots, and returns whether the pair was separated.
fn assert_bounds_hold<R: Copy>(cubic: [f64; 4], found: &Spectrum<R>, exactly: impl Fn(R) -> Float) -> bool {
    let exact = certified_roots(&cubic.map(|c| Rational::from_f64(c).unwrap()), 60);
    let holds = |bounded: &Bounded<R>, part: &Float| {
        Float::with_val(250, exactly(bounded.value) - part).abs() <= bounded.error
    };
    let is_real =
        |bounded: &Bounded<R>| exact.roots.iter().any(|root| root.im.is_zero() && holds(bounded, &root.re));
    assert!(is_real(&found.real), "{cubic:?}");
    match &found.pair {
        Pair::Real(roots) => {
            assert!(exact.discriminant_sign > 0 && roots.iter().all(is_real), "{cubic:?}")
        }
        Pair::Complex { re, im } => {
            assert!(exact.discriminant_sign < 0, "{cubic:?}");
            assert!(holds(re, &exact.roots[2].re) && holds(im, &exact.roots[2].im), "{cubic:?}");
        }
        Pair::NotSeparated => return false,
    }
    true
}

fn check_both(cubic: [f64; 4]) -> (bool, bool) {
    let single = assert_bounds_hold(cubic, &bounded_roots(cubic), |x| Float::with_val(53, x));
    let double = bounded_roots(cubic.map(Dd::from));
    let double = assert_bounds_hold(cubic, &double, |x| Float::with_val(250, x.hi()) + x.lo());
    (single, double)
}

proptest! {
    #[test]
    fn bounds_hold_for_roots_many_decades_apart(cubic in prop::array::uniform4(coefficient())) {
        let (_, double) = check_both(cubic);
        prop_assert!(double, "random cubics are separated in double-double: {:?}", cubic);
    }

    #[test]
    fn bounds_hold_next_to_double_and_triple_roots(
        a in -50i32..50, gap in 0i32..3, power in 0i32..60, b in -50i32..50, triple in prop::bool::ANY,
    ) {
        let x = f64::from(a);
        let y = x + libm::ldexp(f64::from(gap), -power);
        let z = if triple { y } else { f64::from(b) };
        check_both([-x * y * z, x * y + y * z + z * x, -(x + y + z), 1.0]);
    }
}

#[test]
fn an_exact_double_root_is_not_called_real_or_complex() {
    // (x + 1)²(x + 2), and the cusp (x + 3)³/8.
    assert_eq!(check_both([2.0, 5.0, 4.0, 1.0]), (false, false));
    assert_eq!(check_both([3.375, 3.375, 1.125, 0.125]), (false, false));
}

#[test]
fn errors_are_a_few_units_on_well_conditioned_cubics() {
    let found = bounded_roots([0.7, 0.31, 1.013, 0.013]);
    assert!(found.real.error < 1e-14 * found.real.value.abs());
    let Pair::Complex { re, im } = found.pair else { panic!("a pair") };
    let modulus = (re.value * re.value + im.value * im.value).sqrt();
    assert!(re.error < 1e-14 * modulus && im.error < 1e-13 * im.value, "{re:?} {im:?}");
}
