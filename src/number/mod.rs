//! Numbers: one grammar for decimals, exact rationals, double-double, balls, and the traits that let one equation serve them all.

mod decimal;
mod field;

pub use decimal::{DecimalError, MAX_DIGITS, MAX_EXPONENT, parse_decimal};
pub use field::{Field, Real};
pub use rug::Rational;
