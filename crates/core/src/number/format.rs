//! Numbers as text, all in one form: plain for 1e-4 ≤ |x| < 1e6, `d.ddde±x` otherwise, ASCII signs.

use rug::float::Round;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

use super::{Ball, parse_decimal};

/// Decimal digits with a sign: ±0.d₁d₂d₃… · 10^exponent.
struct Decimal {
    negative: bool,
    digits: String,
    exponent: i64,
}

impl Decimal {
    fn trimmed(mut self) -> Self {
        let length = self.digits.trim_end_matches('0').len().max(1);
        self.digits.truncate(length);
        self
    }

    /// Lays the digits out; `significant_zeros` says that every digit is meant, so that no zero may be added.
    fn layout(&self, significant_zeros: bool) -> String {
        let sign = if self.negative { "-" } else { "" };
        let count = self.digits.len() as i64;
        let plain = (-3..=6).contains(&self.exponent) && !(significant_zeros && count < self.exponent);
        if !plain {
            let (first, rest) = self.digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            return format!("{sign}{first}{point}{rest}e{}", self.exponent - 1);
        }
        if self.exponent <= 0 {
            return format!("{sign}0.{}{}", "0".repeat(self.exponent.unsigned_abs() as usize), self.digits);
        }
        if count <= self.exponent {
            return format!("{sign}{}{}", self.digits, "0".repeat((self.exponent - count) as usize));
        }
        let (whole, fraction) = self.digits.split_at(self.exponent as usize);
        format!("{sign}{whole}.{fraction}")
    }
}

/// A finite non-zero float rounded to this many digits.
fn decimal_of_float(value: &Float, significant: usize, round: Round) -> Decimal {
    let (negative, digits, exponent) = value.to_sign_string_exp_round(10, Some(significant.max(1)), round);
    Decimal { negative, digits, exponent: i64::from(exponent.unwrap_or(0)) }
}

/// The float rounded to this many significant digits, trailing zeros of the fraction dropped.
#[must_use]
pub fn round_float(value: &Float, significant: usize) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_f64().to_string();
    }
    decimal_of_float(value, significant, Round::Nearest).trimmed().layout(false)
}

/// The f64 rounded to this many significant digits, trailing zeros of the fraction dropped.
#[must_use]
pub fn round_digits(value: f64, significant: usize) -> String {
    round_float(&Float::with_val(53, value), significant)
}

/// The side of a number on which its rounded text lies: a bound in words stays true only there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Not above the number: "at least".
    Below,
    /// Not below the number: "at most".
    Above,
}

/// The f64 rounded to this many significant digits to one side; a number with fewer digits stays as it is.
#[must_use]
pub fn rounded(value: f64, significant: usize, side: Side) -> String {
    parse_decimal(&shortest(value))
        .map_or_else(|_| value.to_string(), |value| decimal_to(&value, significant, Some(side)))
}

/// The ends of a range rounded outward, at most half as wide again: they have more than `significant` digits where these would hide
/// the width.
#[must_use]
pub fn ends_around([low, high]: [f64; 2], significant: usize) -> [String; 2] {
    digits_of_ends(significant, |digits| {
        [rounded(low, digits, Side::Below), rounded(high, digits, Side::Above)]
    })
}

/// As [`ends_around`], of rational numbers.
#[must_use]
pub fn rational_ends_around([low, high]: &[Rational; 2], significant: usize) -> [String; 2] {
    digits_of_ends(significant, |digits| {
        [decimal_to(low, digits, Some(Side::Below)), decimal_to(high, digits, Some(Side::Above))]
    })
}

/// The ends of a range rounded inward, at least half as wide.
#[must_use]
pub fn ends_within([low, high]: [f64; 2], significant: usize) -> [String; 2] {
    digits_of_ends(significant, |digits| {
        [rounded(low, digits, Side::Above), rounded(high, digits, Side::Below)]
    })
}

