//! Complex numbers, and rectangles of complex numbers, whose operations round outwards.

use std::ops::{Add, Mul, Neg, Sub};

use super::Field;
use slipmode_algebra::number::Interval;

/// A complex number, of parts in any field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Complex<R> {
    /// The real part.
    pub re: R,
    /// The imaginary part.
    pub im: R,
}

/// All complex numbers with real and imaginary part in two intervals.
pub(crate) type Rectangle = Complex<Interval>;

impl<R: Field> Complex<R> {
    /// A real number.
    #[inline(always)]
    pub fn real(re: R) -> Self {
        Self { re, im: R::from(0) }
    }

    /// The product with a real number.
    #[inline(always)]
    pub fn times_real(&self, factor: &R) -> Self {
        Self { re: self.re.clone() * factor, im: self.im.clone() * factor }
    }
}

impl Rectangle {
    /// The squared absolute values.
    pub(crate) fn squared_magnitude(self) -> Interval {
        self.re.square() + self.im.square()
    }

    /// The squares of its numbers.
    pub(crate) fn square(self) -> Self {
        Self { re: self.re.square() - self.im.square(), im: self.re * self.im * 2.0 }
    }
}

impl<R: Field> Add for Complex<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<R: Field> Sub for Complex<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<R: Field> Neg for Complex<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

impl<R: Field> Mul for Complex<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re.clone() * &other.re - self.im.clone() * &other.im,
            im: self.re * &other.im + self.im * &other.re,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use proptest::prelude::*;

    fn holds(interval: Interval, value: &Rational) -> bool {
        let end = |end: f64| Rational::from_f64(end).unwrap();
        end(interval.low) <= *value && *value <= end(interval.high)
    }

    proptest! {
        #[test]
        fn results_of_exact_numbers_lie_inside(values in prop::array::uniform4(-1_000_000_i64..1_000_000), shares in prop::array::uniform2(0u32..=8)) {
            let ratio = |i: usize| Rational::from((values[i], 7919));
            let between = |low: Rational, high: Rational, share: u32| {
                let (low, high) = if low < high { (low, high) } else { (high, low) };
                let inside = Rational::from(&high - &low) * Rational::from((share, 8)) + &low;
                (Interval::enclosing(&low).hull(Interval::enclosing(&high)), inside)
            };
            let ((x, at), (y, other)) = (between(ratio(0), ratio(1), shares[0]), between(ratio(2), ratio(3), shares[1]));
            let (number, square) = (Rectangle { re: x, im: y }, Rational::from(at.square_ref()) + Rational::from(other.square_ref()));
            prop_assert!(holds(number.squared_magnitude(), &square));
            prop_assert!(holds((number * number).im, &(at.clone() * &other * 2u32)));
            prop_assert!(holds(number.square().re, &(at.square() - other.square())));
        }
    }
}
