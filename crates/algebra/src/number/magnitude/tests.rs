//! Radii round as MPFR does at 32 bits.

use super::*;
use proptest::prelude::*;
use rug::float::Round::{Down, Up};
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, SubAssignRound};

/// Magnitudes close together and far apart, with short and full mantissas.
fn any_magnitude() -> impl Strategy<Value = Magnitude> {
    let mantissa = prop_oneof![any::<u32>(), Just(1 << 31), Just(u32::MAX), (0u32..4).prop_map(|i| i << 30)];
    (mantissa, -80i64..80)
        .prop_map(|(mantissa, exponent)| Magnitude { mantissa: mantissa | 1 << 31, exponent })
}

fn any_float() -> impl Strategy<Value = Float> {
    (any::<[u64; 3]>(), 2u32..190, -60i32..60, any::<bool>()).prop_map(|(limbs, bits, exponent, negative)| {
        let digits = rug::Integer::from_digits(&limbs, rug::integer::Order::Lsf) + 1u32;
        let value = Float::with_val(bits, digits) >> (190 - exponent);
        if negative { -value } else { value }
    })
}

proptest! {
    #[test]
    fn every_operation_rounds_as_mpfr_does(x in any_magnitude(), y in any_magnitude()) {
        let (p, q) = (x.to_float(), y.to_float());
        let by_mpfr = |operation: fn(&mut Float, &Float) -> Ordering| {
            let mut result = p.clone();
            operation(&mut result, &q);
            result
        };
        prop_assert_eq!(x.plus(y).to_float(), by_mpfr(|p, q| p.add_assign_round(q, Up)));
        prop_assert_eq!(x.plus_down(y).to_float(), by_mpfr(|p, q| p.add_assign_round(q, Down)));
        prop_assert_eq!(x.times(y).to_float(), by_mpfr(|p, q| p.mul_assign_round(q, Up)));
        prop_assert_eq!(x.over(y).to_float(), by_mpfr(|p, q| p.div_assign_round(q, Up)));
        let difference = by_mpfr(|p, q| p.sub_assign_round(q, Down));
        prop_assert_eq!(x.minus_down(y).to_float(), difference.max(&Float::new(32)));
        let (root, _) = Float::with_val_round(32, p.sqrt_ref(), Down);
        prop_assert_eq!(x.root_down().to_float(), root);
        prop_assert_eq!(Some(x.compare(y)), p.partial_cmp(&q));
    }

    #[test]
    fn the_magnitude_of_a_float_is_rounded_outward(value in any_float()) {
        let size = value.clone().abs();
        let rounded = |direction| Float::with_val_round(32, &size, direction).0;
        prop_assert_eq!(Magnitude::above(&value).to_float(), rounded(Up));
        prop_assert_eq!(Magnitude::below(&value).to_float(), rounded(Down));
        let (root, _) = Float::with_val_round(32, size.sqrt_ref(), Down);
        prop_assert_eq!(Magnitude::root_below(&value).to_float(), root);
    }
}

#[test]
fn nothing_known_stays_nothing_known() {
    let (zero, one, infinite) = (Magnitude::ZERO, Magnitude::power_of_two(0), Magnitude::INFINITE);
    for magnitude in [infinite.plus(one), infinite.times(zero), infinite.over(one), one.over(zero)] {
        assert!(magnitude.is_infinite());
    }
    assert_eq!((one.to_float(), one.plus(zero), zero.times(one)), (Float::with_val(32, 1), one, zero));
    assert!(infinite.to_float().is_infinite() && zero.to_float().is_zero());
    for value in [Special::Nan, Special::Infinity, Special::NegInfinity] {
        assert!(Magnitude::above(&Float::with_val(53, value)).is_infinite());
    }
    assert!(Magnitude::of_radius(&Float::with_val(53, -1)).is_infinite());
}

#[test]
fn beyond_the_exponents_of_a_float_a_bound_stays_a_bound() {
    assert!(Magnitude::power_of_two(1 << 40).to_float().is_infinite());
    let tiny = Magnitude::power_of_two(-(1 << 40)).to_float();
    assert!(!tiny.is_zero() && tiny.is_finite());
}
