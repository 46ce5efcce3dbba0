//! Real numbers of N limbs of 64 bits with an error bound, without memory of their own.
//!
//! A result is truncated, and its error is the sum of three: what the operands' errors make of it, to all orders, and one unit of the
//! last place if a bit was lost. So integers stay exact as long as they have room. The bound is itself computed in 64-bit, in some
//! hundred roundings: [`Limbs::error`] has room for these.

use rug::{Float, Integer, integer::Order};

use crate::number::Dd;

/// Exponents for which a double-double has all its bits, and also its product with a number of ordinary size.
const DOUBLE_DOUBLE_EXPONENTS: i64 = 700;

/// ±limbs·2^(exponent − 64N), up to `error` units of the last place, 2^(exponent − 64N).
#[derive(Debug, Clone, Copy)]
pub(super) struct Limbs<const N: usize> {
    pub(super) is_negative: bool,
    /// The lowest first. The highest bit is set, except in zero.
    limbs: [u64; N],
    /// The magnitude is below 2^exponent, and at least half of it unless the error is larger.
    pub(super) exponent: i64,
    error: f64,
}

impl<const N: usize> Limbs<N> {
    /// Bits of the significand.
    pub(super) const BITS: i64 = 64 * N as i64;

    pub(super) fn of_integer(value: &Integer) -> Self {
        let mut limbs = [0; N];
        let excess = i64::from(value.significant_bits()) - Self::BITS;
        if excess > 0 {
            Integer::from(&*value.as_abs() >> excess as u32).write_digits(&mut limbs, Order::Lsf);
        } else {
            value.write_digits(&mut limbs, Order::Lsf);
        }
        let exponent = Self::BITS + excess.max(0);
        let error = if excess > 0 { 1.0 } else { 0.0 };
        Self { is_negative: value.is_negative(), limbs, exponent, error }.normalised(0)
    }

    /// The number to a relative 2^-127, as an exact one; what is not finite has an infinite error.
    pub(super) fn of_dd(value: Dd) -> Self {
        let (_, exponent) = libm::frexp(value.hi());
        let size = value.abs();
        let unit = power_of_two(64 - i64::from(exponent));
        // The leading part is a whole number of these units, the trailing one is below 2^11 of them.
        let whole = (size.lo() * unit).floor();
        let mut limbs = [0; N];
        limbs[N - 1] = ((size.hi() * unit) as u64).wrapping_add_signed(whole as i64);
        limbs[N - 2] = ((size.lo() * unit - whole) * power_of_two(64)) as u64;
        let error = if value.is_finite() { 0.0 } else { f64::INFINITY };
        Self { is_negative: value.hi() < 0.0, limbs, exponent: i64::from(exponent), error }.normalised(0)
    }

    /// The centre as a double-double, to a relative 2^-105; not a number if it is far out of range.
    pub(super) fn to_dd(self) -> Dd {
        let [.., lower, upper] = self.limbs[..] else { return Dd::from(f64::NAN) };
        let in_range = upper == 0 || self.exponent.abs() < DOUBLE_DOUBLE_EXPONENTS;
        let unit = if in_range { power_of_two(self.exponent) } else { f64::NAN };
        // Two times 53 bits, each a number of f64 without rounding.
        let high = (upper >> 11) as f64 * power_of_two(-53);
        let low = ((upper << 42 | lower >> 22) & ((1 << 53) - 1)) as f64 * power_of_two(-106);
        Dd::exact_sum(high, low).scale(if self.is_negative { -unit } else { unit })
    }

    /// The centre as a float, exactly; none if it is far out of range.
    pub(super) fn to_float(self) -> Option<Float> {
        let shift = i32::try_from(self.exponent - Self::BITS).ok().filter(|shift| shift.abs() < 1 << 29)?;
        let value =
            Float::with_val(Self::BITS as u32, Integer::from_digits(&self.limbs, Order::Lsf)) << shift;
        Some(if self.is_negative { -value } else { value })
    }

    /// The same number known exactly.
    pub(super) const fn exact(self) -> Self {
        Self { error: 0.0, ..self }
    }

    /// The same centre with a larger error, absolute in the unit 2^0.
    pub(super) fn widened(self, error: f64) -> Self {
        Self { error: self.error + error * power_of_two(Self::BITS - self.exponent), ..self }
    }

