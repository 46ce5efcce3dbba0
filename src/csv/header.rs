//! The header of a points file: a contract on names and units.

use slipmode_core::number::Rational;
use slipmode_core::number::format::exact_text;

use crate::scene::{AllowedRange, CsvProblem, Fault, Faults, Problem, Quantity, forbidden_character};

use crate::csv::row_work::RowWork;
use crate::csv::rows::Row;
use crate::csv::wanted::Wanted;

/// The column that `--keep-going` appends last.
pub const ERROR_COLUMN: &str = "error";

/// A valid header.
#[derive(Debug, Clone)]
pub struct Header<P = [usize; 7]> {
    /// The names of all columns, in order.
    pub names: Vec<String>,
    /// Where each of [`Quantity::ALL`], or of the columns that were wanted, stands.
    pub positions: P,
    /// The size in SI of the unit of each of these columns; none for those in SI.
    units: Vec<Option<Rational>>,
}

impl Header {
    /// Reads the header of the points file `file`; `None` stands for a file without any row.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in a unit of another dimension, or named like one that is appended.
    pub fn read<W: RowWork>(
        file: &str,
        row: Option<Row<'_>>,
        keep_going: bool,
        command: &W,
    ) -> Result<Self, Faults> {
        let appended: Vec<&str> =
            W::APPENDED.iter().copied().chain(keep_going.then_some(ERROR_COLUMN)).collect();
        let unknown = command.unknown();
        let wanted = Quantity::ALL.map(|quantity| Wanted::quantity(quantity, Some(quantity) == unknown));
        let others = |names: &[String]| command.header_faults(names);
        let Header { names, positions, units } = Header::of_columns(file, row, wanted, &appended, others)?;
        // A header without faults has all that are read.
        Ok(Self { names, positions: positions.map(Option::unwrap_or_default), units })
    }

    /// Whether a column of the seven quantities is in another unit than that of SI.
    pub fn has_units(&self) -> bool {
        self.units.iter().any(Option::is_some)
    }

    /// The value in SI of a cell of a quantity's column.
    ///
    /// # Errors
    /// When it is no number, or not in the allowed range.
    pub fn value(&self, quantity: Quantity, cell: &str) -> Result<Rational, Problem> {
        let (range, unit) = (AllowedRange::PHYSICAL, &self.units[quantity as usize]);
        let value = range.parse(cell)?;
        unit.as_ref().map_or_else(|| Ok(value.clone()), |size| range.check(Rational::from(&value * size)))
    }

    /// How the columns of the seven quantities are read that have another name than that of SI, a line each.
    pub fn remarks(&self) -> Vec<String> {
        let remark = |(quantity, (position, unit)): (Quantity, (&usize, &Option<Rational>))| {
            let name = self.names.get(*position).filter(|name| name.trim() != quantity.key())?;
            let of_unit = unit.as_ref().map_or(String::new(), |size| format!(" times {}", exact_text(size)));
            is_reading_of(quantity, name).then(|| format!("column {name}: {}{of_unit}", quantity.key()))
        };
        Quantity::ALL.into_iter().zip(self.positions.iter().zip(&self.units)).filter_map(remark).collect()
    }
}

/// Whether a column gives a quantity; the column of an unknown that is missing gives none.
fn is_reading_of(quantity: Quantity, name: &str) -> bool {
    let wanted = Wanted::quantity(quantity, false);
    is_named(name, wanted.key) || wanted.reading(name).is_some_and(|read| read.is_ok())
}

impl<P> Header<P> {
    /// Where a column of this name stands; blanks around it and its case do not matter.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| is_named(known, name))
    }

    /// The size in SI of the unit of a column that was wanted; none for SI.
    pub fn unit(&self, index: usize) -> Option<&Rational> {
        self.units.get(index)?.as_ref()
    }
}

/// Whether a column has a name; blanks around it and its case do not matter.
pub fn is_named(column: &str, name: &str) -> bool {
    column.trim().eq_ignore_ascii_case(name)
}

impl<const N: usize> Header<[Option<usize>; N]> {
    /// Reads a header with these columns among others; `others` finds further faults, each with its column.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in a unit of another dimension, or named like one of `appended`.
    pub fn of_columns(
        file: &str,
        row: Option<Row<'_>>,
        wanted: [Wanted; N],
        appended: &[&str],
        others: impl FnOnce(&[String]) -> Vec<(String, Problem)>,
    ) -> Result<Self, Faults> {
        let fault = |key: String, problem: Problem| Fault {
            file: file.to_string(),
            line: row.map(|row| row.line),
            key,
            value: None,
            problem,
        };
        let Some(row) = row else {
            let problem = CsvProblem::NoHeader { wanted: in_words(&wanted) };
            return Err(vec![fault(String::new(), problem.into())]);
        };
        let names = names(row).map_err(|problem| vec![fault("header".into(), problem)])?;
        let mut faults = column_faults(&names, appended);
        faults.extend(others(&names));
        let places = wanted.map(|wanted| match wanted.place(&names) {
            Ok(place) => Some(place),
            // Where nothing is missing, a column in an unknown unit is still not to be passed over.
            Err((_, CsvProblem::MissingColumn { .. })) if wanted.is_optional => None,
            Err((name, problem)) => {
                faults.push((name, problem.into()));
                None
            }
        });
        if faults.is_empty() {
            let positions = places.each_ref().map(|place| place.as_ref().map(|(position, _)| *position));
            let units = places.map(|place| place.and_then(|(_, unit)| unit)).into();
            return Ok(Self { names, positions, units });
        }
        let named = |(name, problem)| fault(format!("header, column {name}"), problem);
        Err(faults.into_iter().map(named).collect())
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
/// A name that is not text; columns that are not separated by commas.
fn names(row: Row<'_>) -> Result<Vec<String>, Problem> {
    if let Some(found) = other_separator(row) {
        return Err(CsvProblem::OtherSeparator { found }.into());
    }
    let text = |index| {
        let text = std::str::from_utf8(row.cell(index))
            .map_err(|error| Problem::NotUtf8(error.valid_up_to() + 1))?;
        forbidden_character(text).map_or_else(|| Ok(text.to_string()), Err)
    };
    (0..row.cell_count()).map(text).collect()
}

/// What a spreadsheet has put in place of the commas: no name of ours has one of these.
fn other_separator(row: Row<'_>) -> Option<&'static str> {
    let has = |separator: u8| row.cell_count() == 1 && row.cell(0).contains(&separator);
    [(b';', "semicolons"), (b'\t', "tabs")].into_iter().find_map(|(byte, name)| has(byte).then_some(name))
}

/// Doubled columns, and columns that the output will have as well.
fn column_faults(names: &[String], appended: &[&str]) -> Vec<(String, Problem)> {
    let mut faults = Vec::new();
    for (index, name) in names.iter().enumerate() {
        if let Some(first) = names[..index].iter().position(|earlier| earlier == name) {
            faults.push((name.clone(), CsvProblem::DoubledColumn { first: first + 1 }.into()));
        }
        if appended.contains(&name.as_str()) {
            faults.push((name.clone(), CsvProblem::OutputColumn.into()));
        }
    }
    faults
}
