//! How a CSV file is written: what separates its columns, and whether its decimals have commas.

use slipmode_core::number::{parse_decimal, parse_decimal_to_dd};

use crate::scene::{CsvProblem, has_between_digits, read_unit, split_unit};

/// How a CSV file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dialect {
    /// What separates the columns.
    pub delimiter: u8,
    /// Whether decimals have commas instead of points.
    pub has_decimal_commas: bool,
}

impl Default for Dialect {
    fn default() -> Self {
        Self { delimiter: b',', has_decimal_commas: false }
    }
}

/// A cell with points in place of its decimal commas; none for a cell that is no number with a decimal comma.
///
/// # Errors
/// When the cell is a number with a decimal point: it may separate thousands.
pub fn with_points(cell: &str) -> Result<Option<String>, CsvProblem> {
    let (has_comma, has_point) = (has_between_digits(cell, b','), has_between_digits(cell, b'.'));
    if !has_comma && !has_point {
        return Ok(None);
    }
    let is_digit = |at: usize| cell.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let replaced = cell.char_indices().map(|(at, character)| match character {
        ',' if at > 0 && is_digit(at - 1) && is_digit(at + 1) => '.',
        other => other,
    });
    let replaced: String = replaced.collect();
    match is_numeric(&replaced) {
        true if has_point => Err(CsvProblem::DecimalPoint),
        true => Ok(Some(replaced)),
        false => Ok(None),
    }
}

/// Whether a cell is a number, with or without an error bar and units.
fn is_numeric(cell: &str) -> bool {
    // Nearly all cells are plain decimals, which need no rational.
    if parse_decimal_to_dd(cell).is_some() {
        return true;
    }
    let is_range = cell.trim_start().starts_with('[');
    let plain = cell.replace("+/-", "±").replace("+-", "±");
    let is_mark = |character: char| "±[]()%;".contains(character) || (is_range && character == ',');
    let mut parts = plain.split(is_mark).map(str::trim).filter(|part| !part.is_empty()).peekable();
    let is_number = |part: &str| {
        let (number, unit) = split_unit(part);
        parse_decimal(number).is_ok() && (unit.is_empty() || read_unit(unit).is_ok())
    };
    parts.peek().is_some_and(|first| is_number(first))
        && parts.all(|part| is_number(part) || read_unit(part).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_are_replaced_in_numbers_only() {
        for (cell, with_point) in [
            ("0,009", "0.009"),
            ("-1,5e-3", "-1.5e-3"),
            ("8,5 um", "8.5 um"),
            ("0,009±0,001", "0.009±0.001"),
            ("0,0098(5)", "0.0098(5)"),
            ("8,0±0,2um", "8.0±0.2um"),
            ("[0,008; 0,010]", "[0.008; 0.010]"),
            ("[0,008, 0,010] um", "[0.008, 0.010] um"),
            ("0,0126±5,5%", "0.0126±5.5%"),
        ] {
            assert_eq!(with_points(cell), Ok(Some(with_point.to_string())), "{cell}");
        }
        for cell in
            ["", "granite", "sample 1,2", "1,2,3", "1,234.5", "5", "1e-5", "a,b", "2,5 persons", "1.234.567"]
        {
            assert_eq!(with_points(cell), Ok(None), "{cell}");
        }
        for cell in ["1.234", "0.009±0,001", "8.5um"] {
            assert_eq!(with_points(cell), Err(CsvProblem::DecimalPoint), "{cell}");
        }
    }
}
