//! Double-double arithmetic: unevaluated sums of two f64, about 32 significant digits.
//!
//! The algorithms are those of Joldes, Muller & Popescu, *Tight and rigorous error bounds for basic building blocks
//! of double-word arithmetic* (2017), and for the square root Lefèvre et al. (2023).
//! Every operation has a relative error of at most [`Dd::UNIT`] as long as no intermediate over- or underflows;
//! an overflow gives a value that is not finite, which callers must test for before they trust a bound.

use std::ops::Neg;

use rug::{Float, Integer, Rational};

use super::{Field, Real};
use slipmode_algebra::implement_operators;

/// The number `hi + lo` with |lo| ≤ ulp(hi)/2.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Dd {
    hi: f64,
    lo: f64,
}

/// The exact sum of two f64 (Knuth): rounded sum and rounding error.
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The exact sum when |a| ≥ |b| or a = 0 (Dekker).
#[inline(always)]
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The exact product: rounded product and rounding error.
#[inline(always)]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

/// One of two numbers, without a branch.
#[inline(always)]
pub(crate) fn select(condition: bool, yes: f64, no: f64) -> f64 {
    if condition { yes } else { no }
}

impl Dd {
    /// Bound on the relative error of one operation: 2^-102 (the division's 15·2^-106 is the largest).
    pub const UNIT: f64 = 1.0 / (1u128 << 102) as f64;

    /// The exact sum of two f64.
    #[inline(always)]
    pub(crate) fn exact_sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// The number of which these are the leading and the trailing part.
    #[inline(always)]
    pub(crate) const fn from_parts(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// The exact product of two f64, unless it over- or underflows.
    #[inline(always)]
    pub(crate) fn exact_product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self { hi, lo }
    }

    /// The double-double nearest to a rational, to within a relative 2^-105.
    #[must_use]
    #[expect(clippy::disallowed_methods, reason = "short integers are converted exactly")]
    pub fn from_rational(value: &Rational) -> Self {
        // Integers that are 64-bit numbers, so small that the quotient's remainder has neither overflow nor underflow.
        let is_short = |integer: &Integer| {
            let bits = integer.significant_bits();
            bits < 400 && bits - integer.find_one(0).unwrap_or(0) <= 53
        };
        if is_short(value.numer()) && is_short(value.denom()) {
            let [numerator, denominator] = [value.numer(), value.denom()].map(Integer::to_f64);
            let hi = numerator / denominator;
            return Self { hi, lo: (-hi).mul_add(denominator, numerator) / denominator };
        }
        let rounded = Float::with_val(120, value);
        let hi = rounded.to_f64();
        let lo = Float::with_val(120, &rounded - hi).to_f64();
        Self { hi, lo }
    }

    /// The leading part: the f64 nearest to the number.
    #[must_use]
    #[inline(always)]
    pub const fn hi(&self) -> f64 {
        self.hi
    }

    /// The trailing part.
    #[must_use]
    #[inline(always)]
    pub const fn lo(&self) -> f64 {
        self.lo
    }

