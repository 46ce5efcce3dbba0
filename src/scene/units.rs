//! Units of measured numbers: `8um`, `2MPa/mm`, `12kg/50cm2`, converted to SI exactly.
//!
//! No two units of the table differ in case only. `MPa` is megapascal, and millipascal is no unit here, so that m and M cannot be
//! confused; a name of a column may write a unit in lower case.

use std::sync::LazyLock;

use slipmode_core::friction::Quantity;
use slipmode_core::number::{Rational, parse_decimal};
use slipmode_theory::Dimension;

/// The units, their names and their endings, as `units.toml` lists them.
#[derive(Debug, Default, serde::Deserialize)]
struct Listed {
    units: Vec<(String, String, u32, u32)>,
    names: Vec<(String, String)>,
    endings: Vec<(String, String)>,
}

static LISTED: LazyLock<Listed> =
    LazyLock::new(|| toml::from_str(include_str!("units.toml")).unwrap_or_default());

/// The unit of SI that a key states: `m/s` for `loading_velocity_m_per_s`, for the ends of its range `loading_velocity_m_per_s.from`
/// and for the members of its list `loading_velocity_m_per_s[1]`; `1` for a key without unit.
pub(crate) fn unit_of_key(key: &str) -> &'static str {
    let key = [".from", ".to"].into_iter().find_map(|end| key.strip_suffix(end)).unwrap_or(key);
    let key = key.strip_suffix(']').and_then(|list| list.rsplit_once('[')).map_or(key, |(list, _)| list);
    LISTED.endings.iter().find(|(ending, _)| key.ends_with(ending)).map_or("1", |(_, unit)| unit)
}

/// The unit of SI of a quantity.
pub(crate) fn unit_of(quantity: Quantity) -> &'static str {
    unit_of_key(quantity.as_str())
}

/// A key without its unit, behind which another one may stand: `loading_velocity` of `loading_velocity_m_per_s`.
pub(crate) fn stem_of_key(key: &str) -> &str {
    LISTED.endings.iter().find_map(|(ending, _)| key.strip_suffix(ending.as_str())).unwrap_or(key)
}

/// The largest power of a unit.
const MOST_POWER: i32 = 9;

