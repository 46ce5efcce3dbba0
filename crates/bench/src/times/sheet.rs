//! The plain CSV of measured times: one header line with known columns, no quotation marks.

use slipmode::scene::{CsvProblem, Fault, Faults, Problem};

/// A row: its line in the file, counted from 1, and a cell for each column requested.
#[derive(Debug)]
pub(crate) struct SheetRow<'t> {
    file: &'t str,
    pub(crate) line: usize,
    columns: &'t [&'t str],
    cells: Vec<&'t str>,
}

/// The rows of a file, each with the columns requested in their order.
pub(crate) fn rows<'t>(
    file: &'t str,
    text: &'t str,
    columns: &'t [&'t str],
) -> Result<Vec<SheetRow<'t>>, Faults> {
    let mut lines = (1..).zip(text.lines());
    let fault = |line, key: &str, problem: CsvProblem| {
        vec![Fault {
            file: file.into(),
            line: Some(line),
            key: key.into(),
            value: None,
            problem: problem.into(),
        }]
    };
    let Some((_, header)) = lines.next() else {
        return Err(fault(1, "", CsvProblem::NoHeader(columns.join(", "))));
    };
    let header: Vec<&str> = header.split(',').collect();
    let place = |wanted: &&str| {
        let found = header.iter().position(|name| name == wanted);
        let missing = || CsvProblem::MissingColumn { nearest: None, allowed: (*wanted).into() };
        found.ok_or_else(|| fault(1, wanted, missing()))
    };
    let places = columns.iter().map(place).collect::<Result<Vec<usize>, Faults>>()?;
    let row = |(line, text): (usize, &'t str)| {
        let cells: Vec<&str> = text.split(',').collect();
        if cells.len() != header.len() {
            let problem = CsvProblem::CellCount { found: cells.len(), wanted: header.len() };
            return Err(fault(line, "", problem));
        }
        let cells = places.iter().map(|&place| cells[place]).collect();
        Ok(SheetRow { file, line, columns, cells })
    };
    lines.map(row).collect()
}

impl SheetRow<'_> {
    /// The text of a column, by its place among those requested.
    pub(crate) fn text(&self, column: usize) -> String {
        self.cells[column].to_owned()
    }

    /// A positive number.
    pub(crate) fn positive(&self, column: usize) -> Result<f64, Faults> {
        let value = self.cells[column].parse::<f64>().ok();
        value
            .filter(|value| value.is_finite() && *value > 0.0)
            .ok_or_else(|| self.fault(column, "a number > 0"))
    }

    /// A number that is not negative.
    pub(crate) fn at_least_zero(&self, column: usize) -> Result<f64, Faults> {
        let value = self.cells[column].parse::<f64>().ok();
        let fault = || self.fault(column, "a number, at least 0");
        value.filter(|value| value.is_finite() && *value >= 0.0).ok_or_else(fault)
    }

    /// A whole number.
    pub(crate) fn whole(&self, column: usize) -> Result<u64, Faults> {
        self.cells[column].parse().map_err(|_| self.fault(column, "a whole number"))
    }

    /// What `read` makes of a cell; none of an empty one.
    pub(crate) fn optional<T>(
        &self,
        column: usize,
        read: impl FnOnce(&Self, usize) -> Result<T, Faults>,
    ) -> Result<Option<T>, Faults> {
        if self.cells[column].is_empty() { Ok(None) } else { read(self, column).map(Some) }
    }

    /// A fault of one cell.
    pub(crate) fn fault(&self, column: usize, allowed: &str) -> Faults {
        vec![Fault {
            file: self.file.into(),
            line: Some(self.line),
            key: self.columns[column].into(),
            value: Some(self.cells[column].into()),
            problem: Problem::OutOfRange { allowed: allowed.into() },
        }]
    }
}
