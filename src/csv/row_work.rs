//! What a command does with the rows of a points file, apart from reading and writing them.

use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity, Uncertain, all_of};
use slipmode_core::friction::{ParameterBox, Parameters};
use slipmode_core::number::{Dd, Rational};

use crate::csv::header::{Beyond, ERROR_COLUMN, Header, dd_in_unit};
use crate::csv::rows::Row;

/// A command's part in the rows.
pub trait RowWork: Sync {
    /// What is read from a row before the work on it.
    type Input;
    /// What the command keeps of a row beyond its cells.
    type Kept: Send;

    /// The columns that are appended to every row.
    const APPENDED: &'static [&'static str];
    /// Rows of a block, the unit of parallel work.
    const BLOCK_ROWS: usize;
    /// Blocks that each thread gets between two reads.
    const BLOCKS_PER_THREAD: usize;

    /// Faults of the header beyond the seven quantities, each with its column.
    fn header_faults(&self, _names: &[String]) -> Vec<(String, Problem)> {
        Vec::new()
    }

    /// Whether a further column of this name is read.
    fn reads(&self, _name: &str) -> bool {
        false
    }

    /// What columns of errors need; none if they are read.
    fn needs_for_errors(&self) -> Option<&'static str> {
        None
    }

    /// The quantities whose columns are not used and may be missing.
    fn unused(&self) -> Vec<Quantity> {
        Vec::new()
    }

    /// Reads the header of the points file `file`; `None` stands for a file without any row.
    ///
    /// # Errors
    /// As [`Header::of_columns`].
    fn read_header(&self, file: &str, row: Option<Row<'_>>, keep_going: bool) -> Result<Header, Faults> {
        let appended: Vec<&str> =
            Self::APPENDED.iter().copied().chain(keep_going.then_some(ERROR_COLUMN)).collect();
        let beyond = Beyond {
            appended: &appended,
            needs_for_errors: self.needs_for_errors(),
            reads: &|name| self.reads(name),
        };
        Header::of_quantities(file, row, &self.unused(), &beyond, |names| self.header_faults(names))
    }

    /// Reads a row.
    ///
    /// # Errors
    /// All faults of the row.
    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults>;

    /// Reads several rows; a result for each, in their order. What is faster for many rows at once is done here.
    fn read_rows(&self, cells: &[Cells<'_>]) -> Vec<Result<Self::Input, Faults>> {
        cells.iter().map(|cells| self.read(*cells)).collect()
    }

    /// Does the work and appends one cell for each of [`Self::APPENDED`], each behind a comma.
    fn append(&self, input: &Self::Input, out: &mut Vec<u8>) -> Remark<Self::Kept>;
}

/// What is reported of a row besides its cells.
#[derive(Debug, Default)]
pub struct Remark<K = ()> {
    /// Whether the work ended without an answer, which the row's cells explain.
    pub is_unanswered: bool,
    /// A warning about the row's input.
    pub warning: Option<String>,
    /// What the command needs after all rows are done.
    pub kept: K,
}

impl<K: Default> Remark<K> {
    /// A remark on a row with these warnings.
    #[must_use]
    pub fn warning(warnings: &[String]) -> Self {
        let warning = (!warnings.is_empty()).then(|| warnings.join("; "));
        Self { warning, ..Self::default() }
    }
}

/// The cells of a row, found by the header.
#[derive(Debug, Clone, Copy)]
pub struct Cells<'r, P = [usize; 7]> {
    /// The name of the file, for messages.
    pub file: &'r str,
    /// The columns.
    pub header: &'r Header<P>,
    /// The row; its text was checked.
    pub row: Row<'r>,
}

impl<'r> Cells<'r> {
    /// The seven numbers to within a relative [`Dd::UNIT`], when all are positive, of ordinary size and without an error, as nearly
    /// all are.
    pub fn dd_parameters(self) -> Option<Parameters<Dd>> {
        if self.header.error_positions().any(|position| !self.text(position).is_empty()) {
            return None;
        }
        let mut values = [Dd::from(0.0); 7];
        for (index, value) in values.iter_mut().enumerate() {
            *value = dd_in_unit(self.text(self.header.positions[index]), self.header.unit(index))?;
        }
        Some(Parameters::from(values))
    }

