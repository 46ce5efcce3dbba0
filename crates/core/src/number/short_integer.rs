//! Integers of at most 1024 bits without memory of their own: exact signs of polynomials in a handful of 64-bit numbers.
//!
//! Whoever starts a computation makes sure that its largest result fits ([`ShortInteger::BITS`]); a result that does not is
//! a fault of the program, not of the input.

use std::cmp::Ordering;

use super::Dd;

const LIMBS: usize = 16;

/// Sign and magnitude, 64 bits a limb, the lowest first; no limb beyond `length` is set, and the last one is not zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ShortInteger {
    limbs: [u64; LIMBS],
    length: usize,
    negative: bool,
}

impl ShortInteger {
    /// The most bits that fit.
    pub const BITS: u32 = 64 * LIMBS as u32;

    /// Zero.
    pub const ZERO: Self = Self { limbs: [0; LIMBS], length: 0, negative: false };

    /// The product of three factors.
    #[must_use]
    pub fn of_factors([one, two, three]: [u64; 3]) -> Self {
        let (low, high) = multiply_add(one, two, 0, 0);
        let (first, carry) = multiply_add(low, three, 0, 0);
        let (second, third) = multiply_add(high, three, 0, carry);
        let mut result = Self { length: 3, ..Self::ZERO };
        result.limbs[..3].copy_from_slice(&[first, second, third]);
        result.trim();
        result
    }

