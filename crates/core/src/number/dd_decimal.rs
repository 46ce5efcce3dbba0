//! Decimals straight to double-double, without rationals: what nearly every cell of a large file is.
//!
//! Leading zeros are no digits: `0.0001121154052894597` has 16 of them, and costs what `1.121154052894597e-4` does.

use super::{Dd, MAX_DIGITS};

/// Digits that a u64 holds whatever they are.
const DIGITS_OF_WORD: usize = 19;

/// Significant digits that are kept, in two words. Those behind are below a relative 10^-33.
const KEPT_DIGITS: usize = 34;

/// Powers of ten up to this one are exact in double-double: 5^44 has 103 bits.
const LARGEST_POWER: i64 = 44;

/// The powers of ten that are exact in 64 bits.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// A positive decimal of the grammar, to within a relative [`Dd::UNIT`].
///
/// Digits behind the 34th are dropped (10^-33, below 2^-109), those kept are rounded to double-double (2^-107), and divided
/// by a power of ten (15·2^-106). The sum is below [`Dd::UNIT`], which is 16·2^-106.
///
/// `None` for anything else, and for large exponents: [`parse_decimal`](super::parse_decimal) has the last word on those.
#[must_use]
pub fn parse_decimal_to_dd(text: &str) -> Option<Dd> {
    parse_decimal_times_power_to_dd(text, 0)
}

/// As [`parse_decimal_to_dd`], times a power of ten, such as the size of a unit: only the exponent of the decimal moves.
#[must_use]
pub fn parse_decimal_times_power_to_dd(text: &str, power_of_ten: i64) -> Option<Dd> {
    let bytes = text.as_bytes();
    let (whole, rest) = split_digits(bytes);
    let (fraction, rest) = match rest {
        [b'.', rest @ ..] => split_digits(rest),
        _ => (&[][..], rest),
    };
    let exponent = match rest {
        [] => 0,
        [b'e' | b'E', exponent @ ..] => short_exponent(exponent)?,
        _ => return None,
    };
    if whole.len() + fraction.len() > MAX_DIGITS {
        return None;
    }
    let (whole, fraction) = without_leading_zeros(whole, fraction);
    let digits = whole.len() + fraction.1.len();
    let power = exponent - fraction.0 as i64 + power_of_ten;
    if digits <= DIGITS_OF_WORD {
        let mantissa = word(word(0, whole), fraction.1);
        return (mantissa != 0).then(|| scaled(from_word(mantissa), power)).flatten();
    }
    let kept = whole.iter().chain(fraction.1).take(KEPT_DIGITS);
    let mantissa = kept.fold(0u128, |value, digit| value * 10 + u128::from(digit - b'0'));
    scaled(from_two_words(mantissa), power + digits.saturating_sub(KEPT_DIGITS) as i64)
}

