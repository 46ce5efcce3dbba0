//! One grammar for every number a user writes: scene files, CSV cells and command-line arguments.
//!
//! A decimal *is* a rational: `0.004` is 1/250, not the nearest binary number.

use std::cmp::Ordering;

use rug::float::Round;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};
use thiserror::Error;

/// The most digits a number may have (integer and fraction part together).
pub const MAX_DIGITS: usize = 10_000;

/// The largest exponent of ten, either sign.
pub const MAX_EXPONENT: i64 = 10_000;

/// Why a text is not a number of the grammar.
///
/// ```
/// use slipmode_algebra::number::{DecimalError, parse_decimal};
///
/// let error: DecimalError = parse_decimal("four").unwrap_err();
/// assert!(!error.to_string().is_empty());
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DecimalError {
    /// Not of the form `[+-]digits[.digits][e[+-]digits]`.
    #[error("not a decimal number (write digits such as 0.004 or 1e-5)")]
    Malformed,
    /// More than [`MAX_DIGITS`] digits.
    #[error("more than {MAX_DIGITS} digits")]
    TooManyDigits,
    /// Exponent beyond ±[`MAX_EXPONENT`].
    #[error("exponent beyond ±{MAX_EXPONENT}")]
    ExponentOutOfRange,
    /// A quotient of two numbers, the second of which is zero.
    #[error("a division by zero")]
    DivisionByZero,
}

