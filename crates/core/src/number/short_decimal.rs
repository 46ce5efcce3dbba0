//! Short decimals straight to double-double, without rationals: what nearly every cell of a large file is.

use super::Dd;

/// The most digits: what a u64 holds whatever they are.
const MOST_DIGITS: usize = 19;

/// Powers of ten up to this one are exact in double-double: 5^44 has 103 bits.
const LARGEST_POWER: i64 = 44;

/// The powers of ten that are exact in 64 bits.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// A positive decimal of the grammar, to within a relative [`Dd::UNIT`].
///
/// `None` for anything else, for more than 19 digits and for large exponents: [`parse_decimal`](super::parse_decimal)
/// has the last word on those.
#[must_use]
pub fn parse_short_decimal(text: &str) -> Option<Dd> {
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
    if whole.len() + fraction.len() > MOST_DIGITS {
        return None;
    }
    let mantissa =
        whole.iter().chain(fraction).fold(0u64, |value, digit| value * 10 + u64::from(digit - b'0'));
    let power = exponent - fraction.len() as i64;
    (mantissa != 0).then(|| scaled(mantissa, power)).flatten()
}

fn split_digits(bytes: &[u8]) -> (&[u8], &[u8]) {
    bytes.split_at(bytes.iter().take_while(|byte| byte.is_ascii_digit()).count())
}

/// An exponent of one to three digits with an optional sign.
fn short_exponent(text: &[u8]) -> Option<i64> {
    let (negative, digits) = match text {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if !(1..=3).contains(&digits.len()) || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let magnitude = digits.iter().fold(0, |value, digit| value * 10 + i64::from(digit - b'0'));
    Some(if negative { -magnitude } else { magnitude })
}

fn scaled(mantissa: u64, power: i64) -> Option<Dd> {
    // Both halves are exact, and so is their sum.
    let [high, low] = [mantissa >> 32, mantissa & 0xffff_ffff].map(|half| half as f64);
    let mantissa = Dd::exact_sum(high * 4_294_967_296.0, low);
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
    use crate::number::parse_decimal;

    fn assert_near(text: &str) {
        let Some(found) = parse_short_decimal(text) else { return };
        let exact = parse_decimal(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let [hi, lo] = [found.hi(), found.lo()].map(|part| Rational::from_f64(part).unwrap());
        let error = (hi + lo - &exact).abs();
        assert!(error <= exact * Rational::from_f64(Dd::UNIT).unwrap(), "{text}");
    }

    proptest! {
        #[test]
        fn what_is_accepted_is_the_same_number(text in "[0-9]{0,12}(\\.[0-9]{0,10})?([eE][+-]?[0-9]{1,3})?") {
            assert_near(&text);
        }

        #[test]
        fn every_f64_of_ordinary_size_is_read(value in 1e-20..1e20f64) {
            let text = format!("{value:e}");
            prop_assert!(parse_short_decimal(&text).is_some());
            assert_near(&text);
            let nearest = Float::with_val(53, &parse_decimal(&text).unwrap()).to_f64();
            prop_assert_eq!(parse_short_decimal(&text).unwrap().hi(), nearest);
        }
    }

    #[test]
    fn what_is_not_short_or_not_positive_is_left_to_the_exact_reader() {
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
            assert!(parse_short_decimal(text).is_none(), "{text}");
        }
        assert!(parse_short_decimal(&"1".repeat(20)).is_none());
        assert!(parse_short_decimal(&"9".repeat(19)).is_some());
    }
}
