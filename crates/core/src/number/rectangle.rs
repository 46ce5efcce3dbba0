//! Rectangles of complex numbers. Each operation rounds outwards.

use std::ops::{Add, Mul, Sub};

use slipmode_algebra::number::Interval;

/// All complex numbers with real and imaginary part in two intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rectangle {
    pub(crate) re: Interval,
    pub(crate) im: Interval,
}

impl Rectangle {
    /// Real numbers.
    pub(crate) const fn real(re: Interval) -> Self {
        Self { re, im: Interval::point(0.0) }
    }

    /// The squared absolute values.
    pub(crate) fn squared_magnitude(self) -> Interval {
        self.re.square() + self.im.square()
    }

    /// The squares of its numbers.
    pub(crate) fn square(self) -> Self {
        Self { re: self.re.square() - self.im.square(), im: self.re * self.im * 2.0 }
    }
}

impl Add for Rectangle {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Rectangle {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Rectangle {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Mul<Interval> for Rectangle {
    type Output = Self;

    fn mul(self, factor: Interval) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
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
