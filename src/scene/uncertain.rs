//! Values with error bars: `0.009±0.001`, `0.009±10%`, `0.009(1)` or `[0.008, 0.010]`; `+-` and `+/-` have the meaning of `±`.
//!
//! A unit stands behind each number, `8um±1um`, or once behind both, `8±1 um`, `8(1) um` and `[7, 9] um`.

use crate::scene::units::split_unit;
use crate::scene::{AllowedRange, Problem, Quantity, parse_value};
use slipmode_core::friction::ParameterBox;
use slipmode_core::number::{DecimalError, Rational, parse_quotient};

/// All values between two exact ends, ends included; a value without an error bar has equal ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Uncertain {
    /// The least value.
    pub lower: Rational,
    /// The greatest value.
    pub upper: Rational,
}

/// What separates a value from its error.
const SEPARATORS: [&str; 3] = ["±", "+/-", "+-"];

/// The range of both ends.
const RANGE: AllowedRange = AllowedRange::PHYSICAL;

impl Uncertain {
    /// Whether a text has the form of a value with an error bar.
    #[must_use]
    pub fn is_meant(text: &str) -> bool {
        text.trim_start().starts_with('[')
            || in_brackets(text).is_some()
            || SEPARATORS.iter().any(|separator| text.contains(separator))
    }

    /// The value of a quantity, with or without an error bar.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn of(quantity: Quantity, text: &str) -> Result<Self, Problem> {
        Self::parse(text, |number| parse_value(quantity, number))
    }

    /// Whether a text has an error bar that is not 0, or one that is at fault.
    #[must_use]
    pub fn is_wide(quantity: Quantity, text: &str) -> bool {
        Self::is_meant(text) && !Self::of(quantity, text).is_ok_and(|ends| ends.is_certain())
    }

    /// The one value.
    ///
    /// # Errors
    /// What is needed instead, where there is an error bar that is not 0.
    pub fn exact(self, needs: &str) -> Result<Rational, Problem> {
        if self.is_certain() { Ok(self.lower) } else { Err(Problem::Needs(needs.into())) }
    }

    /// A value without an error bar.
    #[must_use]
    pub fn certain(value: Rational) -> Self {
        Self { lower: value.clone(), upper: value }
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

    /// All values of the seven quantities; none unless they are positive.
    #[must_use]
    pub fn region(values: [Self; 7]) -> Option<ParameterBox> {
        let lower = values.each_ref().map(|ends| ends.lower.clone());
        ParameterBox::new(lower.into(), values.map(|ends| ends.upper).into())
    }

    /// A value with or without an error bar. `read` reads each of its numbers as it reads a number that stands alone.
    ///
    /// # Errors
    /// When `read` refuses a number, an end lies outside of the range, or the lower end is above the upper one.
    pub fn parse(text: &str, read: impl Fn(&str) -> Result<Rational, Problem>) -> Result<Self, Problem> {
        if let Some(range) = text.trim_start().strip_prefix('[') {
            return Self::between(range, read);
        }
        if let Some((value, digits)) = in_brackets(text) {
            return Self::with_last_digits(value, digits, read);
        }
        let Some((value, error)) = SEPARATORS.iter().find_map(|separator| text.split_once(separator)) else {
            return read(text).map(Self::certain);
        };
        if let Some((share, unit)) = error.split_once('%') {
            let value = read(&with_unit(value, unit.trim()))?;
            return Self::around(&value, &format!("{}%", share.trim()), read);
        }
        if unit_of(error).is_empty() && !unit_of(value).is_empty() {
            return Err(Problem::ErrorBar(UNITS_DIFFER));
        }
        Self::around(&read(&with_unit(value, unit_of(error)))?, error, &read)
    }

    /// A range, from behind its first bracket on.
    fn between(range: &str, read: impl Fn(&str) -> Result<Rational, Problem>) -> Result<Self, Problem> {
        let parts = range.split_once(']').and_then(|(ends, unit)| Some((ends.split_once([';', ','])?, unit)));
        let ((lower, upper), unit) = parts.ok_or(Problem::ErrorBar("a range has the form [lower, upper]"))?;
        let upper = with_unit(upper, unit.trim());
        let ends = Self { lower: read(&with_unit(lower, unit_of(&upper)))?, upper: read(&upper)? };
        let reversed = "reversed range: the lower end is greater than the upper one";
        if ends.lower <= ends.upper { Ok(ends) } else { Err(Problem::ErrorBar(reversed)) }
    }

    /// A value such as `0.0098(5)`: the digits between brackets are the error of its last digits.
    fn with_last_digits(
        value: &str,
        digits: &str,
        read: impl Fn(&str) -> Result<Rational, Problem>,
    ) -> Result<Self, Problem> {
        let of_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let value = value.trim();
        let decimals = value.split_once('.').map_or("", |(_, decimals)| decimals);
        let parts = digits.split_once(')').filter(|(digits, _)| of_digits(digits));
        let is_plain = value.bytes().all(|byte| byte.is_ascii_digit() || b".+-".contains(&byte));
        let (digits, rest) = parts.filter(|_| is_plain).ok_or(Problem::ErrorBar(LAST_DIGITS))?;
        // An exponent stands behind the brackets, and before the unit.
        let behind = format!("1{}", rest.trim_end());
        let (power, unit) = split_unit(&behind);
        if power.get(1..2).is_some_and(|next| !next.eq_ignore_ascii_case("e")) {
            return Err(Problem::ErrorBar(LAST_DIGITS));
        }
        let exponent: i64 = power.get(2..).unwrap_or_default().parse().unwrap_or(0);
        let error_exponent = exponent.saturating_sub(i64::try_from(decimals.len()).unwrap_or(i64::MAX));
        let number = read(&format!("{value}{}{unit}", &power[1..]))?;
        Self::around(&number, &format!("{digits}e{error_exponent}{unit}"), read)
    }

    /// The value with an error bar on both sides, which may be 0 and may be a percentage of the value.
    ///
    /// # Errors
    /// When the error is not a number or is negative, or an end lies outside of the range.
    pub fn around(
        value: &Rational,
        error: &str,
        read: impl Fn(&str) -> Result<Rational, Problem>,
    ) -> Result<Self, Problem> {
        let error = error.trim();
        let size = match error.strip_suffix('%') {
            Some(share) => RANGE.parse(share.trim_end()).map(|share| share * value / 100u32),
            None => read(error),
        };
        let size = match size {
            Err(Problem::NotPositive { .. }) if !error.starts_with('-') => Rational::new(),
            size => size.map_err(|problem| match problem {
                Problem::NotPositive { .. } => Problem::ErrorBar("the error is negative"),
                Problem::OutOfRange { .. } => Problem::ErrorBar(OUT_OF_RANGE),
                Problem::NotANumber { reason: DecimalError::Malformed, .. } => Problem::ErrorBar(NO_NUMBER),
                problem => problem,
            })?,
        };
        if size >= *value {
            let reason = "the error is not smaller than the value: the lower end must be > 0";
            return Err(Problem::ErrorBar(reason));
        }
        Ok(Self { lower: RANGE.check(Rational::from(value - &size))?, upper: RANGE.check(size + value)? })
    }
}

