//! Values with error bars: `0.009±0.001`, `0.009+-0.001` or `[0.008, 0.010]`.
//!
//! A unit stands behind each number, `8um±1um`, or once behind both, `8±1 um` and `[7, 9] um`.

use crate::scene::{AllowedRange, Problem};
use slipmode_core::number::Rational;

/// All values between two exact ends, ends included; a value without an error bar has equal ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Uncertain {
    /// The least value.
    pub lower: Rational,
    /// The greatest value.
    pub upper: Rational,
}

/// What separates a value from its error.
const SEPARATORS: [&str; 2] = ["±", "+-"];

/// The range of both ends.
const RANGE: AllowedRange = AllowedRange::PHYSICAL;

impl Uncertain {
    /// Whether a text has the form of a value with an error bar.
    #[must_use]
    pub fn is_meant(text: &str) -> bool {
        text.trim_start().starts_with('[') || SEPARATORS.iter().any(|separator| text.contains(separator))
    }

    /// Whether both ends are the same.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.lower == self.upper
    }

    /// The value half-way between the ends.
    #[must_use]
    pub fn middle(&self) -> Rational {
        Rational::from(&self.lower + &self.upper) / 2u32
    }

    /// A value with or without an error bar. `read` reads each of its numbers as it reads a number that stands alone.
    ///
    /// # Errors
    /// When `read` refuses a number, an end lies outside of the range, or the lower end is above the upper one.
    pub fn parse(text: &str, read: impl Fn(&str) -> Result<Rational, Problem>) -> Result<Self, Problem> {
        if let Some(range) = text.trim_start().strip_prefix('[') {
            let parts = range.split_once(']').and_then(|(ends, unit)| Some((ends.split_once(',')?, unit)));
            let ((lower, upper), unit) = parts.ok_or_else(|| fault("a range has the form [lower, upper]"))?;
            let upper = with_unit(upper, unit.trim());
            let ends = Self { lower: read(&with_unit(lower, unit_of(&upper)))?, upper: read(&upper)? };
            let reversed = "reversed range: the lower end is greater than the upper one";
            return if ends.lower <= ends.upper { Ok(ends) } else { Err(fault(reversed)) };
        }
        let Some((value, error)) = SEPARATORS.iter().find_map(|separator| text.split_once(separator)) else {
            return read(text).map(|value| Self { lower: value.clone(), upper: value });
        };
        if unit_of(error).is_empty() && !unit_of(value).is_empty() {
            return Err(fault("the value has a unit and its error has none"));
        }
        Self::around(read(&with_unit(value, unit_of(error)))?, error, &read)
    }

    /// The value with an error bar on both sides, which may be 0.
    ///
    /// # Errors
    /// When the error is not a number or is negative, or an end lies outside of the range.
    pub fn around(
        value: Rational,
        error: &str,
        read: impl Fn(&str) -> Result<Rational, Problem>,
    ) -> Result<Self, Problem> {
        let error = error.trim();
        let size = match read(error) {
            Err(Problem::NotPositive { .. }) if error.starts_with('-') => {
                return Err(fault("the error is negative"));
            }
            Err(Problem::NotPositive { .. }) => Rational::new(),
            size => size?,
        };
        if size >= value {
            return Err(fault("the error is not smaller than the value: the lower end must be > 0"));
        }
        Ok(Self { lower: RANGE.check(Rational::from(&value - &size))?, upper: RANGE.check(value + size)? })
    }
}

fn fault(reason: &'static str) -> Problem {
    Problem::ErrorBar { reason, allowed: RANGE.text() }
}

/// What follows the number of a text; the denominator of a fraction is no unit.
fn unit_of(text: &str) -> &str {
    let rest = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE ".contains(c)).trim_end();
    let is_denominator =
        |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if rest.strip_prefix('/').is_some_and(is_denominator) { "" } else { rest }
}

/// A number with a unit, unless it has one of its own.
fn with_unit(text: &str, unit: &str) -> String {
    if unit_of(text).is_empty() { format!("{}{unit}", text.trim()) } else { text.trim().to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads numbers, those of length in um too.
    fn read(text: &str) -> Result<Rational, Problem> {
        let number = text.strip_suffix("um").map(|text| RANGE.parse(text.trim()));
        number.map_or_else(|| RANGE.parse(text), |value| Ok(value? / 1_000_000u32))
    }

    fn parse(text: &str) -> Result<(Rational, Rational), Problem> {
        Uncertain::parse(text, read).map(|ends| (ends.lower, ends.upper))
    }

    #[test]
    fn the_three_forms_have_the_same_exact_ends() {
        let ends = (Rational::from((8, 1000)), Rational::from((10, 1000)));
        for text in ["0.009±0.001", "0.009+-0.001", "9e-3 ± 1e-3", "[0.008, 0.010]", " [8e-3,1e-2] "] {
            assert!(Uncertain::is_meant(text), "{text}");
            assert_eq!(parse(text).as_ref(), Ok(&ends), "{text}");
        }
        assert!(!Uncertain::is_meant("9e-3"));
        assert_eq!(
            parse(" 9e-3"),
            RANGE.parse(" 9e-3").map(|value| (value.clone(), value)),
            "a number alone"
        );
        assert_eq!(parse("9e-3"), Ok((Rational::from((9, 1000)), Rational::from((9, 1000)))));
        assert_eq!(parse("2±0"), Ok((Rational::from(2), Rational::from(2))));
    }

    #[test]
    fn a_unit_behind_both_numbers_is_that_of_each() {
        let ends = (Rational::from((7, 1_000_000)), Rational::from((9, 1_000_000)));
        for text in ["8um±1um", "8±1um", "8 ± 1 um", "[7, 9] um", "[7um, 9um]", "[7, 9um]"] {
            assert_eq!(parse(text).as_ref(), Ok(&ends), "{text}");
        }
        assert!(parse("8um±1").expect_err("no unit").to_string().contains("its error has none"));
    }

    #[test]
    fn a_bar_without_a_meaning_is_refused_with_its_reason() {
        for (text, reason) in [
            ("1±1", "not smaller than the value"),
            ("1±2", "not smaller than the value"),
            ("1±-0.5", "negative"),
            ("[2, 1]", "reversed"),
            ("[1 2]", "[lower, upper]"),
            ("[1, 2", "[lower, upper]"),
            ("[-1, 2]", "must be > 0"),
            ("[0, 2]", "must be > 0"),
            ("[1, 2, 3]", "not a decimal number"),
            ("1±x", "not a decimal number"),
            ("1±", "not a decimal number"),
            ("1±0.1±0.1", "not a decimal number"),
            ("[1±0.1, 2]", "not a decimal number"),
            ("[1, 2]±0.1", "not a decimal number"),
            ("9e299±8e299", "out of range"),
        ] {
            let problem = parse(text).expect_err(text).to_string();
            assert!(problem.contains(reason), "{text}: {problem}");
        }
    }
}
