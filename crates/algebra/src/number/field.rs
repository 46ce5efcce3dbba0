//! The traits that let an equation stand once and be evaluated in every number type.

use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Rational;

/// A number that can be added, subtracted, multiplied and divided: `f64`, double-double, ball or [`Rational`].
///
/// Small integers enter by `From<i32>`, which is exact in every implementation.
/// Operators take their right side by value or by reference, so that an equation reads the same for heap numbers.
pub trait Field:
    Clone
    + From<i32>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'r> Add<&'r Self, Output = Self>
    + for<'r> Sub<&'r Self, Output = Self>
    + for<'r> Mul<&'r Self, Output = Self>
    + for<'r> Div<&'r Self, Output = Self>
{
    /// The square of the number (balls and double-doubles do this tighter or faster than a product).
    #[must_use]
    #[inline(always)]
    fn square(&self) -> Self {
        self.clone() * self
    }
}

/// A [`Field`] with square roots: everything but the rationals.
pub trait Real: Field {
    /// The non-negative square root.
    #[must_use]
    fn sqrt(&self) -> Self;
}

impl Field for f64 {}

impl Real for f64 {
    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }
}

impl Field for Rational {
    fn square(&self) -> Self {
        Rational::from(self.square_ref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_and_roots_are_those_of_the_type() {
        assert_eq!(Field::square(&Rational::from((-3, 2))), Rational::from((9, 4)));
        assert_eq!(Real::sqrt(&6.25), 2.5);
    }
}
