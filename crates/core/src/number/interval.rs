//! Intervals of 64-bit numbers, and rectangles of complex ones. Each operation rounds outwards by one number.
//!
//! An interval is held by its ends, so that products and squares of wide intervals are exact to rounding: [0, 2]² is [0, 4]. Intervals of certified
//! runs are narrow and are held by centre and radius, which machines multiply several times as fast.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Rational, nearest_f64};

/// All numbers from `low` to `high`; the whole line where nothing is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Interval {
    /// All numbers.
    pub(crate) const LINE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// One number.
    pub(crate) const fn point(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// The numbers that are as near to `centre` as `radius` says.
    pub(crate) fn about(centre: f64, radius: f64) -> Self {
        Self::outward(centre - radius, centre + radius)
    }

    /// The thinnest interval that holds a rational number.
    pub(crate) fn enclosing(value: &Rational) -> Self {
        let nearest = nearest_f64(value);
        match Rational::from_f64(nearest) {
            Some(exact) if exact == *value => Self::point(nearest),
            _ => Self::outward(nearest, nearest),
        }
    }

    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::LINE;
        }
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// The least interval that holds two.
    pub(crate) fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The numbers that two have in common, of intervals that have some.
    pub(crate) fn intersection(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The distance of its ends.
    pub(crate) fn width(self) -> f64 {
        self.high - self.low
    }

    /// A number of it, near its middle.
    pub(crate) fn middle(self) -> f64 {
        self.low + 0.5 * (self.high - self.low)
    }

    /// Whether both ends are numbers.
    pub(crate) fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// The squares of its numbers.
    pub(crate) fn square(self) -> Self {
        let product = self * self;
        if self.low <= 0.0 && self.high >= 0.0 { Self { low: 0.0, ..product } } else { product }
    }

    /// The square roots of its numbers that are not negative.
    pub(crate) fn square_root(self) -> Self {
        let root = Self::outward(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Self { low: root.low.max(0.0), ..root }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products =
            [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if products.iter().any(|product| product.is_nan()) {
            return Self::LINE;
        }
        let [first, rest @ ..] = products;
        Self::outward(rest.into_iter().fold(first, f64::min), rest.into_iter().fold(first, f64::max))
    }
}

impl Mul<f64> for Interval {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self * Self::point(factor)
    }
}

impl Div for Interval {
    type Output = Self;

    /// The whole line where the divisor may be zero.
    fn div(self, divisor: Self) -> Self {
        if divisor.low <= 0.0 && divisor.high >= 0.0 {
            return Self::LINE;
        }
        self * Self::outward(1.0 / divisor.high, 1.0 / divisor.low)
    }
}

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

    /// Whether two have a common number.
    pub(crate) fn meets(self, other: Self) -> bool {
        let common = |one: Interval, other: Interval| one.low <= other.high && other.low <= one.high;
        common(self.re, other.re) && common(self.im, other.im)
    }

    /// The complex conjugates.
    pub(crate) fn conjugate(self) -> Self {
        Self { im: -self.im, ..self }
    }

    /// The squared absolute values.
    pub(crate) fn squared_magnitude(self) -> Interval {
        self.re.square() + self.im.square()
    }

    /// One divided by its numbers; the whole plane where one may be zero.
    pub(crate) fn reciprocal(self) -> Self {
        let scale = self.squared_magnitude();
        Self { re: self.re / scale, im: -self.im / scale }
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
            prop_assert!(holds(x + y, &(at.clone() + &other)));
            prop_assert!(holds(x - y, &(at.clone() - &other)));
            prop_assert!(holds(x * y, &(at.clone() * &other)));
            prop_assert!(holds(x.square(), &(at.clone() * &at)) && x.square().low >= 0.0);
            let quotient = x / y;
            if quotient.is_finite() {
                prop_assert!(holds(quotient, &(at.clone() / &other)));
            } else {
                prop_assert!(y.low <= 0.0 && y.high >= 0.0);
            }
            let (number, square) = (Rectangle { re: x, im: y }, Rational::from(at.square_ref()) + Rational::from(other.square_ref()));
            prop_assert!(holds(number.squared_magnitude(), &square));
            prop_assert!(holds((number * number).im, &(at.clone() * &other * 2u32)));
            let inverse = number.reciprocal();
            if inverse.re.is_finite() && inverse.im.is_finite() {
                prop_assert!(holds(inverse.re, &(at.clone() / &square)) && holds(inverse.im, &-(other.clone() / &square)));
            }
            let root = x.square().square_root();
            prop_assert!(holds(root, &at.abs()));
        }
    }

    #[test]
    fn what_is_not_known_is_the_whole_line() {
        assert_eq!(Interval::point(1.0) / Interval { low: -1.0, high: 1.0 }, Interval::LINE);
        assert_eq!(Interval::LINE * Interval::point(0.0), Interval::LINE);
        assert!(!(Interval::LINE - Interval::LINE).is_finite());
    }
}
