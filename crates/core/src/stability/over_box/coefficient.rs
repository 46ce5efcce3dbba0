//! What coefficients of polynomials over a box are: exact integers, or 64-bit numbers with an error bound.

use rug::Integer;

use super::corners::{Corner, Filtered};
use crate::number::{Rational, nearest_f64};

/// A number of a ring in which a sign can be certain.
pub(super) trait Coefficient: Clone + Default {
    /// The value of a parameter at a corner, in units that are the same for all corners.
    fn of_parameter(filtered: &Filtered<'_>, parameter: usize, corner: Corner) -> Self;
    /// A whole number.
    fn whole(value: &Integer) -> Self;
    /// Adds a number.
    fn add(&mut self, other: &Self);
    /// Adds a product.
    fn add_product(&mut self, left: &Self, right: &Self);
    fn times(&mut self, factor: &Self);
    fn times_small(&mut self, factor: u32);
    /// Whether the number is certainly negative.
    fn is_negative(&self) -> bool;
    /// Whether the number is certainly zero.
    fn is_zero(&self) -> bool;
}

impl Coefficient for Integer {
    fn of_parameter(filtered: &Filtered<'_>, parameter: usize, corner: Corner) -> Self {
        filtered.units().integer(parameter, filtered.region.end(parameter, corner))
    }

    fn add(&mut self, other: &Self) {
        *self += other;
    }

    fn add_product(&mut self, left: &Self, right: &Self) {
        *self += left * right;
    }

    fn whole(value: &Integer) -> Self {
        value.clone()
    }

    fn times(&mut self, factor: &Self) {
        *self *= factor;
    }

    fn times_small(&mut self, factor: u32) {
        *self *= factor;
    }

    fn is_negative(&self) -> bool {
        *self < 0
    }

    fn is_zero(&self) -> bool {
        Self::is_zero(self)
    }
}

/// A 64-bit number and a bound on its absolute error. A bound that is not finite makes nothing certain.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Rough {
    value: f64,
    error: f64,
}

/// Twice the unit roundoff: the rounding of a number, and of products that are bounds.
const ROUNDING: f64 = f64::EPSILON;

/// The roundings of a sum of a few bounds.
const OF_BOUNDS: f64 = 1.0 + 16.0 * f64::EPSILON;

impl Rough {
    /// A rounded result whose operands bring in these errors. Numbers that underflow lose less than the least normal number.
    fn rounded(value: f64, errors: f64) -> Self {
        Self { value, error: (errors + ROUNDING * value.abs()) * OF_BOUNDS + f64::MIN_POSITIVE }
    }
}

impl Coefficient for Rough {
    fn of_parameter(filtered: &Filtered<'_>, parameter: usize, corner: Corner) -> Self {
        Self::rounded(filtered.rounded(corner)[parameter].hi(), 0.0)
    }

    fn add(&mut self, other: &Self) {
        *self = Self::rounded(self.value + other.value, self.error + other.error);
    }

    fn add_product(&mut self, left: &Self, right: &Self) {
        let errors =
            left.value.abs() * right.error + right.value.abs() * left.error + left.error * right.error;
        self.add(&Self::rounded(left.value * right.value, errors));
    }

    fn whole(value: &Integer) -> Self {
        Self::rounded(nearest_f64(&Rational::from(value)), 0.0)
    }

    fn times(&mut self, factor: &Self) {
        let own = std::mem::take(self);
        self.add_product(&own, factor);
    }

    fn times_small(&mut self, factor: u32) {
        let factor = f64::from(factor);
        *self = Self::rounded(self.value * factor, self.error * factor);
    }

    fn is_negative(&self) -> bool {
        self.value < -self.error
    }

    fn is_zero(&self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }
}
