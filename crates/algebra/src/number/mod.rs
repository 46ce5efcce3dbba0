//! Numbers: one grammar for decimals, exact rationals, balls, and the traits that let one equation serve them all.
//!
//! ```
//! use slipmode_algebra::number::{Rational, nearest_f64, parse_decimal};
//!
//! let third = Rational::from((1, 3));
//! assert_eq!(parse_decimal("0.3333").unwrap() - third, Rational::from((-1, 30_000)));
//! assert_eq!(nearest_f64(&parse_decimal("0.1").unwrap()), 0.1);
//! ```

mod ball;
mod ball_arithmetic;
mod decimal;
mod field;
mod interval;
mod magnitude;
mod operators;

pub use ball::{Ball, bits_for_digits};
pub use decimal::{DecimalError, MAX_DIGITS, MAX_EXPONENT, nearest_f64, parse_decimal, parse_quotient};
pub use field::{Field, Real};
pub use interval::Interval;
pub use rug::Rational;
