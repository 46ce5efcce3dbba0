//! The header of a points file: a contract on names and units.

use rug::Integer;
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Dd, Rational, parse_decimal_times_power_to_dd};

use crate::scene::{
    AllowedRange, CsvProblem, Fault, Faults, Problem, Quantity, UNITS_DIFFER, forbidden_character, with_unit,
};

use crate::csv::name::{Unit, Wanted, is_named};
use crate::csv::rows::Row;
use crate::csv::wanted::{Assigned, ColumnPlace, ErrorPlace, assign};

/// The column that `--keep-going` appends last.
pub const ERROR_COLUMN: &str = "error";

/// Columns that commands append and that have errors of what they append. A file that a command wrote can be read again.
const APPENDED_ERRORS: [&str; 6] = [
    ERROR_COLUMN,
    "peak_relative_error",
    "period_relative_error",
    "simulated_peak_relative_error",
    "simulated_period_relative_error",
    "asymptote_relative_error",
];

/// A valid header.
#[derive(Debug, Clone)]
pub struct Header<P = [usize; 7]> {
    /// The names of all columns, in order.
    pub names: Vec<String>,
    /// Where each of [`Quantity::ALL`], or of the columns that were wanted, stands.
    pub positions: P,
    /// The size in SI of the unit of each of these columns; none for those in SI.
    units: Vec<Option<Rational>>,
    /// The columns of errors of each.
    errors: Vec<Option<ErrorPlace>>,
    /// The columns that nothing reads.
    unread: Vec<usize>,
    /// How the columns of quantities are read, for messages.
    remarks: Vec<String>,
}

/// What a command makes of columns beyond those that it wants.
pub struct Beyond<'c> {
    /// The columns that it appends.
    pub appended: &'c [&'c str],
    /// What it needs for columns of errors; none if it reads them.
    pub needs_for_errors: Option<&'c str>,
    /// Whether it reads a further column of this name.
    pub reads: &'c dyn Fn(&str) -> bool,
}

impl Header {
    /// Reads a header with the seven quantities, of which the unused ones may be missing.
    ///
    /// # Errors
    /// As [`Header::of_columns`].
    pub fn of_quantities(
        file: &str,
        row: Option<Row<'_>>,
        unused: &[Quantity],
        beyond: &Beyond<'_>,
        others: impl FnOnce(&[String]) -> Vec<(String, Problem)>,
    ) -> Result<Self, Faults> {
        let wanted = Quantity::ALL.map(|quantity| Wanted::quantity(quantity, unused.contains(&quantity)));
        let mut header = Header::of_columns(file, row, wanted, beyond, others)?;
        let errors = unused.iter().filter_map(|quantity| header.errors[*quantity as usize].take());
        header.unread.extend(errors.map(|(position, _)| position));
        let read = Quantity::ALL.into_iter().filter(|quantity| !unused.contains(quantity));
        let remarks = read.flat_map(|quantity| header.remarks_on(quantity)).collect();
        let Header { names, positions, units, errors, unread, .. } = header;
        // A header without faults has all that are read.
        Ok(Self {
            names,
            positions: positions.map(Option::unwrap_or_default),
            units,
            errors,
            unread,
            remarks,
        })
    }

    /// Where errors of the seven quantities stand.
    pub fn error_positions(&self) -> impl Iterator<Item = usize> {
        self.errors.iter().flatten().map(|(position, _)| *position)
    }

    /// Where the errors of a quantity stand.
    pub fn error_position(&self, quantity: Quantity) -> Option<usize> {
        self.errors[quantity as usize].as_ref().map(|(position, _)| *position)
    }

    /// The value in SI of a cell of a quantity's column, in the unit that the cell or the column states.
    ///
    /// # Errors
    /// When it is no number, not in the allowed range, or in a unit of another dimension.
    pub fn value(&self, quantity: Quantity, cell: &str) -> Result<Rational, Problem> {
        in_unit(quantity, cell, self.units[quantity as usize].as_ref())
    }

    /// The error in SI of this value, of a cell of the column of errors.
    ///
    /// # Errors
    /// As [`Self::value`], and when the error has no unit and the value has one of its own.
    pub fn error(
        &self,
        quantity: Quantity,
        value: (&str, &Rational),
        cell: &str,
    ) -> Result<Rational, Problem> {
        let (text, value) = value;
        match self.errors[quantity as usize].as_ref().map(|(_, unit)| unit) {
            Some(Unit::Share(whole)) => {
                Ok(AllowedRange::PHYSICAL.parse(cell)? * Rational::from(value / whole))
            }
            Some(Unit::Size(size)) => in_unit(quantity, cell, Some(size)),
            _ if with_unit(text).is_some() && with_unit(cell).is_none() => {
                Err(Problem::ErrorBar(UNITS_DIFFER))
            }
            _ => self.value(quantity, cell),
        }
    }

