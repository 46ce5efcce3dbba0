//! Which numbers an input accepts: a range between two decimals, and the message when it is left.

use std::ops::RangeInclusive;

use crate::scene::Problem;
use crate::scene::units::{unit_for, unit_of, with_unit};
use slipmode_core::friction::{LEAST, MOST, Quantity};
use slipmode_core::number::{DecimalError, Rational, nearest_f64, parse_decimal, parse_quotient};

/// A range of numbers; its ends are decimals, so that messages and checks cannot differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AllowedRange {
    lower: &'static str,
    upper: &'static str,
    ends_included: bool,
}

impl AllowedRange {
    /// Every physical quantity: positive, 1e-300 to 1e300, ends included.
    ///
    /// Far beyond any slider, and far inside what the exact arithmetic can do.
    pub const PHYSICAL: Self = Self { lower: LEAST, upper: MOST, ends_included: true };

    /// Ratios and relative errors strictly between 0 and 1.
    pub const OPEN_UNIT: Self = Self { lower: "0", upper: "1", ends_included: false };

    /// Permitted relative errors of a simulation: its loosest steps still give two digits, and 64-bit numbers have no more than 15.
    pub const SIMULATION_TOLERANCE: Self = Self { lower: "1e-15", upper: "1e-2", ends_included: true };

    /// Stated relative errors of other people's runs: from the rounding of 64-bit numbers to a factor of one and a half.
    pub const RUN_TOLERANCE: Self = Self { lower: "1e-13", upper: "0.5", ends_included: true };

    /// Sizes of small disturbances: above them nothing is linear, below them double-double arithmetic has no digits left.
    pub const AMPLITUDE: Self = Self { lower: "1e-15", upper: "0.1", ends_included: true };

    /// Stiffnesses over a critical one above which steady sliding is stable.
    pub const ABOVE_ONE: Self = Self { lower: "1", upper: MOST, ends_included: false };

    /// The values of b/a of [`crate::fitting::EFFECT_RATIOS`].
    pub const EFFECT_RATIO: Self = Self { lower: "1.2", upper: "5", ends_included: true };

    /// Factors on what a replay may take.
    pub const BUDGET: Self = Self { lower: "1e-6", upper: "1e6", ends_included: true };

    /// The range as messages state it.
    #[must_use]
    pub fn text(&self) -> String {
        if self.ends_included {
            format!("{} to {}", self.lower, self.upper)
        } else {
            format!("{} < value < {}", self.lower, self.upper)
        }
    }

    /// What a number may be, for messages about one that is missing or is none: its size is not at fault.
    #[must_use]
    pub fn wanted(&self) -> String {
        if *self == Self::PHYSICAL { "a positive number".into() } else { self.text() }
    }

    /// Reads a decimal, or a fraction such as `1/3`, exactly and checks that it lies in the range.
    ///
    /// # Errors
    /// When the text is not a number of the grammar, or lies outside.
    pub fn parse(&self, text: &str) -> Result<Rational, Problem> {
        self.check(self.number(text)?)
    }

    /// The value of a decimal or a fraction.
    fn number(&self, text: &str) -> Result<Rational, Problem> {
        let allowed = (*self != Self::PHYSICAL).then(|| self.text());
        parse_quotient(text).map_err(|reason| not_a_number(text, reason, allowed))
    }

    /// Reads a number in this unit of SI, or one that is followed by a unit of its own, which is converted exactly.
    ///
    /// # Errors
    /// As [`Self::parse`], and when the unit is none, or one of another dimension.
    pub fn parse_measured(&self, text: &str, in_si: &str) -> Result<Rational, Problem> {
        let Some((number, unit)) = with_unit(text) else { return self.parse(text) };
        let size = unit_for(unit, in_si).map_err(Problem::Unit)?;
        self.check(self.number(number)? * size)
    }

    /// The value itself when it lies in the range.
    ///
    /// # Errors
    /// When it lies outside; a value that is not positive is named so.
    pub fn check(&self, value: Rational) -> Result<Rational, Problem> {
        let allowed = self.text();
        if value <= 0 {
            return Err(Problem::NotPositive { allowed });
        }
        let [lower, upper] = [self.lower, self.upper].map(|end| parse_decimal(end).unwrap_or_default());
        // A program's 64-bit number for an end may lie just outside.
        let is_end = [&lower, &upper].into_iter().any(|end| value == *end || value == nearest_f64(end));
        let inside = if is_end { self.ends_included } else { lower < value && value < upper };
        if inside { Ok(value) } else { Err(Problem::OutOfRange { allowed }) }
    }
}

/// The value of a quantity from a text: a number in SI, a fraction such as `1/3`, or a number with a unit, such as `8um`.
///
/// # Errors
/// When it is no number, not in the allowed range, or in a unit of another dimension.
pub fn parse_value(quantity: Quantity, text: &str) -> Result<Rational, Problem> {
    AllowedRange::PHYSICAL.parse_measured(text, unit_of(quantity))
}

/// The fault of a text that is no number.
pub(crate) fn not_a_number(text: &str, reason: DecimalError, allowed: Option<String>) -> Problem {
    if has_between_digits(text, b',') {
        Problem::DecimalComma
    } else {
        Problem::NotANumber { reason, allowed }
    }
}

/// Whether a mark stands between two digits of a text.
pub(crate) fn has_between_digits(text: &str, mark: u8) -> bool {
    text.as_bytes()
        .windows(3)
        .any(|part| part[1] == mark && part[0].is_ascii_digit() && part[2].is_ascii_digit())
}

