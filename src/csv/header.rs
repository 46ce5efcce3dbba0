//! The header of a points file: a contract on names and units.

use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity, forbidden_character, nearest};

use crate::csv::row_work::RowWork;
use crate::csv::rows::Row;

/// The column that `--keep-going` appends last.
pub const ERROR_COLUMN: &str = "error";

/// A valid header.
#[derive(Debug, Clone)]
pub struct Header<P = [usize; 7]> {
    /// The names of all columns, in order.
    pub names: Vec<String>,
    /// Where each of [`Quantity::ALL`], or of the columns that were wanted, stands.
    pub positions: P,
}

/// A column that a header has to have: its name, its name without the unit, and whether it may be missing.
pub type Wanted = (&'static str, &'static str, bool);

impl Header {
    /// Where a column of this name stands.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// Reads the header of the points file `file`; `None` stands for a file without any row.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in another unit, or named like one that is appended.
    pub fn read<W: RowWork>(
        file: &str,
        row: Option<Row<'_>>,
        keep_going: bool,
        command: &W,
    ) -> Result<Self, Faults> {
        let appended: Vec<&str> =
            W::APPENDED.iter().copied().chain(keep_going.then_some(ERROR_COLUMN)).collect();
        let unknown = command.unknown();
        let wanted =
            Quantity::ALL.map(|quantity| (quantity.key(), quantity.stem(), Some(quantity) == unknown));
        let others = |names: &[String]| command.header_faults(names);
        let Header { names, positions } = Header::of_columns(file, row, wanted, &appended, others)?;
        // A header without faults has all that are read.
        Ok(Self { names, positions: positions.map(Option::unwrap_or_default) })
    }
}

impl<const N: usize> Header<[Option<usize>; N]> {
    /// Reads a header with these columns among others; `others` finds further faults, each with its column.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in another unit, or named like one of `appended`.
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
        let positions = wanted.map(|(key, ..)| names.iter().position(|name| name == key));
        for ((key, stem, is_optional), position) in wanted.into_iter().zip(positions) {
            let (name, problem) = absent(key, stem, &names);
            // Where nothing is missing, a column in another unit is still not to be passed over.
            let is_missing = !(is_optional && matches!(problem, CsvProblem::MissingColumn { .. }));
            if position.is_none() && is_missing {
                faults.push((name, problem.into()));
            }
        }
        if faults.is_empty() {
            return Ok(Self { names, positions });
        }
        let named = |(name, problem)| fault(format!("header, column {name}"), problem);
        Err(faults.into_iter().map(named).collect())
    }
}

/// The columns that a header has to have, and those that it may have.
fn in_words(wanted: &[Wanted]) -> String {
    let [required, optional] = [false, true].map(|is_wanted| {
        let keys = wanted.iter().filter(|(.., is_optional)| *is_optional == is_wanted).map(|(key, ..)| *key);
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

/// Why a column is not there: it has another name, or it is missing.
fn absent(key: &'static str, stem: &str, names: &[String]) -> (String, CsvProblem) {
    misnamed(key, stem, names).unwrap_or_else(|| {
        let near = nearest(key, names.iter().map(String::as_str)).map(str::to_string);
        (key.to_string(), CsvProblem::MissingColumn { nearest: near })
    })
}

/// A column that gives a quantity in a unit of its own or in none, or under a name with blanks around it.
pub fn misnamed(key: &'static str, stem: &str, names: &[String]) -> Option<(String, CsvProblem)> {
    if let Some(name) = names.iter().find(|name| name.trim() == key && *name != key) {
        return Some((format!("{name:?}"), CsvProblem::BlanksAround { wanted: key }));
    }
    let has_other_unit = |name: &&String| {
        let unit = name.strip_prefix(stem);
        unit.is_some_and(|unit| unit.is_empty() || unit.starts_with(['_', ' ', '[', '(']))
    };
    let name = names.iter().find(has_other_unit)?;
    Some((name.clone(), CsvProblem::UnknownUnit { wanted: key }))
}