    /// How the columns of the seven quantities and of their errors are read, a line each; values under their name in SI are left out.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }
}

/// A factor of a unit, in words.
fn times(size: Option<&Rational>) -> String {
    size.map_or(String::new(), |size| format!(" times {}", exact_text(size)))
}

/// A number in SI to within a relative [`Dd::UNIT`], of a positive decimal of ordinary size in SI or in a unit that is a power of ten;
/// products with the sizes of other units are exact only in rationals.
pub fn dd_in_unit(text: &str, unit: Option<&Rational>) -> Option<Dd> {
    parse_decimal_times_power_to_dd(text, unit.map_or(Some(0), power_of_ten)?)
}

/// The power of ten that this is.
fn power_of_ten(size: &Rational) -> Option<i64> {
    let power = |part: &Integer| (0..=18).find(|power| *part == 10u64.pow(*power)).map(i64::from);
    Some(power(size.numer())? - power(size.denom())?)
}

/// The value in SI of a cell, in its own unit, or in this one.
fn in_unit(quantity: Quantity, cell: &str, unit: Option<&Rational>) -> Result<Rational, Problem> {
    let range = AllowedRange::PHYSICAL;
    match unit.filter(|_| with_unit(cell).is_none()) {
        Some(size) => range.check(range.parse(cell)? * size),
        None => range.parse_measured(cell, crate::scene::unit_of(quantity)),
    }
}

impl Header<[Option<usize>; 7]> {
    /// How the columns of a quantity and of its errors are read.
    fn remarks_on(&self, quantity: Quantity) -> Vec<String> {
        let (key, size) = (quantity.as_str(), self.unit(quantity as usize));
        let name = self.positions[quantity as usize].map(|position| self.names[position].trim());
        let name = name.filter(|name| *name != key);
        let values = name.map(|name| format!("column {name}: {key}{}", times(size)));
        let errors = self.errors[quantity as usize].as_ref().map(|(position, unit)| {
            let of_unit = match unit {
                Unit::Share(whole) => format!("{} of the value", times(Some(&Rational::from((1, *whole))))),
                Unit::Size(size) => times(Some(size).filter(|size| **size != 1)),
                _ => times(size),
            };
            format!("column {}: error of {key}{of_unit}", self.names[*position].trim())
        });
        values.into_iter().chain(errors).collect()
    }
}

impl<P> Header<P> {
    /// The names of the columns that nothing reads.
    pub fn unread(&self) -> impl Iterator<Item = &str> {
        self.unread.iter().filter_map(|position| self.names.get(*position)).map(String::as_str)
    }

    /// Where a column of this name stands; blanks around it and its case do not matter.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| is_named(known, name))
    }

    /// Where the errors of a column that was wanted stand, and their unit.
    pub fn error_place(&self, index: usize) -> Option<&ErrorPlace> {
        self.errors.get(index)?.as_ref()
    }

    /// The size in SI of the unit of a column that was wanted; none for SI.
    pub fn unit(&self, index: usize) -> Option<&Rational> {
        self.units.get(index)?.as_ref()
    }
}

impl<const N: usize> Header<[Option<usize>; N]> {
    /// Reads a header with these columns among others; `others` finds further faults, each with its column. `None` stands for a file
    /// without any row.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in a unit of another dimension, named like one that is appended, or of errors that
    /// are not understood or not used.
    pub fn of_columns(
        file: &str,
        row: Option<Row<'_>>,
        wanted: [Wanted; N],
        beyond: &Beyond<'_>,
        others: impl FnOnce(&[String]) -> Vec<(String, Problem)>,
    ) -> Result<Self, Faults> {
        let fault = |key: String, problem: Problem| Fault::of(file, key, problem).at(row.map(|row| row.line));
        let Some(row) = row else {
            let problem = CsvProblem::NoHeader(in_words(&wanted));
            return Err(vec![fault(String::new(), problem.into())]);
        };
        let names = names(row).map_err(|problem| vec![fault("header".into(), problem)])?;
        let mut faults = column_faults(&names, beyond.appended);
        faults.extend(others(&names));
        let is_known = |name: &str| {
            (beyond.reads)(name) || APPENDED_ERRORS.iter().any(|appended| is_named(name, appended))
        };
        let (assigned, found) = assign(&names, &wanted, is_known);
        faults.extend(found.into_iter().map(|(name, problem)| (name, problem.into())));
        if let Some(needs) = beyond.needs_for_errors {
            let refused = assigned.errors.iter().flatten().map(|(position, _)| names[*position].clone());
            faults.extend(refused.map(|name| (name, Problem::Needs(needs.into()))));
        }
        if faults.is_empty() {
            return Ok(Self::new(names, assigned, beyond));
        }
        let named = |(name, problem)| fault(format!("header, column {name}"), problem);
        Err(faults.into_iter().map(named).collect())
    }

