//! The header of a points file: a contract on names and units.

use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity, is_forbidden, nearest};

use crate::csv::row_work::RowWork;
use crate::csv::rows::Row;

/// The column that `--keep-going` appends last.
pub const ERROR_COLUMN: &str = "error";

/// A valid header.
#[derive(Debug, Clone)]
pub struct Header {
    /// The names of all columns, in order.
    pub names: Vec<String>,
    /// Where each of [`Quantity::ALL`] stands.
    pub positions: [usize; 7],
}

impl Header {
    /// Where a column of this name stands.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// Reads the header of the file `file`; `None` stands for a file without any row.
    ///
    /// # Errors
    /// Every column that is missing, doubled, in another unit, or named like one that is appended.
    pub fn read<W: RowWork>(
        file: &str,
        row: Option<Row<'_>>,
        keep_going: bool,
        command: &W,
    ) -> Result<Self, Faults> {
        let fault = |key: String, problem: Problem| Fault {
            file: file.to_string(),
            line: row.map(|row| row.line),
            key,
            value: None,
            problem,
        };
        let Some(row) = row else {
            let wanted = Quantity::ALL.map(Quantity::key).join(", ");
            return Err(vec![fault(String::new(), CsvProblem::NoHeader { wanted }.into())]);
        };
        let names = names(row).map_err(|problem| vec![fault("header".into(), problem)])?;
        let mut faults: Faults = column_faults(&names, W::APPENDED, keep_going)
            .into_iter()
            .map(|(name, problem)| (name, problem.into()))
            .chain(command.header_faults(&names))
            .map(|(name, problem)| fault(format!("header, column {name}"), problem))
            .collect();
        let positions = Quantity::ALL.map(|quantity| names.iter().position(|name| name == quantity.key()));
        for (quantity, position) in Quantity::ALL.into_iter().zip(positions) {
            if position.is_none() {
                let (name, problem) = absent(quantity.key(), quantity.stem(), &names);
                faults.push(fault(format!("header, column {name}"), problem.into()));
            }
        }
        let found: Vec<usize> = positions.into_iter().flatten().collect();
        match <[usize; 7]>::try_from(found) {
            Ok(positions) if faults.is_empty() => Ok(Self { names, positions }),
            _ => Err(faults),
        }
    }
}

/// The names of a header row.
///
/// # Errors
/// A name that is not text; columns that are not separated by commas.
pub fn names(row: Row<'_>) -> Result<Vec<String>, Problem> {
    if let Some(found) = other_separator(row) {
        return Err(CsvProblem::OtherSeparator { found }.into());
    }
    let text = |index| {
        let text = std::str::from_utf8(row.cell(index))
            .map_err(|error| Problem::NotUtf8(error.valid_up_to() + 1))?;
        match text.chars().find(|character| is_forbidden(*character)) {
            Some(character) => Err(Problem::ForbiddenCharacter(u32::from(character))),
            None => Ok(text.to_string()),
        }
    };
    (0..row.cell_count()).map(text).collect()
}

/// What a spreadsheet has put in place of the commas: no name of ours has one of these.
fn other_separator(row: Row<'_>) -> Option<&'static str> {
    let has = |separator: u8| row.cell_count() == 1 && row.cell(0).contains(&separator);
    [(b';', "semicolons"), (b'\t', "tabs")].into_iter().find_map(|(byte, name)| has(byte).then_some(name))
}

/// Doubled columns, and columns that the output will have as well.
pub fn column_faults(names: &[String], appended: &[&str], keep_going: bool) -> Vec<(String, CsvProblem)> {
    let mut faults = Vec::new();
    for (index, name) in names.iter().enumerate() {
        if let Some(first) = names[..index].iter().position(|earlier| earlier == name) {
            faults.push((name.clone(), CsvProblem::DoubledColumn { first: first + 1 }));
        }
        if appended.contains(&name.as_str()) || (keep_going && name == ERROR_COLUMN) {
            faults.push((name.clone(), CsvProblem::OutputColumn));
        }
    }
    faults
}

/// Why a column is not there: it has another name, or it is missing.
pub fn absent(key: &'static str, stem: &str, names: &[String]) -> (String, CsvProblem) {
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