    /// The absolute value.
    #[must_use]
    #[inline(always)]
    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// The product with a power of two, exact unless it over- or underflows.
    #[must_use]
    #[inline(always)]
    pub fn scale(self, power_of_two: f64) -> Self {
        Self { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    /// Whether both parts are finite numbers.
    #[must_use]
    #[inline(always)]
    pub const fn is_finite(&self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }

    /// One of two numbers, without a branch.
    #[inline(always)]
    pub(crate) fn select(condition: bool, yes: Self, no: Self) -> Self {
        Self { hi: select(condition, yes.hi, no.hi), lo: select(condition, yes.lo, no.lo) }
    }

    /// Whether every number within `error` of this one rounds to its leading part; the error is at least [`Dd::UNIT`] of it.
    #[must_use]
    #[inline(always)]
    pub fn rounds_surely(self, error: f64) -> bool {
        // Twice the error covers the rounding of both sums, which is below 2^-106 of the number.
        (self.hi + (self.lo + 2.0 * error) == self.hi) & (self.hi + (self.lo - 2.0 * error) == self.hi)
    }

    /// The 64-bit number to which every number within this relative error (at least [`Dd::UNIT`]) rounds, if there is one. Numbers
    /// near the ends of the range have none: their trailing parts may have lost bits.
    #[must_use]
    pub fn rounded_surely(self, relative_error: f64) -> Option<f64> {
        let size = self.hi.abs();
        let has_range = size > 1e-250 && size < 1e250;
        (has_range && self.rounds_surely(relative_error * size)).then_some(self.hi)
    }

    #[inline(always)]
    fn add_accurately(&self, other: &Self) -> Self {
        let (sum, sum_error) = two_sum(self.hi, other.hi);
        let (tail, tail_error) = two_sum(self.lo, other.lo);
        let (head, head_error) = fast_two_sum(sum, sum_error + tail);
        let (hi, lo) = fast_two_sum(head, tail_error + head_error);
        Self { hi, lo }
    }

    #[inline(always)]
    fn subtract(&self, other: &Self) -> Self {
        self.add_accurately(&-*other)
    }

    #[inline(always)]
    fn multiply(&self, other: &Self) -> Self {
        let (product, error) = two_product(self.hi, other.hi);
        let tail = self.hi.mul_add(other.lo, self.lo * other.lo);
        let tail = self.lo.mul_add(other.hi, tail);
        let (hi, lo) = fast_two_sum(product, error + tail);
        Self { hi, lo }
    }

    #[inline(always)]
    fn divide(&self, other: &Self) -> Self {
        let quotient = self.hi / other.hi;
        let (product, error) = two_product(other.hi, quotient);
        let (product, tail) = fast_two_sum(product, other.lo.mul_add(quotient, error));
        let remainder = (self.hi - product) + (self.lo - tail);
        let (hi, lo) = fast_two_sum(quotient, remainder / other.hi);
        Self { hi, lo }
    }
}

implement_operators!(Dd, Add::add => add_accurately, Sub::sub => subtract, Mul::mul => multiply, Div::div => divide);

impl Neg for Dd {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl From<f64> for Dd {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl From<i32> for Dd {
    #[inline(always)]
    fn from(value: i32) -> Self {
        Self::from(f64::from(value))
    }
}

impl Field for Dd {
    #[inline(always)]
    fn square(&self) -> Self {
        self.multiply(self)
    }
}

impl Real for Dd {
    /// The square root; zero for zero, not a number below zero.
    #[inline(always)]
    fn sqrt(&self) -> Self {
        let root = self.hi.sqrt();
        let remainder = (-root).mul_add(root, self.hi) + self.lo;
        let (hi, lo) = fast_two_sum(root, remainder / (2.0 * root));
        if self.hi == 0.0 { *self } else { Self { hi, lo } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::nearest_f64;
    use proptest::prelude::*;

    fn exactly(value: Dd) -> Rational {
        Rational::from_f64(value.hi).unwrap() + Rational::from_f64(value.lo).unwrap()
    }

    fn assert_within_unit(value: Dd, exact: &Rational) {
        let error = (exactly(value) - exact).abs();
        assert!(
            error <= Rational::from_f64(Dd::UNIT).unwrap() * Rational::from(exact.abs_ref()),
            "{value:?}"
        );
    }

    fn any_double_double() -> impl Strategy<Value = Dd> {
        // Trailing parts from nothing to half a unit in the last place, so that sums cancel at every depth.
        (-1.0f64..1.0, -60i32..60, -1.0f64..1.0, 53i32..110).prop_map(|(head, exponent, tail, depth)| {
            let head = head * libm::exp2(f64::from(exponent));
            Dd::exact_sum(head, head * tail * libm::exp2(f64::from(-depth)))
        })
    }

    proptest! {
        #[test]
        fn each_operation_errs_by_less_than_its_unit(x in any_double_double(), y in any_double_double()) {
            let (p, q) = (exactly(x), exactly(y));
            assert_within_unit(x + y, &Rational::from(&p + &q));
            assert_within_unit(x - y, &Rational::from(&p - &q));
            assert_within_unit(x * y, &Rational::from(&p * &q));
            prop_assume!(q != 0);
            assert_within_unit(x / y, &Rational::from(&p / &q));
        }

        #[test]
        fn a_nearly_total_cancellation_keeps_its_relative_accuracy(x in any_double_double(), depth in 80i32..104) {
            let y = x + x * Dd::from(libm::exp2(f64::from(-depth)));
            assert_within_unit(y - x, &(exactly(y) - exactly(x)));
        }

        #[test]
        fn the_square_of_the_square_root_is_the_number(x in any_double_double()) {
            let x = x.abs();
            let square = exactly(x.sqrt()).square();
            let bound = Rational::from_f64(2.0 * Dd::UNIT).unwrap() * exactly(x);
            prop_assert!((square - exactly(x)).abs() <= bound);
        }

        #[test]
        fn what_rounds_surely_rounds_alike_at_both_ends(x in any_double_double(), depth in 40i32..103) {
            let error = x.hi.abs() * libm::exp2(f64::from(-depth));
            let away = Rational::from_f64(error).unwrap();
            let ends = [exactly(x) - &away, exactly(x) + &away];
            if x.rounds_surely(error) {
                prop_assert!(ends.iter().all(|end| nearest_f64(end) == x.hi));
            } else {
                // Wider by four errors and the rounding of the sums, it does not: the test refuses nothing else.
                let wide = away * 4u32 + exactly(x).abs() * Rational::from_f64(libm::exp2(-105.0)).unwrap();
                let ends = [exactly(x) - &wide, exactly(x) + &wide];
                prop_assert!(ends.iter().any(|end| nearest_f64(end) != x.hi));
            }
        }

        #[test]
        fn a_rational_is_rounded_to_106_bits(n in 1i64..i64::MAX, d in 1i64..i64::MAX, less in 0u32..63, scale in -420i32..420) {
            // Integers of all sizes, those that 64-bit numbers hold among them.
            let exact = Rational::from(((n >> less).max(1), (d >> (less / 2)).max(1))) << scale;
            assert_within_unit(Dd::from_rational(&exact), &exact);
        }
    }
}