    /// The bound on the absolute error in the unit 2^exponent.
    pub(super) fn error(self, exponent: i64) -> f64 {
        self.error * power_of_two(self.exponent - Self::BITS - exponent) * (1.0 + 1e-12)
    }

    /// Whether the sign is certain; false for zero.
    pub(super) fn has_sign(self) -> bool {
        self.limbs[N - 1] >> 63 == 1 && self.error(self.exponent) < 0.5
    }

    pub(super) const fn abs(self) -> Self {
        Self { is_negative: false, ..self }
    }

    pub(super) const fn negated(self) -> Self {
        Self { is_negative: !self.is_negative, ..self }
    }

    /// The product with 2^exponent.
    pub(super) const fn scaled(self, exponent: i64) -> Self {
        Self { exponent: self.exponent + exponent, ..self }
    }

    pub(super) fn times(self, other: Self) -> Self {
        let (limbs, next, lost) = product(&self.limbs, &other.limbs);
        // |a|·δb + |b|·δa + δa·δb, where |a| and |b| are below a power of two.
        let error = self.error + other.error + self.error * other.error * power_of_two(-Self::BITS);
        let exponent = self.exponent + other.exponent;
        let is_negative = self.is_negative != other.is_negative;
        Self { is_negative, limbs, exponent, error }.normalised(next).rounded(lost)
    }

    /// The product with a whole number that is not zero.
    pub(super) fn times_whole(self, factor: u64) -> Self {
        let (limbs, next, lost) = product(&self.limbs, &[factor << factor.leading_zeros()]);
        let exponent = self.exponent + 64 - i64::from(factor.leading_zeros());
        Self { limbs, exponent, ..self }.normalised(next).rounded(lost)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let distance = large.exponent - small.exponent;
        let (addend, lost) = shifted_right(&small.limbs, distance);
        // An error shrinks by 2^-64 at most, so that it does not underflow in a few sums.
        let error = large.error + small.error * power_of_two(-distance.min(64));
        // A difference is the sum with the complement, which is negative without a carry.
        let is_sum = large.is_negative == small.is_negative;
        let (limbs, carry) = added(&large.limbs, &addend, !is_sum);
        let sum = Self { limbs, error, ..large };
        match (is_sum, carry) {
            (true, false) => sum.rounded(lost),
            (true, true) => sum.carried(lost),
            (false, true) => sum.rounded(lost).normalised(0),
            (false, false) => {
                let (limbs, _) = added(&[0; N], &limbs, true);
                Self { limbs, ..sum.negated() }.rounded(lost).normalised(0)
            }
        }
    }

    /// A sum beyond the highest limb: it is halved, and its exponent grows.
    fn carried(self, lost: bool) -> Self {
        let (mut limbs, bit) = shifted_right(&self.limbs, 1);
        limbs[N - 1] |= 1 << 63;
        Self { limbs, exponent: self.exponent + 1, error: self.error / 2.0, ..self }.rounded(lost | bit)
    }

    /// One unit more error if bits were lost.
    fn rounded(self, lost: bool) -> Self {
        Self { error: if lost { self.error + 1.0 } else { self.error }, ..self }
    }

    /// The limbs shifted left until the highest bit is set, with the first bits of `next` behind them; zero by the length of all.
    fn normalised(mut self, mut next: u64) -> Self {
        let mut shift = 0;
        while self.limbs[N - 1] == 0 && shift < Self::BITS {
            self.limbs.copy_within(..N - 1, 1);
            (self.limbs[0], next) = (next, 0);
            shift += 64;
        }
        let bits = self.limbs[N - 1].leading_zeros() % 64;
        let mut lower = next;
        for limb in &mut self.limbs {
            (lower, *limb) = (*limb, joined(*limb, lower, bits));
        }
        shift += i64::from(bits);
        Self { exponent: self.exponent - shift, error: self.error * power_of_two(shift), ..self }
    }
}

/// The upper 64 bits of two limbs shifted left by less than 64.
const fn joined(upper: u64, lower: u64, bits: u32) -> u64 {
    upper << bits | (lower >> 1) >> (63 - bits)
}

