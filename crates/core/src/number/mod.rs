//! Numbers: one grammar for decimals, exact rationals, double-double, balls, and the traits that let one equation serve them all.
//!
//! ```
//! use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
//!
//! let third = Rational::from((1, 3));
//! assert_eq!(parse_decimal("0.3333").unwrap() - third, Rational::from((-1, 30_000)));
//! assert_eq!(nearest_f64(&parse_decimal("0.1").unwrap()), 0.1);
//! ```

mod complex;
mod dd_decimal;
pub mod dispatch;
mod double_double;
mod fields;
pub mod format;
pub mod search;
pub mod split_mix;
mod wide;

pub(crate) use complex::{Complex, Rectangle};
pub use dd_decimal::{parse_decimal_times_power_to_dd, parse_decimal_to_dd};
pub use double_double::Dd;
pub(crate) use double_double::select;
pub(crate) use fields::fields;
pub(crate) use slipmode_algebra::number::Interval;
pub use slipmode_algebra::number::{
    Ball, DecimalError, Field, MAX_DIGITS, MAX_EXPONENT, Rational, Real, bits_for_digits, nearest_f64,
    parse_decimal, parse_quotient,
};
pub use wide::Wide;
