//! Upper bounds as 32 bits and an exponent: the radii of balls, without memory of their own.
//!
//! Every operation rounds to 32 bits exactly as MPFR does at that precision in the direction that its name says, so that
//! a radius is the same number as one computed by MPFR, at a fraction of the cost.

use std::cmp::Ordering;

use gmp_mpfr_sys::gmp;
use rug::Float;
use rug::float::Special;

/// Bits of a magnitude.
pub(super) const MAGNITUDE_BITS: u32 = 32;

/// The largest exponents that a float takes; beyond them a magnitude is passed on as infinite, or as 2^−`FLOAT_EXPONENTS`.
const FLOAT_EXPONENTS: i64 = 1 << 29;

/// mantissa·2^(exponent − 32) with 2^31 ≤ mantissa < 2^32, zero, or infinite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Magnitude {
    mantissa: u32,
    exponent: i64,
}

impl Magnitude {
    /// Zero; its exponent is below that of every other magnitude.
    pub(super) const ZERO: Self = Self { mantissa: 0, exponent: i64::MIN / 4 };

    /// Infinity; its exponent is above that of every other magnitude.
    pub(super) const INFINITE: Self = Self { mantissa: 1 << 31, exponent: i64::MAX / 4 };

    /// 2^exponent.
    pub(super) const fn power_of_two(exponent: i64) -> Self {
        Self { mantissa: 1 << 31, exponent: exponent + 1 }
    }

    /// A whole number.
    pub(super) fn of_whole(value: u32) -> Self {
        if value == 0 { Self::ZERO } else { Self::rounded_up(u64::from(value), false, 64) }
    }

    /// |value| rounded up; infinite for what is not finite.
    pub(super) fn above(value: &Float) -> Self {
        match significant(value) {
            Some((head, tail, exponent)) => Self::rounded_up(head, tail, exponent),
            None if value.is_zero() => Self::ZERO,
            None => Self::INFINITE,
        }
    }

    /// |value| rounded down; zero for what is not finite.
    pub(super) fn below(value: &Float) -> Self {
        significant(value).map_or(Self::ZERO, |(head, _, exponent)| Self::rounded_down(head, exponent))
    }

    /// √|value| rounded down.
    pub(super) fn root_below(value: &Float) -> Self {
        significant(value).map_or(Self::ZERO, |(head, _, exponent)| root_down(head, exponent))
    }

    /// The magnitude is below 2^exponent, and at least half of it unless it is zero.
    pub(super) const fn exponent(self) -> i64 {
        self.exponent
    }

    pub(super) const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    pub(super) const fn is_infinite(self) -> bool {
        self.exponent >= Self::INFINITE.exponent
    }

    /// head·2^(exponent − 64) and, with `tail`, something less than a unit of head more; head ≠ 0.
    fn rounded_up(head: u64, tail: bool, exponent: i64) -> Self {
        let shift = head.leading_zeros();
        let head = head << shift;
        let exponent = exponent - i64::from(shift);
        let mantissa = (head >> 32) as u32;
        if !tail && head as u32 == 0 {
            return Self { mantissa, exponent };
        }
        match mantissa.checked_add(1) {
            Some(mantissa) => Self { mantissa, exponent },
            None => Self { mantissa: 1 << 31, exponent: exponent + 1 },
        }
    }

    fn rounded_down(head: u64, exponent: i64) -> Self {
        let shift = head.leading_zeros();
        Self { mantissa: ((head << shift) >> 32) as u32, exponent: exponent - i64::from(shift) }
    }

    /// Mantissa and exponent as head·2^(exponent − 64), the head's first bit free.
    const fn with_a_free_bit(self) -> (u64, i64) {
        ((self.mantissa as u64) << 31, self.exponent + 1)
    }

    /// The sum, rounded up.
    pub(super) fn plus(self, other: Self) -> Self {
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        if small.is_zero() || large.is_infinite() {
            return large;
        }
        let ((head, exponent), (addend, _)) = (large.with_a_free_bit(), small.with_a_free_bit());
        let (addend, lost) = shifted(addend, large.exponent - small.exponent);
        Self::rounded_up(head + addend, lost, exponent)
    }

    /// The sum, rounded down.
    pub(super) fn plus_down(self, other: Self) -> Self {
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        if small.is_zero() || large.is_infinite() {
            return large;
        }
        let ((head, exponent), (addend, _)) = (large.with_a_free_bit(), small.with_a_free_bit());
        Self::rounded_down(head + shifted(addend, large.exponent - small.exponent).0, exponent)
    }

