//! Units of measured numbers: `8um`, `2MPa/mm`, `12kg/50cm2`, converted to SI exactly.
//!
//! No two units of the table differ in case only. `MPa` is megapascal, and millipascal is no unit here, so that m and M cannot be
//! confused; a name of a column may write a unit in lower case.

use slipmode_core::number::{Rational, parse_decimal};

/// Powers of kg, m and s.
pub type Dimension = [i32; 3];

/// A unit: its symbol, its dimension, and its size in SI as numerator and denominator.
type Unit = (&'static str, Dimension, u32, u32);

const MASS: Dimension = [1, 0, 0];
const LENGTH: Dimension = [0, 1, 0];
const TIME: Dimension = [0, 0, 1];
const FORCE: Dimension = [1, 1, -2];
const STRESS: Dimension = [1, -1, -2];
const FREQUENCY: Dimension = [0, 0, -1];

/// The units; a year has 365.25 days.
const UNITS: [Unit; 31] = [
    ("m", LENGTH, 1, 1),
    ("km", LENGTH, 1000, 1),
    ("cm", LENGTH, 1, 100),
    ("mm", LENGTH, 1, 1000),
    ("um", LENGTH, 1, 1_000_000),
    ("µm", LENGTH, 1, 1_000_000),
    ("μm", LENGTH, 1, 1_000_000),
    ("nm", LENGTH, 1, 1_000_000_000),
    ("kg", MASS, 1, 1),
    ("g", MASS, 1, 1000),
    ("mg", MASS, 1, 1_000_000),
    ("t", MASS, 1000, 1),
    ("s", TIME, 1, 1),
    ("ms", TIME, 1, 1000),
    ("us", TIME, 1, 1_000_000),
    ("min", TIME, 60, 1),
    ("h", TIME, 3600, 1),
    ("d", TIME, 86_400, 1),
    ("yr", TIME, 31_557_600, 1),
    ("N", FORCE, 1, 1),
    ("kN", FORCE, 1000, 1),
    ("MN", FORCE, 1_000_000, 1),
    ("Pa", STRESS, 1, 1),
    ("hPa", STRESS, 100, 1),
    ("kPa", STRESS, 1000, 1),
    ("MPa", STRESS, 1_000_000, 1),
    ("GPa", STRESS, 1_000_000_000, 1),
    ("bar", STRESS, 100_000, 1),
    ("kbar", STRESS, 100_000_000, 1),
    ("Hz", FREQUENCY, 1, 1),
    ("kHz", FREQUENCY, 1000, 1),
];

/// What a dimension is called, and its unit.
const NAMES: [(Dimension, &str, &str); 13] = [
    ([0, 0, 0], "a number without unit", "1"),
    (MASS, "a mass", "kg"),
    (LENGTH, "a length", "m"),
    (TIME, "a time", "s"),
    ([0, 2, 0], "an area", "m2"),
    (FORCE, "a force", "N"),
    (STRESS, "a stress", "Pa"),
    (FREQUENCY, "a frequency", "Hz"),
    ([0, 1, -1], "a velocity", "m/s"),
    ([1, -2, 0], "a mass per area", "kg/m2"),
    ([1, -2, -2], "a stiffness per area", "Pa/m"),
    ([1, 0, -2], "a stiffness", "N/m"),
    ([1, -3, 0], "a density", "kg/m3"),
];

/// The largest power of a unit.
const MOST_POWER: i32 = 9;

/// The number and the unit of a text: `8um` is `8` and `um`. A number without unit has an empty one.
#[must_use]
pub fn split_unit(text: &str) -> (&str, &str) {
    let digits = |from: usize| {
        text[from..].bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count()
    };
    let signed = |from: usize| from + usize::from(text[from..].starts_with(['+', '-']));
    let start = signed(0);
    let mut end = start + digits(start);
    if text[end..].starts_with(['e', 'E']) {
        let exponent = signed(end + 1);
        let count = text[exponent..].bytes().take_while(u8::is_ascii_digit).count();
        end = if count > 0 { exponent + count } else { end };
    }
    (&text[..end], text[end..].trim_start())
}

/// A unit such as `MPa/mm`, `kg m-2` or `kg/50cm2`: its size in SI and its dimension. Each `/` divides by what directly follows.
///
/// # Errors
/// The part that is no unit.
pub fn read_unit(text: &str) -> Result<(Rational, Dimension), String> {
    let (mut size, mut dimension) = (Rational::from(1), [0; 3]);
    for (index, quotient) in text.split('/').enumerate() {
        for (place, factor) in quotient.split(['*', '·', ' ']).filter(|part| !part.is_empty()).enumerate() {
            let (one, of_one) = read_factor(factor)?;
            let sign = if index > 0 && place == 0 { -1 } else { 1 };
            size *= if sign < 0 { Rational::from(one.recip_ref()) } else { one };
            dimension = std::array::from_fn(|axis| dimension[axis] + sign * of_one[axis]);
        }
        if quotient.trim().is_empty() && index > 0 {
            return Err(format!("no unit follows the `/` of {text:?}"));
        }
    }
    Ok((size, dimension))
}

/// A unit with a number before it and a power behind it: `50cm2`.
fn read_factor(text: &str) -> Result<(Rational, Dimension), String> {
    let (number, rest) = split_unit(text);
    let factor = match number {
        "" => Rational::from(1),
        number => parse_decimal(number).map_err(|reason| format!("{number:?} is {reason}"))?,
    };
    if factor <= 0 {
        return Err(format!("{number} is not positive"));
    }
    let (symbol, power) = split_power(rest);
    if symbol.is_empty() && rest.is_empty() {
        return Ok((factor, [0; 3]));
    }
    let unit = UNITS.iter().find(|(known, ..)| *known == symbol).ok_or_else(|| unknown(symbol))?;
    let power = power.filter(|power| *power != 0 && power.abs() <= MOST_POWER);
    let power = power.ok_or_else(|| format!("{rest:?} has a power that is none of 1 to {MOST_POWER}"))?;
    let (_, dimension, above, below) = unit;
    let one = if power > 0 { Rational::from((*above, *below)) } else { Rational::from((*below, *above)) };
    let size = (0..power.unsigned_abs()).fold(factor, |size, _| size * &one);
    Ok((size, dimension.map(|axis| axis * power)))
}

/// A symbol and its power: `cm2`, `cm^2`, `cm²`, `s-1`. None is a power that cannot be read.
fn split_power(text: &str) -> (&str, Option<i32>) {
    let is_symbol = |character: char| character.is_alphabetic();
    let end = text.find(|character| !is_symbol(character)).unwrap_or(text.len());
    let (symbol, power) = text.split_at(end);
    let plain: String = power
        .strip_prefix('^')
        .unwrap_or(power)
        .chars()
        .map(|character| match character {
            '⁻' => '-',
            '¹' => '1',
            '²' => '2',
            '³' => '3',
            other => other,
        })
        .collect();
    (symbol, if power.is_empty() { Some(1) } else { plain.parse().ok() })
}

fn unknown(symbol: &str) -> String {
    let same = UNITS.iter().find(|(known, ..)| known.eq_ignore_ascii_case(symbol));
    match same {
        Some((known, ..)) => format!("{symbol:?} is no unit here; did you mean `{known}`?"),
        None => {
            let known: Vec<&str> = UNITS.iter().map(|(known, ..)| *known).collect();
            format!("{symbol:?} is no unit (allowed: {})", known.join(", "))
        }
    }
}

/// The size in SI of a unit in which a quantity of this dimension is given.
///
/// # Errors
/// When it is no unit, or one of another dimension, which is named.
pub fn unit_for(text: &str, wanted: Dimension) -> Result<Rational, String> {
    let (size, found) = read_unit(text)?;
    if found == wanted {
        return Ok(size);
    }
    let name = |dimension: Dimension| NAMES.iter().find(|(known, ..)| *known == dimension);
    let found_name = name(found).map_or("of another dimension", |(_, name, _)| name);
    let wanted_words = match name(wanted) {
        Some((_, _, "1")) => "this number has no unit".to_string(),
        Some((_, name, unit)) => format!("{} is {unit}", name.split_once(' ').map_or(*name, |(_, name)| name)),
        None => "another unit is wanted".to_string(),
    };
    let per_area = [found[0], found[1] - 2, found[2]] == wanted;
    let hint = if per_area { ": divide by the area of contact, as in kg/50cm2" } else { "" };
    Err(format!("{text} is {found_name}; {wanted_words}{hint}"))
}

/// The unit of a column's name: `um`, `mpa_per_mm`, `MPa_per_mm`; one wholly in lower case is found whatever its case in the table.
#[must_use]
pub fn unit_of_column(text: &str) -> String {
    let part = |part: &str| {
        let (symbol, power) = part.split_at(part.find(|c: char| !c.is_alphabetic()).unwrap_or(part.len()));
        let is_lower = symbol.chars().all(char::is_lowercase);
        let same = |known: &&str| *known == symbol || (is_lower && known.eq_ignore_ascii_case(symbol));
        let known = UNITS.iter().map(|(known, ..)| *known).find(same);
        format!("{}{power}", known.unwrap_or(symbol))
    };
    text.split("_per_").map(part).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    const STIFFNESS_PER_AREA: Dimension = [1, -2, -2];
    const MASS_PER_AREA: Dimension = [1, -2, 0];

    fn si(text: &str, dimension: Dimension) -> Rational {
        let (number, unit) = split_unit(text);
        parse_decimal(number).unwrap() * unit_for(unit, dimension).unwrap()
    }

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    #[test]
    fn every_unit_of_the_table_has_its_size() {
        let lengths = [("m", "1"), ("km", "1e3"), ("cm", "1e-2"), ("mm", "1e-3"), ("um", "1e-6"), ("µm", "1e-6"), ("μm", "1e-6"), ("nm", "1e-9")];
        let masses = [("kg", "1"), ("g", "1e-3"), ("mg", "1e-6"), ("t", "1e3")];
        let times = [("s", "1"), ("ms", "1e-3"), ("us", "1e-6"), ("min", "60"), ("h", "3600"), ("d", "86400"), ("yr", "31557600")];
        let forces = [("N", "1"), ("kN", "1e3"), ("MN", "1e6")];
        let stresses = [("Pa", "1"), ("hPa", "1e2"), ("kPa", "1e3"), ("MPa", "1e6"), ("GPa", "1e9"), ("bar", "1e5"), ("kbar", "1e8")];
        let frequencies = [("Hz", "1"), ("kHz", "1e3")];
        let all: [(Dimension, &[(&str, &str)]); 6] =
            [([0, 1, 0], &lengths), ([1, 0, 0], &masses), ([0, 0, 1], &times), ([1, 1, -2], &forces), ([1, -1, -2], &stresses), ([0, 0, -1], &frequencies)];
        let mut tried = 0;
        for (dimension, units) in all {
            for (unit, size) in units {
                assert_eq!(unit_for(unit, dimension), Ok(number(size)), "{unit}");
                tried += 1;
            }
        }
        assert_eq!(tried, UNITS.len());
    }

    #[test]
    fn no_two_units_differ_in_case_only() {
        for (index, (one, ..)) in UNITS.iter().enumerate() {
            assert!(UNITS[index + 1..].iter().all(|(other, ..)| !one.eq_ignore_ascii_case(other)), "{one}");
        }
    }

    #[test]
    fn measured_numbers_are_converted_exactly() {
        assert_eq!(si("8um", LENGTH), number("8e-6"));
        assert_eq!(si("2MPa/mm", STIFFNESS_PER_AREA), number("2e9"));
        assert_eq!(si("5 MPa", STRESS), number("5e6"));
        assert_eq!(si("10µm/s", [0, 1, -1]), number("1e-5"));
        assert_eq!(si("12kg/50cm2", MASS_PER_AREA), number("2400"));
        assert_eq!(si("12kg/50cm^2", MASS_PER_AREA), si("12 kg / 50cm²", MASS_PER_AREA));
        assert_eq!(si("3.5e1kN/mm/50cm2", STIFFNESS_PER_AREA), number("7e9"));
        assert_eq!(si("1kg/3m2", MASS_PER_AREA), Rational::from((1, 3)));
        assert_eq!(si("2400 kg m-2", MASS_PER_AREA), number("2400"));
        assert_eq!(si("35mm/yr", [0, 1, -1]), number("0.035") / 31_557_600_u32);
        assert_eq!(si("1e-5", [0; 3]), number("1e-5"));
        assert_eq!(split_unit("1e3Pa"), ("1e3", "Pa"));
        assert_eq!(split_unit("1ePa"), ("1", "ePa"));
        assert_eq!(split_unit("-"), ("-", ""));
    }

    #[test]
    fn wrong_units_are_named() {
        let refused = |text: &str, dimension: Dimension| unit_for(text, dimension).unwrap_err();
        assert_eq!(refused("MPa", STIFFNESS_PER_AREA), "MPa is a stress; stiffness per area is Pa/m");
        assert_eq!(
            refused("kg", MASS_PER_AREA),
            "kg is a mass; mass per area is kg/m2: divide by the area of contact, as in kg/50cm2"
        );
        assert!(refused("N/mm", STIFFNESS_PER_AREA).contains("divide by the area"));
        assert_eq!(refused("Pa", [0; 3]), "Pa is a stress; this number has no unit");
        assert_eq!(refused("mPa", STRESS), "\"mPa\" is no unit here; did you mean `MPa`?");
        assert!(refused("psi", STRESS).contains("allowed: m, km"));
        for text in ["Pa/", "/", "Pa^x", "Pa0", "m99", "kg/0cm2", "kg/-5cm2", "Pa//m", "²", "1e99999m"] {
            assert!(unit_for(text, STRESS).is_err(), "{text}");
        }
    }

    #[test]
    fn a_column_may_write_its_unit_in_lower_case() {
        assert_eq!(unit_of_column("um"), "um");
        assert_eq!(unit_of_column("mpa_per_mm"), "MPa/mm");
        assert_eq!(unit_of_column("kg_per_cm2"), "kg/cm2");
        // Millipascal is written as such, and then refused.
        assert_eq!(unit_of_column("mPa"), "mPa");
    }
}