/// The number and the unit of a text: `8um` is `8` and `um`. A number without unit has an empty one.
pub(crate) fn split_unit(text: &str) -> (&str, &str) {
    let digits =
        |from: usize| text[from..].bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count();
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
    let (mut size, mut dimension) = (Rational::from(1), Dimension::default());
    for (index, quotient) in text.split('/').enumerate() {
        for (place, factor) in quotient.split(['*', '·', ' ']).filter(|part| !part.is_empty()).enumerate() {
            let (one, of_one) = read_factor(factor)?;
            if index > 0 && place == 0 {
                size /= one;
                dimension = dimension.over(&of_one);
            } else {
                size *= one;
                dimension = dimension.times(&of_one);
            }
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
        return Ok((factor, Dimension::default()));
    }
    let unit = LISTED.units.iter().find(|(known, ..)| known == symbol).ok_or_else(|| unknown(symbol))?;
    let power = power.filter(|power| *power != 0 && power.abs() <= MOST_POWER);
    let power = power.ok_or_else(|| format!("{rest:?} has a power that is none of 1 to {MOST_POWER}"))?;
    let (_, in_si, above, below) = unit;
    let one = if power > 0 { Rational::from((*above, *below)) } else { Rational::from((*below, *above)) };
    let size = (0..power.unsigned_abs()).fold(factor, |size, _| size * &one);
    Ok((size, Dimension::read(in_si)?.power(&Rational::from(power))))
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
    let same = LISTED.units.iter().find(|(known, ..)| known.eq_ignore_ascii_case(symbol));
    match same {
        Some((known, ..)) => format!("{symbol:?} is no unit here; did you mean `{known}`?"),
        None => {
            let known: Vec<&str> = LISTED.units.iter().map(|(known, ..)| known.as_str()).collect();
            format!("{symbol:?} is no unit (allowed: {})", known.join(", "))
        }
    }
}

/// The size of a unit in another one, which is of SI.
///
/// # Errors
/// When it is no unit, or one of another dimension, which is named.
pub fn unit_for(text: &str, in_si: &str) -> Result<Rational, String> {
    let (size, found) = read_unit(text)?;
    let wanted = Dimension::read(in_si)?;
    if found == wanted {
        return Ok(size);
    }
    let named = |unit: &&(String, String), of: &Dimension| Dimension::read(&unit.0).as_ref() == Ok(of);
    let name_of =
        |of: &Dimension| LISTED.names.iter().find(|unit| named(unit, of)).map(|(_, name)| name.as_str());
    let found_name = name_of(&found).unwrap_or("of another dimension");
    let wanted_words = match name_of(&wanted).and_then(|name| name.split_once(' ')) {
        Some((_, name)) if in_si != "1" => format!("{name} is {in_si}"),
        _ if in_si == "1" => "this number has no unit".to_string(),
        _ => format!("the unit is {in_si}"),
    };
    let lacks = |unit: &str| Dimension::read(unit).is_ok_and(|lacking| found.times(&lacking) == wanted);
    let hint = match () {
        () if lacks("1/m^2") => ": divide by the area of contact, as in kg/50cm2",
        () if lacks("Pa") => ": multiply by the normal stress (σ)",
        () => "",
    };
    Err(format!("{text} is {found_name}; {wanted_words}{hint}"))
}

/// A number and the unit that follows it, as in `8um` or `5 MPa`; none for a text that is not of this form.
#[must_use]
pub fn with_unit(text: &str) -> Option<(&str, &str)> {
    let (number, unit) = split_unit(text);
    let first = unit.strip_prefix('/').unwrap_or(unit).split(['/', '*', '·', ' ']).next().unwrap_or_default();
    let power = first.trim_start_matches(char::is_alphabetic);
    let has_unit = number.ends_with(|end: char| end.is_ascii_digit() || end == '.')
        && power.len() < first.len()
        && !power.contains(char::is_alphabetic);
    has_unit.then(|| (number, unit.trim_end()))
}

/// A unit of a column's name, such as `mpa/mm`: a symbol wholly in lower or in upper case is found whatever its case in the table.
pub(crate) fn unit_in_any_case(text: &str) -> String {
    let known = |symbol: &str| {
        let is_of_one_case = symbol.chars().all(char::is_lowercase)
            || (symbol.len() > 1 && symbol.chars().all(char::is_uppercase));
        let same = |known: &&str| *known == symbol || (is_of_one_case && known.eq_ignore_ascii_case(symbol));
        LISTED.units.iter().map(|(known, ..)| known.as_str()).find(same).unwrap_or(symbol).to_string()
    };
    let (mut unit, mut rest) = (String::new(), text);
    while !rest.is_empty() {
        let symbol = rest.len() - rest.trim_start_matches(char::is_alphabetic).len();
        let other = rest[symbol..].find(char::is_alphabetic).map_or(rest.len(), |other| symbol + other);
        unit.push_str(&known(&rest[..symbol]));
        unit.push_str(&rest[symbol..other]);
        rest = &rest[other..];
    }
    unit
}

#[cfg(test)]
mod tests {
    use super::*;

    const STIFFNESS_PER_AREA: &str = "Pa/m";
    const MASS_PER_AREA: &str = "kg/m^2";
    const LENGTH: &str = "m";
    const STRESS: &str = "Pa";

    fn si(text: &str, in_si: &str) -> Rational {
        let (number, unit) = split_unit(text);
        parse_decimal(number).unwrap() * unit_for(unit, in_si).unwrap()
    }

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    #[test]
    fn every_unit_of_the_table_has_its_size() {
        let lengths = [
            ("m", "1"),
            ("km", "1e3"),
            ("cm", "1e-2"),
            ("mm", "1e-3"),
            ("um", "1e-6"),
            ("µm", "1e-6"),
            ("μm", "1e-6"),
            ("nm", "1e-9"),
        ];
        let masses = [("kg", "1"), ("g", "1e-3"), ("mg", "1e-6"), ("t", "1e3")];
        let times = [
            ("s", "1"),
            ("ms", "1e-3"),
            ("us", "1e-6"),
            ("min", "60"),
            ("h", "3600"),
            ("d", "86400"),
            ("yr", "31557600"),
        ];
        let forces = [("N", "1"), ("kN", "1e3"), ("MN", "1e6")];
        let stresses = [
            ("Pa", "1"),
            ("hPa", "1e2"),
            ("kPa", "1e3"),
            ("MPa", "1e6"),
            ("GPa", "1e9"),
            ("bar", "1e5"),
            ("kbar", "1e8"),
        ];
        let frequencies = [("Hz", "1"), ("kHz", "1e3")];
        let all: [(&str, &[(&str, &str)]); 6] = [
            ("m", &lengths),
            ("kg", &masses),
            ("s", &times),
            ("N", &forces),
            ("Pa", &stresses),
            ("1/s", &frequencies),
        ];
        let mut tried = 0;
        for (in_si, units) in all {
            for (unit, size) in units {
                assert_eq!(unit_for(unit, in_si), Ok(number(size)), "{unit}");
                tried += 1;
            }
        }
        assert_eq!(tried, LISTED.units.len());
    }

    #[test]
    fn no_two_units_differ_in_case_only() {
        for (index, (one, ..)) in LISTED.units.iter().enumerate() {
            assert!(
                LISTED.units[index + 1..].iter().all(|(other, ..)| !one.eq_ignore_ascii_case(other)),
                "{one}"
            );
        }
    }

    #[test]
    fn measured_numbers_are_converted_exactly() {
        assert_eq!(si("8um", LENGTH), number("8e-6"));
        assert_eq!(si("2MPa/mm", STIFFNESS_PER_AREA), number("2e9"));
        assert_eq!(si("5 MPa", STRESS), number("5e6"));
        assert_eq!(si("10µm/s", "m/s"), number("1e-5"));
        assert_eq!(si("12kg/50cm2", MASS_PER_AREA), number("2400"));
        assert_eq!(si("12kg/50cm^2", MASS_PER_AREA), si("12 kg / 50cm²", MASS_PER_AREA));
        assert_eq!(si("3.5e1kN/mm/50cm2", STIFFNESS_PER_AREA), number("7e9"));
        assert_eq!(si("1kg/3m2", MASS_PER_AREA), Rational::from((1, 3)));
        assert_eq!(si("2400 kg m-2", MASS_PER_AREA), number("2400"));
        assert_eq!(si("35mm/yr", "m/s"), number("0.035") / 31_557_600_u32);
        assert_eq!(si("1e-5", "1"), number("1e-5"));
        assert_eq!(split_unit("1e3Pa"), ("1e3", "Pa"));
        assert_eq!(split_unit("1ePa"), ("1", "ePa"));
        assert_eq!(split_unit("-"), ("-", ""));
    }

    #[test]
    fn wrong_units_are_named() {
        let refused = |text: &str, in_si: &str| unit_for(text, in_si).unwrap_err();
        assert_eq!(refused("MPa", STIFFNESS_PER_AREA), "MPa is a stress; stiffness per area is Pa/m");
        assert_eq!(
            refused("kg", MASS_PER_AREA),
            "kg is a mass; mass per area is kg/m^2: divide by the area of contact, as in kg/50cm2"
        );
        assert!(refused("N/mm", STIFFNESS_PER_AREA).contains("divide by the area"));
        assert_eq!(refused("Pa", "1"), "Pa is a stress; this number has no unit");
        assert_eq!(refused("mPa", STRESS), "\"mPa\" is no unit here; did you mean `MPa`?");
        assert!(refused("psi", STRESS).contains("allowed: m, km"));
        for text in ["Pa/", "/", "Pa^x", "Pa0", "m99", "kg/0cm2", "kg/-5cm2", "Pa//m", "²", "1e99999m"] {
            assert!(unit_for(text, STRESS).is_err(), "{text}");
        }
    }

    #[test]
    fn a_column_may_write_its_unit_in_lower_or_upper_case() {
        assert_eq!(unit_in_any_case("um"), "um");
        assert_eq!(unit_in_any_case("mpa/mm"), "MPa/mm");
        assert_eq!(unit_in_any_case("kg/50cm2"), "kg/50cm2");
        // Millipascal is written as such, and then refused.
        assert_eq!(unit_in_any_case("mPa"), "mPa");
        assert_eq!(unit_in_any_case("MPA/MM"), "MPa/mm");
    }

    #[test]
    fn a_number_with_a_unit_is_told_from_what_is_no_number() {
        assert_eq!(with_unit("8 um "), Some(("8", "um")));
        assert_eq!(with_unit("-1.e3MPa/mm"), Some(("-1.e3", "MPa/mm")));
        assert_eq!(with_unit("0.06/min"), Some(("0.06", "/min")));
        for text in
            ["8", "um", "", "-", "-um", "1/2", "1,5", "1@5", "1_000", "1 /2m", "nan", "0x1p3", "8±1um"]
        {
            assert_eq!(with_unit(text), None, "{text}");
        }
    }

    #[test]
    fn the_names_of_keys_state_their_unit() {
        assert_eq!(stem_of_key("mass_per_area_kg_per_m2"), "mass_per_area");
        for (key, unit) in [
            ("critical_slip_distance_m", "m"),
            ("stiffness_pa_per_m", "Pa/m"),
            ("mass_per_area_kg_per_m2", "kg/m^2"),
            ("normal_stress_pa", "Pa"),
            ("loading_velocity_m_per_s", "m/s"),
            ("gravity_m_per_s2", "m/s^2"),
            ("duration_s", "s"),
            ("map.loading_velocity_m_per_s.from", "m/s"),
            ("onset.normal_stress_pa[12]", "Pa"),
            ("sweep.mass_per_area_kg_per_m2.to", "kg/m^2"),
            ("direct_effect", "1"),
            ("normal_stress_over_critical", "1"),
        ] {
            assert_eq!(unit_of_key(key), unit);
            let stem = stem_of_key(key);
            assert_eq!(stem == key, unit == "1" || key.contains('.'), "{key}");
            assert!(Dimension::read(unit).is_ok());
        }
    }
}