/// The texts of the fewest digits with which a range keeps its width but for a half.
fn digits_of_ends(significant: usize, texts: impl Fn(usize) -> [String; 2]) -> [String; 2] {
    /// A number of 64 bits reads back from so many digits.
    const ALL_DIGITS: usize = 17;
    let width = |texts: &[String; 2]| {
        let [low, high] = texts.each_ref().map(|text| text.parse().unwrap_or(f64::NAN));
        high - low
    };
    let all = texts(ALL_DIGITS);
    let of_all = width(&all);
    let keeps_width = |texts: &[String; 2]| (width(texts) - of_all).abs() <= of_all / 2.0;
    (significant..ALL_DIGITS).map(texts).find(keeps_width).unwrap_or(all)
}

/// The shortest decimal that reads back as the same f64.
#[must_use]
pub fn shortest(value: f64) -> String {
    let mut text = String::new();
    shortest_pieces(value, |piece| text.push_str(piece));
    text
}

/// Hands on [`shortest`] piece by piece: files of millions of rows need no text of their own for each number.
pub fn shortest_pieces(value: f64, mut put: impl FnMut(&str)) {
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format(value);
    if value == 0.0 {
        put("0");
    } else if !value.is_finite() || (1e-4..1e6).contains(&value.abs()) {
        put(text.strip_suffix(".0").unwrap_or(text));
    } else if let Some((digits, exponent)) = text.split_once('e') {
        [digits, "e", exponent.trim_start_matches('+')].into_iter().for_each(put);
    } else {
        with_moved_point(text, put);
    }
}

/// The pieces of `d.ddde±x` for a plain decimal from 1e-5 to 1e-4, or from 1e6 to 1e16.
fn with_moved_point(text: &str, put: impl FnMut(&str)) {
    const EXPONENTS: [&str; 10] = ["6", "7", "8", "9", "10", "11", "12", "13", "14", "15"];
    let unsigned = text.trim_start_matches('-');
    let sign = &text[..text.len() - unsigned.len()];
    let (whole, fraction, exponent) = match unsigned.strip_prefix("0.0000") {
        Some(digits) => (digits, "", "-5"),
        None => {
            let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
            (whole, fraction.trim_end_matches('0'), EXPONENTS[whole.len() - 7])
        }
    };
    let whole = if fraction.is_empty() { whole.trim_end_matches('0') } else { whole };
    let (first, rest) = whole.split_at(1);
    let point = if rest.is_empty() && fraction.is_empty() { "" } else { "." };
    [sign, first, point, rest, fraction, "e", exponent].into_iter().for_each(put);
}

/// Only the digits that are certain, at most `max_digits`: every point of the ball rounds to the printed decimal.
///
/// Trailing zeros are digits too (`2.500` is more certain than `2.5`). A ball that fixes no digit is printed as
/// centre and radius, `0±3e-20`; the radius is rounded up.
#[must_use]
pub fn certain_digits(ball: &Ball, max_digits: usize) -> String {
    if ball.centre().is_zero() && ball.is_exact() {
        return "0".to_owned();
    }
    if !ball.contains_zero() {
        // Rounding may straddle a tie at one length and not at a shorter one, so lengths are tried downwards.
        let certain =
            (-ball.relative_radius_log2() * std::f64::consts::LOG10_2).min(max_digits as f64) as usize;
        let (lower, upper) = (ball.lower(), ball.upper());
        for significant in (1..=(certain + 1).min(max_digits)).rev() {
            let [low, high] = [&lower, &upper].map(|end| decimal_of_float(end, significant, Round::Nearest));
            if low.digits == high.digits && low.exponent == high.exponent {
                return low.layout(true);
            }
        }
    }
    let radius = decimal_of_float(&ball.radius(), 1, Round::Up);
    let radius = if !ball.is_bounded() { "inf".to_owned() } else { radius.layout(false) };
    format!("{}±{radius}", round_float(ball.centre(), 2))
}

/// So many digits of a ball that has two more: its centre, rounded to nearest. Others as [`certain_digits`], which has fewer at a tie.
#[must_use]
pub fn nearest_digits(ball: &Ball, digits: usize) -> String {
    let known = -ball.relative_radius_log2() * std::f64::consts::LOG10_2;
    if ball.contains_zero() || known < digits as f64 + 2.0 {
        return certain_digits(ball, digits);
    }
    decimal_of_float(ball.centre(), digits, Round::Nearest).layout(true)
}

