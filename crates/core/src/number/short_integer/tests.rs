//! Integers of fixed length against GMP's.

use super::*;
use proptest::prelude::*;
use rug::{Integer, Rational, integer::Order};

fn any_integer() -> impl Strategy<Value = ShortInteger> {
    let limb = carrying_limb();
    (prop::collection::vec(limb, 0..5), any::<bool>()).prop_map(|(limbs, negative)| {
        let mut value = ShortInteger { negative, ..ShortInteger::ZERO };
        value.limbs[..limbs.len()].copy_from_slice(&limbs);
        value.length = limbs.len();
        value.trim();
        value
    })
}

/// Limbs that carry: all ones, zero and others.
fn carrying_limb() -> impl Strategy<Value = u64> {
    prop_oneof![any::<u64>(), Just(u64::MAX), Just(0), Just(1), Just(1 << 63)]
}

fn exactly(value: &ShortInteger) -> Integer {
    let magnitude = Integer::from_digits(value.used(), Order::Lsf);
    if value.negative { -magnitude } else { magnitude }
}

proptest! {
    #[test]
    fn sums_products_and_shifts_are_exact(
        x in any_integer(), y in any_integer(), shift in 0u32..300, factor in 0u32..100,
    ) {
        let (p, q) = (exactly(&x), exactly(&y));
        prop_assert_eq!(exactly(&x.plus(&y)), Integer::from(&p + &q));
        prop_assert_eq!(exactly(&x.minus(&y)), Integer::from(&p - &q));
        prop_assert_eq!(exactly(&x.times(&y)), Integer::from(&p * &q));
        prop_assert_eq!(exactly(&x.squared()), Integer::from(p.square_ref()));
        prop_assert_eq!(exactly(&x.scaled(factor)), Integer::from(&p * factor));
        prop_assert_eq!(exactly(&x.shifted(shift)), Integer::from(&p << shift));
        prop_assert_eq!(x.bits(), p.significant_bits());
        prop_assert_eq!(x.sign(), p.cmp0() as i8);
        prop_assert_eq!(exactly(&x.minus(&x)), 0);
    }

    #[test]
    fn a_double_double_holds_the_first_105_bits(x in any_integer()) {
        let (mantissa, exponent) = x.as_double_double();
        let scale = Rational::from(1) << exponent;
        let part = |part: f64| Rational::from_f64(part).unwrap_or_default();
        let (value, exact) = ((part(mantissa.hi()) + part(mantissa.lo())) * scale, exactly(&x));
        let error = (value - &exact).abs();
        prop_assert!(error <= Rational::from(exact.abs()) >> 105_u32);
    }

    #[test]
    fn a_64_bit_number_is_taken_apart_exactly(bits in any::<u64>()) {
        let value = f64::from_bits(bits & (u64::MAX >> 1));
        prop_assume!(value.is_finite());
        let (integer, exponent) = odd_part(value);
        prop_assert!(integer == 0 || integer % 2 == 1);
        let product = Rational::from(integer) * (Rational::from(1) << exponent);
        prop_assert_eq!(product, Rational::from_f64(value).unwrap());
    }

    #[test]
    fn a_product_of_three_factors_is_exact(factors in prop::array::uniform3(carrying_limb())) {
        let [one, two, three] = factors.map(Integer::from);
        prop_assert_eq!(exactly(&ShortInteger::of_factors(factors)), one * two * three);
    }
}