fn split_digits(bytes: &[u8]) -> (&[u8], &[u8]) {
    let (eights, _) = bytes.as_chunks::<8>();
    let most = 8 * eights.iter().take_while(|eight| are_digits(**eight)).count();
    let more = bytes[most..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    bytes.split_at(most + more)
}

/// Whether all eight are digits: the upper half of each byte is 3, also after 6 is added.
fn are_digits(eight: [u8; 8]) -> bool {
    let word = u64::from_le_bytes(eight);
    let upper = |word: u64| word & 0xf0f0_f0f0_f0f0_f0f0;
    upper(word) == 0x3030_3030_3030_3030 && upper(word + 0x0606_0606_0606_0606) == 0x3030_3030_3030_3030
}

/// The number of eight digits: pairs, then fours, then all eight, each in its own part of the word.
fn number_of(eight: [u8; 8]) -> u64 {
    let digits = u64::from_le_bytes(eight) & 0x0f0f_0f0f_0f0f_0f0f;
    let pairs = (digits * 10 + (digits >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs * 100 + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    (fours * 10_000 + (fours >> 32)) & 0xffff_ffff
}

/// The significant digits before the point, and behind it with the number of places that the fraction has.
fn without_leading_zeros<'t>(whole: &'t [u8], fraction: &'t [u8]) -> (&'t [u8], (usize, &'t [u8])) {
    let trim = |digits: &'t [u8]| &digits[digits.iter().take_while(|digit| **digit == b'0').count()..];
    let (whole, places) = (trim(whole), fraction.len());
    let fraction = if whole.is_empty() { trim(fraction) } else { fraction };
    (whole, (places, fraction))
}

fn word(start: u64, digits: &[u8]) -> u64 {
    let (eights, rest) = digits.as_chunks::<8>();
    let value = eights.iter().fold(start, |value, eight| value * 100_000_000 + number_of(*eight));
    rest.iter().fold(value, |value, digit| value * 10 + u64::from(digit - b'0'))
}

/// An exponent of one to three digits with an optional sign.
fn short_exponent(text: &[u8]) -> Option<i64> {
    let digits = text.strip_prefix(b"-").or(text.strip_prefix(b"+")).unwrap_or(text);
    if !(1..=3).contains(&digits.len()) || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let magnitude = digits.iter().fold(0, |value, digit| value * 10 + i64::from(digit - b'0'));
    Some(if text.starts_with(b"-") { -magnitude } else { magnitude })
}

/// Both halves are exact, and so is their sum.
fn from_word(mantissa: u64) -> Dd {
    let [high, low] = [mantissa >> 32, mantissa & 0xffff_ffff].map(|half| half as f64);
    Dd::exact_sum(high * 4_294_967_296.0, low)
}

/// The nearest double-double: the nearest f64, and the f64 nearest to what is left.
fn from_two_words(mantissa: u128) -> Dd {
    let high = mantissa as f64;
    // Below 10^34 both fit, and the difference is exact.
    let low = (mantissa as i128 - high as i128) as f64;
    Dd::exact_sum(high, low)
}

fn scaled(mantissa: Dd, power: i64) -> Option<Dd> {
    let magnitude = power.unsigned_abs() as usize;
    let scale = match magnitude {
        0..=22 => Dd::from(POWERS[magnitude]),
        _ if power.abs() <= LARGEST_POWER => Dd::exact_product(1e22, POWERS[magnitude - 22]),
        _ => return None,
    };
    Some(if power < 0 { mantissa / scale } else { mantissa * scale })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::{Float, Rational};

    use super::*;
    use crate::number::format::shortest;
    use crate::number::parse_decimal;

    fn assert_near(text: &str) {
        assert_near_times(text, 0);
    }

    fn assert_near_times(text: &str, power_of_ten: i64) {
        let Some(found) = parse_decimal_times_power_to_dd(text, power_of_ten) else { return };
        let exact = parse_decimal(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let exact = exact * parse_decimal(&format!("1e{power_of_ten}")).unwrap();
        let [hi, lo] = [found.hi(), found.lo()].map(|part| Rational::from_f64(part).unwrap());
        let error = (hi + lo - &exact).abs();
        assert!(error <= exact * Rational::from_f64(Dd::UNIT).unwrap(), "{text}");
    }

    /// An f64 in the three layouts that programs print: with an exponent, plain, and plain with all its digits.
    fn layouts(value: f64) -> [String; 4] {
        [format!("{value:e}"), format!("{value}"), shortest(value), format!("{value:.44}")]
    }

    proptest! {
        #[test]
        fn what_is_accepted_is_the_same_number(text in "[0-9]{0,12}(\\.[0-9]{0,10})?([eE][+-]?[0-9]{1,3})?", power in -20..20i64) {
            assert_near_times(&text, power);
        }

        #[test]
        fn digits_beyond_those_kept_change_less_than_the_unit(text in "0{0,3}[0-9]{0,40}\\.0{0,3}[0-9]{0,50}") {
            assert_near(&text);
        }

        #[test]
        fn every_f64_of_ordinary_size_is_read_in_every_layout(exponent in -20.0..20.0f64) {
            let value = libm::exp10(exponent);
            for text in layouts(value) {
                let found = parse_decimal_to_dd(&text);
                prop_assert!(found.is_some(), "{}", text);
                assert_near(&text);
                let nearest = Float::with_val(53, &parse_decimal(&text).unwrap()).to_f64();
                prop_assert_eq!(found.unwrap().hi(), nearest);
            }
        }
    }

    #[test]
    fn eight_bytes_are_digits_when_each_is() {
        assert!(are_digits(*b"09182736"));
        for byte in 0..=u8::MAX {
            for place in 0..8 {
                let mut eight = *b"01234567";
                eight[place] = byte;
                assert_eq!(are_digits(eight), byte.is_ascii_digit(), "{eight:?}");
            }
        }
        assert_eq!(number_of(*b"12345678"), 12_345_678);
        assert_eq!(number_of(*b"99999999"), 99_999_999);
    }

    #[test]
    fn the_digits_of_two_words_are_rounded_once() {
        for text in ["9".repeat(38), "9".repeat(45), format!("1{}1", "0".repeat(36)), "1".repeat(20)] {
            assert!(parse_decimal_to_dd(&text).is_some(), "{text}");
            assert_near(&text);
            assert_near(&format!("{text}e-40"));
            assert_near(&format!("0.{}{text}", "0".repeat(5)));
        }
    }

    #[test]
    fn what_is_not_positive_or_not_of_the_grammar_is_left_to_the_exact_reader() {
        for text in [
            "",
            ".",
            "e5",
            "1e",
            "1e+",
            "0",
            "0.000",
            "-1",
            "+1",
            " 1",
            "1_0",
            "1e0001",
            "1e45",
            "1e99999999999999999999999",
            "1.2.3",
            "1e5x",
        ] {
            assert!(parse_decimal_to_dd(text).is_none(), "{text}");
        }
        assert!(parse_decimal_to_dd(&format!("1.{}", "1".repeat(MAX_DIGITS))).is_none());
    }
}