/// The rational as a decimal: exact when it has at most `significant` digits, rounded to nearest (ties to even) otherwise.
#[must_use]
pub fn rational_to_decimal(value: &Rational, significant: usize) -> String {
    decimal_to(value, significant, None)
}

fn decimal_to(value: &Rational, significant: usize, side: Option<Side>) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let significant = significant.max(1);
    // The estimate of ⌊log10⌋ + 1 may be off by one next to a power of ten; the digit count repairs it.
    let estimate =
        Float::with_val(64, value).to_sign_string_exp_round(10, Some(5), Round::Nearest).2.unwrap_or(0);
    let mut exponent = i64::from(estimate);
    let mut digits = scaled_digits(value, significant as i64 - exponent, side);
    if digits.len() < significant {
        exponent -= 1;
        digits = scaled_digits(value, significant as i64 - exponent, side);
    }
    exponent += digits.len() as i64 - significant as i64;
    Decimal { negative: *value < 0, digits, exponent }.trimmed().layout(false)
}

/// The rational exactly: a decimal where one of at most 40 digits is exact, else a fraction.
#[must_use]
pub fn exact_text(value: &Rational) -> String {
    let decimal = rational_to_decimal(value, 40);
    if parse_decimal(&decimal).as_ref() == Ok(value) { decimal } else { value.to_string() }
}