    fn new(names: Vec<String>, assigned: Assigned, beyond: &Beyond<'_>) -> Self {
        let Assigned { values, errors, others } = assigned;
        let position = |index: usize| values.get(index)?.as_ref().map(|(position, _)| *position);
        let positions = std::array::from_fn(position);
        let unit = |place: Option<ColumnPlace>| place.and_then(|(_, unit)| unit);
        let unread = others.into_iter().filter(|index| !(beyond.reads)(&names[*index])).collect();
        let units = values.into_iter().map(unit).collect();
        Self { names, positions, units, errors, unread, remarks: Vec::new() }
    }
}

/// The columns that a header has to have, and those that it may have.
fn in_words(wanted: &[Wanted]) -> String {
    let [required, optional] = [false, true].map(|is_optional| {
        let keys = wanted.iter().filter(|wanted| wanted.is_optional == is_optional).map(|wanted| wanted.key);
        keys.collect::<Vec<_>>().join(", ")
    });
    if optional.is_empty() { required } else { format!("{required} and optionally {optional}") }
}

/// The names of a header row.
///
/// # Errors
/// A name that is not text; columns with another separator.
fn names(row: Row<'_>) -> Result<Vec<String>, Problem> {
    if let Some(problem) = other_separator(row) {
        return Err(problem.into());
    }
    let text = |index| {
        let text = std::str::from_utf8(row.cell(index))
            .map_err(|error| Problem::NotUtf8(error.valid_up_to() + 1))?;
        forbidden_character(text).map_or_else(|| Ok(text.to_string()), Err)
    };
    (0..row.cell_count()).map(text).collect()
}

/// The separator of a header that is one cell, where it has one: no name of ours contains it.
fn other_separator(row: Row<'_>) -> Option<CsvProblem> {
    let separators = [
        (b';', "semicolons", "add --delimiter ';'"),
        (b'\t', "tabs", "add --delimiter tab"),
        (b'|', "vertical bars", "add --delimiter '|'"),
        (b',', "commas", "leave out --delimiter"),
    ];
    let has = |separator: u8| row.cell_count() == 1 && row.cell(0).contains(&separator);
    let found = separators.into_iter().find(|(separator, ..)| has(*separator));
    found.map(|(_, found, option)| CsvProblem::OtherSeparator { found, option })
}

/// Doubled columns, and columns that the output will have as well.
fn column_faults(names: &[String], appended: &[&str]) -> Vec<(String, Problem)> {
    let mut faults = Vec::new();
    for (index, name) in names.iter().enumerate() {
        if let Some(first) = names[..index].iter().position(|earlier| earlier == name) {
            faults.push((name.clone(), CsvProblem::DoubledColumn(first + 1).into()));
        }
        if appended.contains(&name.as_str()) {
            faults.push((name.clone(), CsvProblem::OutputColumn.into()));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::unit_for;
    use slipmode_core::number::nearest_f64;

    #[test]
    fn units_that_are_powers_of_ten_need_no_rationals() {
        for (unit, of, power) in [
            ("um", "m", Some(-6)),
            ("MPa/mm", "Pa/m", Some(9)),
            ("kg/cm2", "kg/m^2", Some(4)),
            ("kg/50cm2", "kg/m^2", None),
            ("mm/yr", "m/s", None),
        ] {
            let size = unit_for(unit, of).unwrap();
            assert_eq!(power_of_ten(&size), power, "{unit}");
            let exact = size.clone() * Rational::from((37, 8));
            let found = dd_in_unit("4.625", Some(&size)).map(|value| value.hi());
            assert_eq!(found, power.map(|_| nearest_f64(&exact)), "{unit}");
        }
    }
}