/// Reads `[+-]digits[.digits][e[+-]digits]` (or `.digits`) exactly.
///
/// # Errors
/// When the text is not of the grammar, or exceeds the caps on digits and exponent.
///
/// ```
/// use slipmode_algebra::number::{Rational, parse_decimal};
///
/// assert_eq!(parse_decimal("0.004"), Ok(Rational::from((1, 250))));
/// assert_eq!(parse_decimal("-1.5e-3"), Ok(Rational::from((-3, 2000))));
/// assert!(parse_decimal("1,5").is_err());
/// ```
pub fn parse_decimal(text: &str) -> Result<Rational, DecimalError> {
    let (negative, unsigned) = strip_sign(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
        None => (unsigned, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.len() + fraction.len();
    if digits == 0 || !whole.bytes().chain(fraction.bytes()).all(|byte| byte.is_ascii_digit()) {
        return Err(DecimalError::Malformed);
    }
    if digits > MAX_DIGITS {
        return Err(DecimalError::TooManyDigits);
    }
    let joined = format!("{whole}{fraction}");
    let integer: Integer = joined.parse().map_err(|_| DecimalError::Malformed)?;
    // The digit cap keeps the fraction's length far inside i64.
    let value = scale_by_power_of_ten(integer, exponent - fraction.len() as i64);
    Ok(if negative { -value } else { value })
}

/// Reads a decimal, or a quotient of two such as `1/3`, exactly.
///
/// # Errors
/// As [`parse_decimal`] for each of the two, and when the second one is zero.
///
/// ```
/// use slipmode_algebra::number::{DecimalError, Rational, parse_quotient};
///
/// assert_eq!(parse_quotient("-1.5/3"), Ok(Rational::from((-1, 2))));
/// assert_eq!(parse_quotient("1/0"), Err(DecimalError::DivisionByZero));
/// ```
pub fn parse_quotient(text: &str) -> Result<Rational, DecimalError> {
    let Some((above, below)) = text.split_once('/') else { return parse_decimal(text.trim()) };
    let (above, below) = (parse_decimal(above.trim())?, parse_decimal(below.trim())?);
    if below == 0 { Err(DecimalError::DivisionByZero) } else { Ok(above / below) }
}

fn strip_sign(text: &str) -> (bool, &str) {
    match text.as_bytes().first() {
        Some(b'-') => (true, &text[1..]),
        Some(b'+') => (false, &text[1..]),
        _ => (false, text),
    }
}

fn parse_exponent(text: &str) -> Result<i64, DecimalError> {
    let (negative, digits) = strip_sign(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(DecimalError::Malformed);
    }
    // Too long for i64 is certainly out of range; leading zeros are harmless.
    let magnitude: i64 = digits.parse().unwrap_or(i64::MAX);
    if magnitude > MAX_EXPONENT {
        return Err(DecimalError::ExponentOutOfRange);
    }
    Ok(if negative { -magnitude } else { magnitude })
}

fn scale_by_power_of_ten(integer: Integer, exponent: i64) -> Rational {
    let power = Integer::from(10).pow(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
    if exponent < 0 { Rational::from((integer, power)) } else { Rational::from(integer * power) }
}

/// The f64 nearest to a rational number, ties to even, subnormal numbers included.
///
/// The conversions of `rug` round towards zero.
#[must_use]
pub fn nearest_f64(value: &Rational) -> f64 {
    // Rounded to odd first: whatever is lost is then still seen by the second rounding, to however few bits.
    let (mut odd, lost) = Float::with_val_round(64, value, Round::Zero);
    let is_even = odd.get_significand().is_some_and(|significand| significand.is_even());
    if lost != Ordering::Equal && is_even {
        if *value > 0 { odd.next_up() } else { odd.next_down() }
    }
    odd.to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_is_the_rational_it_says() {
        assert_eq!(parse_decimal("0.004").unwrap(), Rational::from((1, 250)));
        assert_eq!(parse_decimal("-1.5e-3").unwrap(), Rational::from((-3, 2000)));
        assert_eq!(parse_decimal("+.5E2").unwrap(), Rational::from(50));
        assert_eq!(parse_decimal("1e0000000000000000000000002").unwrap(), Rational::from(100));
        assert_eq!(parse_decimal("0e-5").unwrap(), Rational::new());
    }

    #[test]
    fn the_nearest_f64_is_that_of_the_standard_library_down_to_the_smallest() {
        for text in [
            "0.1",
            "-0.3",
            "1e23",
            "9007199254740993",
            "9007199254740993.00000000000000000001",
            "4.9e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.2250738585072011e-308",
            "1e400",
            "-1e-400",
            "0",
        ] {
            assert_eq!(nearest_f64(&parse_decimal(text).unwrap()), text.parse::<f64>().unwrap(), "{text}");
        }
        // Half-way between two subnormal numbers, and a little above: one rounding, not two.
        let tie = Rational::from((3, 1)) / (Rational::from(1) << 1075_u32);
        assert_eq!(nearest_f64(&tie), libm::ldexp(2.0, -1074));
        let above = Rational::from((1, 1)) / (Rational::from(1) << 1075_u32)
            * parse_decimal("1.00000000000000000000000001").unwrap();
        assert_eq!(nearest_f64(&above), libm::ldexp(1.0, -1074));
    }

    #[test]
    fn what_is_not_of_the_grammar_is_refused() {
        for text in [
            "", ".", "-", "e5", "1e", "nan", "inf", "0x1p3", "1@5", "1,5", " 1", "1 ", "1/2", "1_000", "--1",
            "١",
        ] {
            assert_eq!(parse_decimal(text), Err(DecimalError::Malformed), "{text:?}");
        }
    }

    #[test]
    fn caps_are_enforced_before_any_large_number_is_made() {
        assert_eq!(parse_decimal("1e10001"), Err(DecimalError::ExponentOutOfRange));
        assert_eq!(parse_decimal("1e-99999999999999999999999"), Err(DecimalError::ExponentOutOfRange));
        assert_eq!(parse_decimal(&"1".repeat(10_001)), Err(DecimalError::TooManyDigits));
        assert!(parse_decimal("1e-400").unwrap() > 0);
    }

    #[test]
    fn quotients_and_numbers_at_the_caps_are_read() {
        assert_eq!(parse_quotient("-1.5/3"), Ok(Rational::from((-1, 2))));
        assert_eq!(parse_quotient(" 6 / 4 "), Ok(Rational::from((3, 2))));
        assert_eq!(parse_quotient("1/0"), Err(DecimalError::DivisionByZero));
        assert!(parse_decimal(&"1".repeat(MAX_DIGITS)).is_ok() && parse_decimal("1e10000").is_ok());
    }
}
