//! What can be reached, and numbers in the units of a laboratory: a number out of reach is replaced by words.

use crate::scene::{Quantity, unit_of};
use slipmode_core::number::format::{Side, rational_to_decimal, round_digits, rounded};
use slipmode_core::number::parse_decimal;

/// The least and the greatest value that an experiment or a fault can have, in SI; all seven limits are wide.
///
/// K: the softest spring on a square metre, and a micrometre of rock. M: a sheet of paper is 0.1 kg/m², a crust of 40 km is 1e8.
/// σ: 1 Pa is 0.1 kg on a square metre, and the deepest earthquakes are at 2e10. V0: 1e-12 m/s is 0.03 mm a year, and seismic slip reaches 10 m/s.
pub(crate) fn reach(quantity: Quantity) -> [f64; 2] {
    match quantity {
        Quantity::DirectEffect | Quantity::EvolutionEffect => [1e-6, 1.0],
        Quantity::CriticalSlipDistance => [1e-10, 100.0],
        Quantity::Stiffness => [1e2, 1e17],
        Quantity::MassPerArea => [1e-3, 1e9],
        Quantity::NormalStress => [1.0, 1e11],
        Quantity::LoadingVelocity => [1e-12, 10.0],
    }
}

/// Whether a value can be reached.
pub(crate) fn is_within_reach(quantity: Quantity, value: f64) -> bool {
    let [low, high] = reach(quantity);
    (low..=high).contains(&value)
}

/// Digits of a number in a sentence.
pub(crate) const DIGITS: usize = 3;

/// Digits that show how far a factor is from 1.
pub(crate) fn digits_of_factor(factor: f64) -> usize {
    let beyond = -libm::floor(libm::log10((factor - 1.0).abs().max(1e-9)));
    DIGITS.max(beyond as usize + 1)
}

/// The prefixes of units, from 1e-9 to 1e12.
const PREFIXES: [&str; 8] = ["n", "µ", "m", "", "k", "M", "G", "T"];

/// The number and the unit of a value, such as `5` and `MPa`; rounded to one side, or else to nearest.
fn parts(value: f64, unit: &str, side: Option<Side>) -> (String, String) {
    let shown = side.map_or_else(|| round_digits(value, DIGITS), |side| rounded(value, DIGITS, side));
    // A kilogram has a prefix, and a number without unit can have none.
    let takes_a_prefix = !unit.is_empty() && unit != "1" && !unit.starts_with("kg");
    let thousands = if takes_a_prefix { libm::floor(libm::log10(value) / 3.0 + 1e-12) } else { 0.0 };
    // Nobody counts in kiloseconds.
    let thousands = thousands.clamp(-3.0, if unit == "s" { 0.0 } else { 4.0 });
    let prefixed = || format!("{}{}", PREFIXES[(thousands + 3.0) as usize], unit.replace("^2", "²"));
    let unit = if unit == "1" { String::new() } else { prefixed() };
    // The digits are those of the value itself: a product may be rounded across them.
    let scale = parse_decimal(&format!("1e{}", -3.0 * thousands));
    let scaled = parse_decimal(&shown).and_then(|value| Ok(value * scale?));
    (scaled.map_or(shown, |value| rational_to_decimal(&value, DIGITS)), unit)
}

/// A value with three digits and the unit that a laboratory uses: `5 MPa`, `10 µm/s`.
pub(crate) fn in_words(value: f64, unit: &str) -> String {
    let (number, unit) = parts(value, unit, None);
    format!("{number} {unit}").trim_end().into()
}

/// A range, rounded outward: `3.71 to 5.47 MPa`; one number where its ends agree, and one end where the other is out of reach.
pub(crate) fn range_in_words(quantity: Quantity, [low, high]: [f64; 2]) -> String {
    let ends = [(low, Side::Below), (high, Side::Above)].map(|(value, side)| {
        is_within_reach(quantity, value).then(|| parts(value, unit_of(quantity), Some(side)))
    });
    if high <= low * (1.0 + 1e-6) && ends[0].is_some() {
        return in_words(low, unit_of(quantity));
    }
    match ends {
        [Some((low, of_low)), Some((high, of_high))] if of_low == of_high => {
            format!("{low} to {high} {of_high}")
        }
        [Some((low, of_low)), Some((high, of_high))] => format!("{low} {of_low} to {high} {of_high}"),
        [Some((number, unit)), None] => format!("{number} {unit} or more"),
        [None, Some((number, unit))] => format!("{number} {unit} or less"),
        _ => "a value out of reach".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_stand_in_the_units_of_a_laboratory() {
        for (value, unit, words) in [
            (5e6, "Pa", "5 MPa"),
            (1e-5, "m/s", "10 µm/s"),
            (2.25e9, "Pa/m", "2.25 GPa/m"),
            (2400.0, "kg/m^2", "2400 kg/m²"),
            (0.0126, "1", "0.0126"),
            (9700.0, "s", "9700 s"),
            (0.00152, "s", "1.52 ms"),
        ] {
            assert_eq!(in_words(value, unit), words);
        }
    }

    #[test]
    fn ranges_are_rounded_outward_and_no_number_out_of_reach_is_written() {
        let of = |ends| range_in_words(Quantity::NormalStress, ends);
        assert_eq!(of([3.7142e6, 5.46667e6]), "3.71 to 5.47 MPa");
        assert_eq!(of([8.05e5, 1.3149e6]), "805 kPa to 1.32 MPa");
        assert_eq!(of([5e6, 5e6]), "5 MPa");
        assert_eq!(of([4.9e6, 5.1e6]), "4.9 to 5.1 MPa");
        assert_eq!(of([0.0, 703_006.6]), "704 kPa or less");
        assert_eq!(of([6.39e6, f64::INFINITY]), "6.39 MPa or more");
        assert_eq!(of([1e-48, 2e-40]), "a value out of reach");
    }

    #[test]
    fn a_factor_next_to_one_has_the_digits_that_part_it_from_one() {
        assert_eq!([0.8, 1310.0, 1.002].map(digits_of_factor), [3, 3, 4]);
        assert_eq!(round_digits(0.999_999_4, digits_of_factor(0.999_999_4)), "0.9999994");
    }
}