/// A whole number of decimal digits in a range whose end may be `u64::MAX`, which messages leave out.
///
/// # Errors
/// When the text is not a number of the grammar, or one that is not whole or lies outside.
pub fn parse_whole(text: &str, range: &RangeInclusive<u64>) -> Result<u64, Problem> {
    let allowed = whole_range_text(range);
    match (text.parse::<u64>(), parse_decimal(text)) {
        (Ok(value), _) if range.contains(&value) => Ok(value),
        (Ok(_), _) | (_, Ok(_)) => Err(Problem::OutOfRange { allowed }),
        (_, Err(reason)) => Err(Problem::NotANumber { reason, allowed: Some(allowed) }),
    }
}

/// The range in words.
pub(crate) fn whole_range_text(range: &RangeInclusive<u64>) -> String {
    match (range.start(), range.end()) {
        (start, &u64::MAX) => format!("a whole number, {start} or more"),
        (start, end) => format!("a whole number from {start} to {end}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    #[test]
    fn an_end_that_nobody_can_reach_is_not_told() {
        let told = |text: &str, range| parse_whole(text, &range).unwrap_err().to_string();
        assert_eq!(parse_whole("7", &(2..=u64::MAX)), Ok(7));
        assert!(told("1", 2..=u64::MAX).ends_with("(allowed: a whole number, 2 or more)"));
        assert!(told("2.5", 2..=9).ends_with("(allowed: a whole number from 2 to 9)"));
        assert!(told("x", 2..=9).ends_with("(allowed: a whole number from 2 to 9)"));
    }

    #[test]
    fn a_physical_quantity_is_positive_and_finite_in_every_sense() {
        let range = AllowedRange::PHYSICAL;
        assert_eq!(range.parse("0.004").unwrap(), Rational::from((1, 250)));
        assert!(range.parse("1e300").is_ok() && range.parse("1e-300").is_ok());
        for text in ["0", "-1e7", "-0", "0e5"] {
            assert!(matches!(range.parse(text), Err(Problem::NotPositive { .. })), "{text}");
        }
        for text in ["1e400", "1e-400", "1.0000000000000000000001e300", "0.9999999999999999999e-300"] {
            assert!(matches!(range.parse(text), Err(Problem::OutOfRange { .. })), "{text}");
        }
        assert_eq!(range.parse("1,5"), Err(Problem::DecimalComma));
        for text in ["nan", "inf", "1e99999", ""] {
            assert!(matches!(range.parse(text), Err(Problem::NotANumber { .. })), "{text}");
        }
    }

    #[test]
    fn the_range_holds_for_the_value_in_si() {
        let range = AllowedRange::PHYSICAL;
        assert_eq!(range.parse_measured("4mm", "m"), Ok(Rational::from((1, 250))));
        assert_eq!(range.parse_measured("0.004", "m"), Ok(Rational::from((1, 250))));
        assert!(matches!(range.parse_measured("1e300 km", "m"), Err(Problem::OutOfRange { .. })));
        assert!(matches!(range.parse_measured("-8um", "m"), Err(Problem::NotPositive { .. })));
        assert!(matches!(range.parse_measured("1e99999um", "m"), Err(Problem::NotANumber { .. })));
        assert!(matches!(range.parse_measured("um", "m"), Err(Problem::NotANumber { .. })));
        let told = range.parse_measured("2MPa", "Pa/m").unwrap_err().to_string();
        assert_eq!(told, "MPa is a stress; stiffness per area is Pa/m");
    }

    #[test]
    fn a_fraction_is_exact_and_has_no_unit() {
        let read = |text: &str| AllowedRange::PHYSICAL.parse_measured(text, "m");
        for text in ["1/3", " 1 / 3 ", "1e5/3e5", "+0.5/1.5", "-1/-3"] {
            assert_eq!(read(text), Ok(Rational::from((1, 3))), "{text}");
        }
        for text in ["0/3", "1/-3"] {
            assert!(matches!(read(text), Err(Problem::NotPositive { .. })), "{text}");
        }
        for text in ["1/0", "1/3/3", "/3", "1/", "1/3um"] {
            assert!(matches!(read(text), Err(Problem::NotANumber { .. } | Problem::Unit(_))), "{text}");
        }
    }

    #[test]
    fn the_64_bit_number_of_an_end_is_in_the_range() {
        use AllowedRange as Range;
        let closed = [Range::PHYSICAL, Range::SIMULATION_TOLERANCE, Range::EFFECT_RATIO, Range::BUDGET];
        let beyond =
            |end: &str, other: &str| Rational::from_f64(end.parse().unwrap()).unwrap() * number(other);
        for range in closed.into_iter().chain([Range::RUN_TOLERANCE, Range::AMPLITUDE]) {
            for (end, farther) in [(range.lower, "0.9999999999999999"), (range.upper, "1.0000000000000002")] {
                assert!(range.check(beyond(end, "1")).is_ok(), "{end}");
                assert!(range.check(beyond(end, farther)).is_err(), "{end}");
            }
        }
        assert!(Range::OPEN_UNIT.check(beyond("1", "1")).is_err());
    }

    #[test]
    fn the_ends_of_an_open_range_are_outside() {
        let range = AllowedRange::OPEN_UNIT;
        assert!(range.parse("0.5").is_ok());
        assert!(range.parse("1").is_err() && range.parse("0").is_err());
    }
}
