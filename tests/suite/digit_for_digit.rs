//! A thousand printed digits of every root against the texts of PARI/GP and FLINT (tests/vectors), character by character.

use slipmode_core::friction::Groups;
use slipmode_core::number::format::certain_digits;
use slipmode_core::roots::certified_roots;

use crate::hard_cases::{number, rows};

const ROOTS: &str = include_str!("../vectors/roots-1000-digits.txt");
const DIGITS: u32 = 1000;

/// Computed beyond what is printed, so that the last printed digit is certain.
const GUARD_DIGITS: u32 = 12;

/// Sign and significant digits of a decimal, without the point, exponent and outer zeros.
fn significand(text: &str) -> String {
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let sign = if text.starts_with('-') { "-" } else { "" };
    format!("{sign}{}", digits.trim_matches('0'))
}

#[test]
fn every_printed_digit_is_that_of_the_other_programs() {
    let mut expected = rows(ROOTS).skip(1).peekable();
    let mut parts = 0;
    while let Some(first) = expected.peek().cloned() {
        let [eta, kappa, beta] = [0, 1, 2].map(|column| number(first[column]));
        let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
        let found = certified_roots(&groups.characteristic_cubic(), DIGITS + GUARD_DIGITS);
        // Of a pair the vectors list the upper root only.
        for root in found.roots.iter().filter(|root| root.im >= 0) {
            let row = expected.next().unwrap();
            for (part, text) in [(root.re_ball(), row[4]), (root.im_ball(), row[5])] {
                let printed = certain_digits(&part, DIGITS as usize);
                assert_eq!(significand(&printed), significand(text), "{:?}", &row[..3]);
                parts += 1;
            }
        }
    }
    assert_eq!(parts, 214, "both parts of every listed root are compared");
}