    /// Bits of the magnitude; zero for zero.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.used().last().map_or(0, |top| 64 * self.length as u32 - top.leading_zeros())
    }

    /// −1, 0 or 1.
    #[must_use]
    pub const fn sign(&self) -> i8 {
        if self.length == 0 {
            0
        } else if self.negative {
            -1
        } else {
            1
        }
    }

    /// The product with 2^shift.
    #[must_use]
    pub fn shifted(&self, shift: u32) -> Self {
        let (whole, part) = ((shift / 64) as usize, shift % 64);
        let mut result = Self { length: self.length + whole, negative: self.negative, ..Self::ZERO };
        let mut carry = 0;
        for (target, limb) in result.limbs[whole..].iter_mut().zip(self.used()) {
            *target = limb << part | carry;
            carry = limb.checked_shr(64 - part).unwrap_or(0);
        }
        if carry != 0 {
            result.limbs[result.length] = carry;
            result.length += 1;
        }
        if self.length == 0 { Self::ZERO } else { result }
    }

    /// The sum.
    #[must_use]
    #[inline]
    pub fn plus(&self, other: &Self) -> Self {
        self.sum_with(other, other.negative)
    }

    /// The difference.
    #[must_use]
    #[inline]
    pub fn minus(&self, other: &Self) -> Self {
        self.sum_with(other, !other.negative)
    }

    /// The sum with a number of the other's magnitude and this sign.
    fn sum_with(&self, other: &Self, negative: bool) -> Self {
        if self.negative == negative {
            return self.sum_of_magnitudes(other, negative);
        }
        match self.compare_magnitudes(other) {
            Ordering::Less => other.difference_of_magnitudes(self, negative),
            Ordering::Equal => Self::ZERO,
            Ordering::Greater => self.difference_of_magnitudes(other, self.negative),
        }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut result = Self { negative: self.negative != other.negative, ..Self::ZERO };
        for (start, factor) in self.used().iter().enumerate() {
            let mut carry = 0;
            for (target, limb) in result.limbs[start..].iter_mut().zip(other.used()) {
                let (low, high) = multiply_add(*factor, *limb, *target, carry);
                (*target, carry) = (low, high);
            }
            if carry != 0 {
                result.limbs[start + other.length] = carry;
            }
        }
        result.length = (self.length + other.length).min(LIMBS);
        result.trim();
        result
    }

    /// The product with a small factor.
    #[must_use]
    pub fn scaled(&self, factor: u32) -> Self {
        self.times(&Self::from(u64::from(factor)))
    }

    /// The square.
    #[must_use]
    pub fn squared(&self) -> Self {
        self.times(self)
    }

    /// The magnitude as mantissa·2^exponent, 1/2 ≤ mantissa ≤ 1, within a relative 2^-105, with the sign; zero for zero.
    #[must_use]
    pub fn as_double_double(&self) -> (Dd, i32) {
        if self.length == 0 {
            return (Dd::from(0.0), 0);
        }
        let limb = |back: usize| self.length.checked_sub(back).map_or(0, |index| self.limbs[index]);
        let shift = limb(1).leading_zeros();
        let joined = |high: u64, low: u64| high << shift | low.checked_shr(64 - shift).unwrap_or(0);
        let (head, tail) = (joined(limb(1), limb(2)), joined(limb(2), limb(3)));
        // 53 bits and the 75 that follow: the former exact, the latter rounded; what is left out lies below 2^-128.
        let upper = (head >> 11) as f64 * (1.0 / (1u64 << 53) as f64);
        let lower =
            (u128::from(head & 0x7ff) << 64 | u128::from(tail)) as f64 * f64::from_bits((1023 - 128) << 52);
        let magnitude = Dd::exact_sum(upper, lower);
        (if self.negative { -magnitude } else { magnitude }, (64 * self.length as u32 - shift) as i32)
    }

    fn used(&self) -> &[u64] {
        &self.limbs[..self.length]
    }

    /// Leaves out zeros above the last limb; they can only be few.
    fn trim(&mut self) {
        while self.length > 0 && self.limbs[self.length - 1] == 0 {
            self.length -= 1;
        }
    }

    fn compare_magnitudes(&self, other: &Self) -> Ordering {
        let by_length = self.length.cmp(&other.length);
        by_length.then_with(|| self.used().iter().rev().cmp(other.used().iter().rev()))
    }

    /// |self| + |other| with this sign.
    fn sum_of_magnitudes(&self, other: &Self, negative: bool) -> Self {
        let (long, short) = if self.length < other.length { (other, self) } else { (self, other) };
        let mut result = Self { length: long.length, negative, ..Self::ZERO };
        let mut carry = false;
        for (index, limb) in result.limbs[..long.length].iter_mut().enumerate() {
            let (sum, first) = long.limbs[index].overflowing_add(short.limbs[index]);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            (*limb, carry) = (sum, first || second);
        }
        if carry {
            result.limbs[result.length] = 1;
            result.length += 1;
        }
        result
    }

    /// |self| − |other| > 0 with this sign.
    fn difference_of_magnitudes(&self, other: &Self, negative: bool) -> Self {
        let mut result = Self { length: self.length, negative, ..Self::ZERO };
        let mut borrow = false;
        for (index, limb) in result.limbs[..self.length].iter_mut().enumerate() {
            let (difference, first) = self.limbs[index].overflowing_sub(other.limbs[index]);
            let (difference, second) = difference.overflowing_sub(u64::from(borrow));
            (*limb, borrow) = (difference, first || second);
        }
        result.trim();
        result
    }
}

/// The magnitude of a finite number as integer·2^exponent, the integer odd, or zero for zero.
#[must_use]
pub(crate) const fn odd_part(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let mantissa = if biased == 0 { fraction } else { fraction | 1 << 52 };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let exponent = if biased == 0 { 1 } else { biased } - 1075 + zeros as i32;
    (mantissa >> zeros, exponent)
}

/// x·y + addend + carry as low and high limb; it fits.
#[inline(always)]
const fn multiply_add(x: u64, y: u64, addend: u64, carry: u64) -> (u64, u64) {
    let sum = x as u128 * y as u128 + addend as u128 + carry as u128;
    (sum as u64, (sum >> 64) as u64)
}

impl From<u64> for ShortInteger {
    fn from(value: u64) -> Self {
        let mut result = Self::ZERO;
        result.limbs[0] = value;
        result.length = usize::from(value != 0);
        result
    }
}

#[cfg(test)]
mod tests;