/// The digits of |value|·10^shift rounded to an integer: to a side of the value, else to nearest, ties to even.
fn scaled_digits(value: &Rational, shift: i64, side: Option<Side>) -> String {
    let power = Integer::from(10).pow(u32::try_from(shift.unsigned_abs()).unwrap_or(u32::MAX));
    let magnitude = Rational::from(value.abs_ref());
    let scaled = if shift < 0 { magnitude / power } else { magnitude * power };
    let mut rounded = Integer::from(scaled.floor_ref());
    let fraction = scaled - &rounded;
    let is_up = match side {
        Some(side) => fraction > 0 && (side == Side::Above) == (*value > 0),
        None => fraction > 0.5 || (fraction == 0.5 && rounded.is_odd()),
    };
    rounded += u32::from(is_up);
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use proptest::prelude::*;

    #[test]
    fn one_form_for_all_numbers() {
        let cases = [
            (1e-4, "0.0001"),
            (9.999e-5, "9.999e-5"),
            (1e6, "1e6"),
            (999_999.0, "999999"),
            (-0.5, "-0.5"),
            (1.5964e-4, "0.00015964"),
            (5857.9, "5857.9"),
            (1e-300, "1e-300"),
            (0.0, "0"),
            (100.0, "100"),
        ];
        assert_eq!(shortest(731_768_526_102_604.3), "7.317685261026042e14");
        for (value, text) in cases {
            assert_eq!(shortest(value), text);
            assert_eq!(round_digits(value, 6), text);
        }
        assert_eq!(round_digits(999_999.9, 4), "1e6");
    }

    #[test]
    fn a_bound_is_rounded_to_its_side() {
        assert_eq!(rounded(0.319_2, 3, Side::Above), "0.32");
        assert_eq!(rounded(0.319_2, 3, Side::Below), "0.319");
        assert_eq!(rounded(-0.487_6, 3, Side::Above), "-0.487");
        assert_eq!(rounded(-0.487_6, 3, Side::Below), "-0.488");
        // A number that has no more digits stays as it is, although its binary value lies a little above.
        assert_eq!([Side::Above, Side::Below].map(|side| rounded(0.1, 3, side)), ["0.1", "0.1"]);
    }

    #[test]
    fn the_ends_of_a_range_are_rounded_outward_or_inward() {
        let narrow = [-0.737_712_735_34, -0.737_712_558_03];
        assert_eq!(ends_around(narrow, 6), ["-0.73771274", "-0.73771255"]);
        assert_eq!(ends_within(narrow, 6), ["-0.7377127", "-0.7377126"]);
        assert_eq!(ends_around([3_701.999_55, 3_709.564_34], 6), ["3701.99", "3709.57"]);
        assert_eq!(ends_around([0.1; 2], 6), ["0.1"; 2]);
        assert_eq!(ends_within([2.0 / 3.0; 2], 6), ["0.6666666666666666"; 2]);
        assert_eq!(ends_around([f64::NEG_INFINITY, f64::INFINITY], 6), ["-inf", "inf"]);
    }

    #[test]
    fn certain_digits_are_those_the_radius_guarantees() {
        let ball =
            |centre: f64, radius: f64| Ball::new(Float::with_val(80, centre), Float::with_val(32, radius));
        assert_eq!(certain_digits(&ball(1.596_412e-4, 3e-9), 20), "0.00015964");
        assert_eq!(certain_digits(&ball(2.5, 1e-6), 4), "2.500");
        assert_eq!(certain_digits(&ball(5890.0, 30.0), 20), "5.9e3");
        assert_eq!(certain_digits(&ball(0.0, 2.5e-20), 20), "0±3e-20");
        assert_eq!(certain_digits(&ball(0.0, 0.0), 20), "0");
        assert_eq!(certain_digits(&ball(2.0, f64::INFINITY), 20), "0±inf");
        assert_eq!(certain_digits(&Ball::from(-3), 5), "-3.0000");
        // A tie hides a digit that is known.
        let tie = ball(-66.375, 1e-12);
        assert_eq!([4, 6].map(|digits| nearest_digits(&tie, digits)), ["-66.38", "-66.3750"]);
        assert_eq!(certain_digits(&tie, 4), "-66.4");
        assert_eq!(nearest_digits(&ball(5890.0, 30.0), 4), "5.9e3");
        assert_eq!(nearest_digits(&ball(0.0, 0.0), 4), "0");
    }

    #[test]
    fn a_terminating_rational_is_printed_exactly() {
        assert_eq!(rational_to_decimal(&Rational::from((1, 250)), 17), "0.004");
        assert_eq!(rational_to_decimal(&Rational::from((2, 3)), 5), "0.66667");
        assert_eq!(rational_to_decimal(&Rational::from((-199_999, 2)), 3), "-100000");
        assert_eq!(rational_to_decimal(&parse_decimal("1e-400").unwrap(), 5), "1e-400");
        assert_eq!(rational_to_decimal(&parse_decimal("99999999.9").unwrap(), 4), "1e8");
    }

    proptest! {
        #[test]
        fn a_decimal_of_few_digits_reads_back_as_itself(integer in -10i64.pow(15)..10i64.pow(15), exponent in -30i64..30) {
            let value = parse_decimal(&format!("{integer}e{exponent}")).unwrap();
            prop_assert_eq!(parse_decimal(&rational_to_decimal(&value, 16)).unwrap(), value);
        }

        #[test]
        fn the_ends_of_any_range_are_rounded_outward_or_inward(low in -1e3..1e3_f64, decades in -14..3_i32, mantissa in 0.0..1.0_f64) {
            let high = low + mantissa * libm::exp10(f64::from(decades));
            let texts = [ends_around([low, high], 4), ends_within([low, high], 4), [low, high].map(shortest)];
            let [around, within, exact] = texts.map(|ends| ends.map(|end| parse_decimal(&end).unwrap()));
            prop_assert!(around[0] <= within[0] && within[0] <= within[1] && within[1] <= around[1]);
            prop_assert!(around[0] <= exact[0] && exact[0] <= within[0] && within[1] <= exact[1] && exact[1] <= around[1]);
        }

        #[test]
        fn the_shortest_text_is_as_long_as_that_of_the_standard_library(bits: u64, scale in -8i32..20, integer in -1_000_000i64..1_000_000) {
            let near_one = f64::from_bits(bits) % 1.0 * libm::exp10(f64::from(scale));
            let short = integer as f64 * libm::exp10(f64::from(scale));
            for value in [f64::from_bits(bits), near_one, short, libm::scalbn(1.0, scale * 50)] {
                let is_plain = value == 0.0 || !value.is_finite() || (1e-4..1e6).contains(&value.abs());
                let wanted = if is_plain { format!("{}", value + 0.0) } else { format!("{value:e}") };
                let text = shortest(value);
                prop_assert!(value.is_nan() || text.parse() == Ok(value), "{}", text);
                // The digits differ where two decimals are as near: ours is even, as Python's and those of JSON.
                prop_assert_eq!(text.len(), wanted.len());
                prop_assert_eq!(text.find(['.', 'e']), wanted.find(['.', 'e']));
            }
        }
    }
}