/// 2^exponent for an exponent up to 1023; more than that for one below −1022.
pub(super) fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent.clamp(-1022, 1023) + 1023) as u64) << 52)
}

/// The N upper limbs of the product, the limb below them, and whether any bit but those of the N upper limbs is set.
fn product<const N: usize>(one: &[u64; N], other: &[u64]) -> ([u64; N], u64, bool) {
    let (mut upper, mut next, mut any) = ([0; N], 0, 0);
    // Low limbs of zero, as of an integer, change nothing.
    for &factor in other.iter().skip_while(|limb| **limb == 0) {
        let mut carry = 0;
        for i in 0..N {
            let sum = u128::from(one[i]) * u128::from(factor) + u128::from(upper[i]) + u128::from(carry);
            carry = (sum >> 64) as u64;
            if i == 0 {
                next = sum as u64;
            } else {
                upper[i - 1] = sum as u64;
            }
        }
        upper[N - 1] = carry;
        any |= next;
    }
    (upper, next, any != 0)
}

/// The sum, or the difference as the sum with the complement, and the carry out.
fn added<const N: usize>(one: &[u64; N], other: &[u64; N], is_difference: bool) -> ([u64; N], bool) {
    let (mask, mut carry) = (u64::from(is_difference).wrapping_neg(), is_difference);
    let sum = std::array::from_fn(|i| {
        let (partial, first) = one[i].overflowing_add(other[i] ^ mask);
        let (sum, second) = partial.overflowing_add(u64::from(carry));
        carry = first | second;
        sum
    });
    (sum, carry)
}

/// The limbs shifted right, and whether a bit was lost.
fn shifted_right<const N: usize>(limbs: &[u64; N], distance: i64) -> ([u64; N], bool) {
    let words = (distance / 64).min(N as i64) as usize;
    let bits = (distance % 64) as u32;
    let limb = |i: usize| limbs.get(i + words).copied().unwrap_or(0);
    let shifted = std::array::from_fn(|i| limb(i) >> bits | (limb(i + 1) << 1) << (63 - bits));
    let lost = limbs.iter().take(words).fold((limb(0) << 1) << (63 - bits), |lost, limb| lost | limb);
    (shifted, lost != 0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::{Ball, Rational};

    fn ball(value: Limbs<3>) -> Ball {
        let radius = Float::with_val(53, value.error(value.exponent)) << value.exponent as i32;
        Ball::new(value.to_float().unwrap(), radius)
    }

    fn integer() -> impl Strategy<Value = Integer> {
        (any::<[u64; 5]>(), 0u32..320, any::<bool>()).prop_map(|(digits, shift, negative)| {
            let value = Integer::from_digits(&digits, Order::Lsf) >> shift;
            if negative { -value } else { value }
        })
    }

    proptest! {
        #[test]
        fn sums_and_products_contain_those_of_the_integers(
            a in integer(), b in integer(), near in -9i32..9, factor in 1u64..99,
        ) {
            let [x, y, z] = [&a, &b, &Integer::from(&a + near)].map(Limbs::<3>::of_integer);
            let holds = |found: Limbs<3>, exact: Integer| {
                let found = ball(found);
                // Integers of up to 192 bits are exact.
                let is_exact = [&a, &b, &exact].iter().all(|value| value.significant_bits() < 192);
                found.contains(&Rational::from(exact)) && (!is_exact || found.is_exact())
            };
            prop_assert!(holds(x.plus(y), Integer::from(&a + &b)));
            prop_assert!(holds(x.minus(y), Integer::from(&a - &b)));
            prop_assert!(holds(x.minus(z), Integer::from(-near)));
            prop_assert!(holds(x.times(y), Integer::from(&a * &b)));
            prop_assert!(holds(x.times_whole(factor), Integer::from(&a * factor)));
        }

        #[test]
        fn a_double_double_survives_the_round_trip(
            hi in -1e9f64..1e9, lo in -1e-9f64..1e-9, exponent in -600i32..600,
        ) {
            let value = Dd::exact_sum(hi, lo).scale(libm::exp2(f64::from(exponent)));
            let back = Limbs::<3>::of_dd(value).to_dd();
            prop_assert!((value - back).hi().abs() <= libm::exp2(-105.0) * value.hi().abs());
        }
    }
}
