//! Sets of numbers that enclose the values of expressions: balls of any precision, and intervals of 64-bit numbers.

use super::Function;
use crate::number::{Ball, Field, Interval, Rational, Real};

/// A set of numbers with operations that lose none of the values.
pub trait Enclosure: Field {
    /// An enclosure of a rational.
    #[must_use]
    fn of_rational(value: &Rational, precision_bits: u32) -> Self;

    /// An enclosure of the quotients; none where the divisor may be zero.
    #[must_use]
    fn over(self, divisor: &Self) -> Option<Self>;

    /// An enclosure of the values of a function; none where there may be none, and where the function is not known to this kind of set.
    /// Of a ball that reaches below zero, it is the square root of the part that is not negative.
    #[must_use]
    fn call(self, function: Function) -> Option<Self>;
}

impl Enclosure for Ball {
    fn of_rational(value: &Rational, precision_bits: u32) -> Self {
        Self::from_rational(value, precision_bits)
    }

    fn over(self, divisor: &Self) -> Option<Self> {
        Some(self / divisor).filter(Self::is_bounded)
    }

    fn call(self, function: Function) -> Option<Self> {
        let value = match function {
            Function::Sqrt => self.sqrt(),
            Function::Abs => self.square().sqrt(),
            Function::Ln => self.ln(),
            Function::Exp => self.exp(),
            Function::Asinh => self.asinh(),
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
        };
        Some(value).filter(Self::is_bounded)
    }
}

impl Enclosure for Interval {
    fn of_rational(value: &Rational, _: u32) -> Self {
        Self::enclosing(value)
    }

    fn over(self, divisor: &Self) -> Option<Self> {
        divisor.sign().filter(|sign| sign.is_ne()).map(|_| self / divisor)
    }

    fn call(self, function: Function) -> Option<Self> {
        match function {
            Function::Sqrt => (self.low >= 0.0).then(|| self.square_root()),
            Function::Abs if self.low >= 0.0 => Some(self),
            Function::Abs if self.high <= 0.0 => Some(-self),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_of_64_bits_know_quotients_roots_and_absolute_values() {
        let between = |low: f64, high: f64| Interval { low, high };
        let holds = |found: Option<Interval>, low: f64, high: f64| {
            found.is_some_and(|found| (found.low - low).abs() + (found.high - high).abs() < 1e-12)
        };
        assert!(holds(between(1.0, 2.0).over(&between(2.0, 4.0)), 0.25, 1.0));
        assert!(holds(between(1.0, 4.0).call(Function::Sqrt), 1.0, 2.0));
        assert!(holds(between(1.0, 3.0).call(Function::Abs), 1.0, 3.0));
        assert!(holds(between(-3.0, -1.0).call(Function::Abs), 1.0, 3.0));
        assert!(between(1.0, 2.0).over(&between(-1.0, 1.0)).is_none());
        for function in [Function::Sqrt, Function::Abs, Function::Ln] {
            assert!(between(-1.0, 3.0).call(function).is_none(), "{function:?}");
        }
    }
}