    /// The seven numbers, exactly.
    ///
    /// # Errors
    /// Every cell that is not a number in the allowed range.
    pub fn parameters(self) -> Result<Parameters<Rational>, Faults> {
        let mut faults = Faults::new();
        let values = Quantity::ALL.map(|quantity| {
            let position = self.header.positions[quantity as usize];
            self.header
                .value(quantity, self.text(position))
                .map_err(|problem| faults.push(self.fault(Some(position), problem)))
                .ok()
        });
        all_of(values).map(Parameters::from).ok_or(faults)
    }
}

impl Cells<'_> {
    /// The seven values with the error bars of their cells or of the columns of errors; an empty cell there is no error.
    ///
    /// # Errors
    /// Every cell that is at fault.
    pub fn uncertain(self) -> Result<[Uncertain; 7], Faults> {
        self.uncertain_without(&[])
    }

    /// All values within the error bars.
    ///
    /// # Errors
    /// As [`Self::uncertain`].
    pub fn region(self) -> Result<ParameterBox, Faults> {
        let needs = || vec![self.fault(None, Problem::Needs("positive values within all error bars".into()))];
        Uncertain::region(self.uncertain()?).ok_or_else(needs)
    }

    /// As [`Self::uncertain`], with 1 for the unused quantities, whose columns are not read.
    ///
    /// # Errors
    /// Every cell that is at fault.
    pub fn uncertain_without(self, unused: &[Quantity]) -> Result<[Uncertain; 7], Faults> {
        let mut faults = Faults::new();
        let values = Quantity::ALL.map(|quantity| {
            if unused.contains(&quantity) {
                return Some(Uncertain::certain(Rational::from(1)));
            }
            let read = |text: &str| self.header.value(quantity, text);
            let position = self.header.positions[quantity as usize];
            let text = self.text(position);
            let error = self.header.error_position(quantity).map(|column| (column, self.text(column)));
            let (column, value) = match error.filter(|(_, error)| !error.trim().is_empty()) {
                None => (position, Uncertain::parse(text, read)),
                Some((column, _)) if Uncertain::is_meant(text) => {
                    let needs = "no error bar in the value's own cell: its error is given twice";
                    (column, Err(Problem::Needs(needs.to_string())))
                }
                Some((column, error)) => match read(text) {
                    Ok(value) => {
                        let size = |error: &str| self.header.error(quantity, (text, &value), error);
                        (column, Uncertain::around(&value, error, size))
                    }
                    Err(problem) => (position, Err(problem)),
                },
            };
            value.map_err(|problem| faults.push(self.fault(Some(column), problem))).ok()
        });
        all_of(values).ok_or(faults)
    }
}

impl<'r, P: Copy> Cells<'r, P> {
    /// Whether the row has a cell for each column.
    ///
    /// # Errors
    /// The fault of the row, when it has not.
    pub fn check_count(self) -> Result<(), Faults> {
        let (found, wanted) = (self.row.cell_count(), self.header.names.len());
        let fault = || vec![self.fault(None, CsvProblem::CellCount { found, wanted }.into())];
        if found == wanted { Ok(()) } else { Err(fault()) }
    }

    /// The text of a cell without blanks around it; the row's text was checked, so that none is lost here.
    pub fn text(self, position: usize) -> &'r str {
        std::str::from_utf8(self.row.cell(position).trim_ascii()).unwrap_or_default()
    }

    /// A fault of the row, or of one of its cells.
    pub fn fault(self, column: Option<usize>, problem: Problem) -> Fault {
        let key = match column.and_then(|index| self.header.names.get(index)) {
            Some(name) => format!("row {}, column {name}", self.row.number),
            None => format!("row {}", self.row.number),
        };
        let value = column.map(|index| String::from_utf8_lossy(self.row.cell(index)).into_owned());
        Fault { file: self.file.to_string(), line: Some(self.row.line), key, value, problem }
    }
}
