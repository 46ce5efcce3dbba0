//! Intervals of 64-bit numbers, held by their ends, so that products and squares of wide intervals are exact to rounding: [0, 2]² is [0, 4].
//! Each operation rounds outwards by one number.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

use super::{Field, Rational, Real, nearest_f64};

/// All numbers from `low` to `high`; the whole line where nothing is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The least of them.
    pub low: f64,
    /// The greatest of them.
    pub high: f64,
}

impl Interval {
    /// All numbers.
    pub const LINE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// One number.
    #[must_use]
    pub const fn point(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// The numbers that are as near to `centre` as `radius` says.
    #[must_use]
    pub fn about(centre: f64, radius: f64) -> Self {
        Self::outward(centre - radius, centre + radius)
    }

    /// The thinnest interval that holds a rational number.
    #[must_use]
    pub fn enclosing(value: &Rational) -> Self {
        if let (Some(above), Some(below)) = (value.numer().to_i32(), value.denom().to_i32()) {
            let nearest = f64::from(above) / f64::from(below);
            let is_exact = below.count_ones() == 1;
            return if is_exact { Self::point(nearest) } else { Self::outward(nearest, nearest) };
        }
        let nearest = nearest_f64(value);
        match Rational::from_f64(nearest) {
            Some(exact) if exact == *value => Self::point(nearest),
            _ => Self::outward(nearest, nearest),
        }
    }

    #[inline]
    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::LINE;
        }
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// The least interval that holds two.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The numbers that two have in common, of intervals that have some.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The distance of its ends.
    #[must_use]
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// A number of it, near its middle.
    #[must_use]
    pub fn middle(self) -> f64 {
        self.low + 0.5 * (self.high - self.low)
    }

    /// Whether both ends are numbers.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// How all its numbers compare with zero; none where they differ in that.
    #[must_use]
    pub fn sign(self) -> Option<Ordering> {
        let [low, high] = [self.low, self.high].map(|end| end.partial_cmp(&0.0));
        low.filter(|_| low == high)
    }

    /// The squares of its numbers.
    #[must_use]
    pub fn square(self) -> Self {
        let product = self * self;
        if self.low <= 0.0 && self.high >= 0.0 { Self { low: 0.0, ..product } } else { product }
    }

    /// The square roots of its numbers that are not negative.
    #[must_use]
    pub fn square_root(self) -> Self {
        let root = Self::outward(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Self { low: root.low.max(0.0), ..root }
    }
}

// Products below the smallest number are rounded outwards, too: zero is a point only where it was one from the start. Then sums and
// products with it are exact, and no later operation is one with subnormal numbers, which processors are slow at.
impl Interval {
    const ZERO: Self = Self::point(0.0);

    #[inline]
    fn plus(self, other: &Self) -> Self {
        let [low, high] = [self.low + other.low, self.high + other.high];
        if self == Self::ZERO || *other == Self::ZERO { Self { low, high } } else { Self::outward(low, high) }
    }

    #[inline]
    fn minus(self, other: &Self) -> Self {
        self.plus(&-*other)
    }

    #[inline]
    fn times(self, other: &Self) -> Self {
        let (Self { low: a, high: b }, Self { low: c, high: d }) = (self, other);
        // Which ends give the extremes, by where zero lies.
        let (low, high) = if a >= 0.0 {
            (if *c >= 0.0 { a * c } else { b * c }, if *d >= 0.0 { b * d } else { a * d })
        } else if b <= 0.0 {
            (if *d >= 0.0 { a * d } else { b * d }, if *c >= 0.0 { b * c } else { a * c })
        } else if *c >= 0.0 {
            (a * d, b * d)
        } else if *d <= 0.0 {
            (b * c, a * c)
        } else {
            let products = [a * d, b * c, a * c, b * d];
            if products.iter().any(|product| product.is_nan()) {
                return Self::LINE;
            }
            (products[0].min(products[1]), products[2].max(products[3]))
        };
        let is_zero = low == 0.0 && high == 0.0 && (self == Self::ZERO || *other == Self::ZERO);
        if is_zero { Self::ZERO } else { Self::outward(low, high) }
    }

    /// The whole line where the divisor may be zero.
    fn over(self, divisor: &Self) -> Self {
        if divisor.low <= 0.0 && divisor.high >= 0.0 {
            return Self::LINE;
        }
        self.times(&Self::outward(1.0 / divisor.high, 1.0 / divisor.low))
    }
}

crate::implement_operators!(Interval, Add::add => plus, Sub::sub => minus, Mul::mul => times, Div::div => over);

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl From<i32> for Interval {
    fn from(value: i32) -> Self {
        Self::point(f64::from(value))
    }
}

impl Field for Interval {
    fn square(&self) -> Self {
        Interval::square(*self)
    }
}

impl Real for Interval {
    fn sqrt(&self) -> Self {
        self.square_root()
    }
}

impl Mul<f64> for Interval {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self * Self::point(factor)
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
            let root = x.square().square_root();
            prop_assert!(holds(root, &at.abs()));
        }
    }

    #[test]
    fn a_rational_is_enclosed_thinly() {
        for (above, below) in [(1, 3), (-7, 8), (0, 1), (1, 1 << 30), (i64::MAX, 3), (1 << 60, 1)] {
            let value = Rational::from((above, below));
            let found = Interval::enclosing(&value);
            assert!(holds(found, &value), "{value}");
            let is_exact = Rational::from_f64(found.low) == Some(value.clone());
            assert!(if is_exact {
                found.low == found.high
            } else {
                found.width() < nearest_f64(&value).abs() * 1e-15
            });
            assert_eq!(found.sign(), Some(value.cmp0()));
        }
        assert_eq!(Interval { low: 0.0, high: 1.0 }.sign(), None);
        assert_eq!(Interval::LINE.sign(), None);
    }

    #[test]
    fn what_is_not_known_is_the_whole_line() {
        assert_eq!(Interval::point(1.0) / Interval { low: -1.0, high: 1.0 }, Interval::LINE);
        assert_eq!(Interval::LINE * Interval::point(0.0), Interval::LINE);
        assert!(!(Interval::LINE - Interval::LINE).is_finite());
    }

    #[test]
    fn an_interval_has_its_ends_middle_and_width() {
        let x = Interval { low: 2.0, high: 5.0 };
        assert_eq!((x.width(), x.middle()), (3.0, 3.5));
        assert!(holds(x * -2.0, &Rational::from(-10)) && !holds(x * -2.0, &Rational::from(-3)));
        let about = Interval::about(10.0, 3.0);
        assert!(
            holds(about, &Rational::from(7)) && holds(about, &Rational::from(13)) && about.width() < 6.001
        );
        assert!(
            !Interval { low: 0.0, ..Interval::LINE }.is_finite()
                && Interval::point(-2.0).square().low > 3.999
        );
        assert_eq!(Interval { low: 0.0, high: 1.0 }.square_root().low, 0.0);
        assert_eq!(Interval::enclosing(&(Rational::from(1) << 60)).width(), 0.0);
    }
}
