//! Numbers: one grammar for decimals, exact rationals, double-double, balls, and the traits that let one equation serve them all.
//!
//! ```
//! use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
//!
//! let third = Rational::from((1, 3));
//! assert_eq!(parse_decimal("0.3333").unwrap() - third, Rational::from((-1, 30_000)));
//! assert_eq!(nearest_f64(&parse_decimal("0.1").unwrap()), 0.1);
//! ```

mod ball;
mod ball_arithmetic;
mod dd_decimal;
mod decimal;
mod double_double;
mod field;
#[doc(hidden)]
pub mod format;
mod interval;
mod magnitude;
mod operators;
#[doc(hidden)]
pub mod split_mix;
mod wide;

pub use ball::{Ball, bits_for_digits};
#[doc(hidden)]
pub use dd_decimal::parse_decimal_to_dd;
pub use decimal::{DecimalError, MAX_DIGITS, MAX_EXPONENT, nearest_f64, parse_decimal};
pub use double_double::Dd;
pub use field::{Field, Real};
pub(crate) use interval::{Interval, Rectangle};
pub use rug::Rational;
pub use wide::Wide;