/// Why an error without a unit has no meaning.
pub(crate) const UNITS_DIFFER: &str = "the value has a unit and its error has none";

/// Why brackets have no meaning.
const LAST_DIGITS: &str = "brackets have the error of the last digits, as in 0.0098(5) um";

/// Why an error has no meaning.
const NO_NUMBER: &str = "the error is no number";
/// Why an error has no meaning.
const OUT_OF_RANGE: &str = "the error is out of range (allowed: 0, 1e-300 to 1e300)";

/// A value and what follows a bracket behind it.
fn in_brackets(text: &str) -> Option<(&str, &str)> {
    text.split_once('(').filter(|(value, _)| value.contains(|c: char| c.is_ascii_digit()))
}

/// What follows the number of a text; a fraction and a text without a number have no unit.
fn unit_of(text: &str) -> &str {
    let rest = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE ".contains(c)).trim_end();
    if parse_quotient(text).is_ok() || rest.len() == text.trim().len() { "" } else { rest }
}

/// A number with a unit, unless it has one of its own.
fn with_unit(text: &str, unit: &str) -> String {
    if unit_of(text).is_empty() { format!("{}{unit}", text.trim()) } else { text.trim().to_string() }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

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
    fn brackets_and_percentages_are_errors_too() {
        for (text, bar) in [
            ("0.0098(5)", "0.0098±0.0005"),
            ("0.0098(15)", "0.0098±0.0015"),
            ("120(20)", "120±20"),
            ("1.20(3)e-5", "1.20e-5±3e-7"),
            ("8.0(2) um", "8.0±0.2um"),
            ("2(0)", "2±0"),
            ("0.0126±5%", "0.0126±0.00063"),
            ("8um +/- 2.5 %", "8±0.2um"),
            ("8±2.5% um", "8±0.2um"),
            ("[7; 9] um", "8±1um"),
            ("1/4±1/8", "0.25±0.125"),
            ("0.5/2 ± 50%", "0.25±0.125"),
            ("[1/8, 3/8]", "0.25±0.125"),
        ] {
            assert!(Uncertain::is_meant(text), "{text}");
            assert_eq!(parse(text), parse(bar), "{text}");
            assert!(parse(text).is_ok(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn brackets_have_the_error_of_the_last_digits(
            whole in 1_u32..1000, decimals in "[0-9]{1,6}", digits in 0_u32..1000, exponent in -20_i32..20,
        ) {
            let zeros = decimals.len();
            let value = format!("{whole}.{decimals}");
            let bar = format!("{value}e{exponent}±{digits}e{}", exponent - i32::try_from(zeros).unwrap());
            prop_assert_eq!(parse(&format!("{value}({digits})e{exponent}")), parse(&bar));
        }

        #[test]
        fn any_text_is_refused_or_has_positive_ends_in_order(text in "[0-9.eum±+/()\\[\\]%,; -]{0,24}") {
            if let Ok((lower, upper)) = parse(&text) {
                prop_assert!(lower > 0 && lower <= upper);
            }
        }
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
            ("1±x", "the error is no number"),
            ("1±", "the error is no number"),
            ("1±inf", "the error is no number"),
            ("1±nan", "the error is no number"),
            ("1±1e-320", "the error is out of range"),
            ("1±1e-310um", "the error is out of range"),
            ("sqrt(2)", "not a decimal number"),
            ("1±0.1±0.1", "not a decimal number"),
            ("[1±0.1, 2]", "not a decimal number"),
            ("[1, 2]±0.1", "not a decimal number"),
            ("0.0098(5)3", "as in 0.0098(5)"),
            ("12.3(1.2)", "as in 0.0098(5)"),
            ("8um(1)", "as in 0.0098(5)"),
            ("1(2)", "not smaller than the value"),
            ("1±100%", "not smaller than the value"),
            ("1±-5%", "negative"),
            ("1(1)e-9223372036854775808", "exponent beyond"),
            ("9e299±8e299", "out of range"),
        ] {
            let problem = parse(text).expect_err(text).to_string();
            assert!(problem.contains(reason), "{text}: {problem}");
        }
    }
}