    /// The difference, rounded down; zero when it is not positive.
    pub(super) fn minus_down(self, other: Self) -> Self {
        if other.is_zero() || self.is_infinite() {
            return self;
        }
        if self.compare(other) != Ordering::Greater {
            return Self::ZERO;
        }
        let ((head, exponent), (subtrahend, _)) = (self.with_a_free_bit(), other.with_a_free_bit());
        let (subtrahend, lost) = shifted(subtrahend, self.exponent - other.exponent);
        Self::rounded_down(head - subtrahend - u64::from(lost), exponent)
    }

    /// The product, rounded up; infinite as soon as one of the two is, for then nothing is known.
    pub(super) fn times(self, other: Self) -> Self {
        if self.is_infinite() || other.is_infinite() {
            return Self::INFINITE;
        }
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let product = u64::from(self.mantissa) * u64::from(other.mantissa);
        Self::rounded_up(product, false, self.exponent + other.exponent)
    }

    /// The quotient, rounded up; infinite for a divisor of zero.
    pub(super) fn over(self, other: Self) -> Self {
        if other.is_zero() || self.is_infinite() || other.is_infinite() {
            return Self::INFINITE;
        }
        if self.is_zero() {
            return Self::ZERO;
        }
        let (dividend, divisor) = (u64::from(self.mantissa) << 32, u64::from(other.mantissa));
        let lost = !dividend.is_multiple_of(divisor);
        Self::rounded_up(dividend / divisor, lost, self.exponent - other.exponent + 32)
    }

    /// The product with 2^exponent.
    pub(super) const fn scaled(self, exponent: i64) -> Self {
        if self.is_zero() || self.is_infinite() {
            return self;
        }
        Self { exponent: self.exponent + exponent, ..self }
    }

    /// The square root, rounded down.
    pub(super) fn root_down(self) -> Self {
        if self.is_zero() || self.is_infinite() {
            return self;
        }
        root_down(u64::from(self.mantissa) << 32, self.exponent)
    }

    /// Which of the two is larger.
    pub(super) fn compare(self, other: Self) -> Ordering {
        (self.exponent, self.mantissa).cmp(&(other.exponent, other.mantissa))
    }

    /// log2; −∞ for zero.
    pub(super) fn binary_logarithm(self) -> f64 {
        libm::log2(f64::from(self.mantissa) / (1u64 << MAGNITUDE_BITS) as f64) + self.exponent as f64
    }

    /// The same number as a float of 32 bits; rounded up to what a float can hold.
    pub(super) fn to_float(self) -> Float {
        if self.is_zero() {
            return Float::new(MAGNITUDE_BITS);
        }
        if self.exponent > FLOAT_EXPONENTS {
            return Float::with_val(MAGNITUDE_BITS, Special::Infinity);
        }
        let exponent = self.exponent.max(-FLOAT_EXPONENTS) - i64::from(MAGNITUDE_BITS);
        Float::with_val(MAGNITUDE_BITS, self.mantissa) << exponent as i32
    }

    /// A float that is not negative, rounded up; infinite for what is not such a number.
    pub(super) fn of_radius(radius: &Float) -> Self {
        let negative = radius.is_sign_negative() && !radius.is_zero();
        if negative { Self::INFINITE } else { Self::above(radius) }
    }
}

/// head >> shift, and whether bits were lost.
fn shifted(head: u64, shift: i64) -> (u64, bool) {
    match u32::try_from(shift).ok().filter(|shift| *shift < 64) {
        Some(shift) => (head >> shift, head & ((1u64 << shift) - 1) != 0),
        None => (0, head != 0),
    }
}

/// √(head·2^(exponent − 64)) rounded down, the head's first bit set.
fn root_down(head: u64, exponent: i64) -> Magnitude {
    let odd = exponent.rem_euclid(2);
    // The root of the whole part is the whole part of the root; the head is halved for an odd exponent.
    let root = (head >> odd).isqrt();
    Magnitude::rounded_down(root, (exponent + odd) / 2 + 32)
}

/// The first 64 bits of |value|, whether there are more, and the exponent: value = 0.head·2^exponent. None if not normal.
fn significant(value: &Float) -> Option<(u64, bool, i64)> {
    let significand = value.get_significand()?;
    let (top, rest) = significand.as_limbs().split_last()?;
    // A limb of fewer than 64 bits, as on small machines, fills the upper ones.
    let head = (u128::from(*top) << (64 - gmp::LIMB_BITS)) as u64;
    Some((head, rest.iter().any(|limb| *limb != 0), i64::from(value.get_exp()?)))
}

#[cfg(test)]
mod tests;
