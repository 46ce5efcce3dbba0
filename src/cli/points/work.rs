//! What is done with a row: read its seven numbers, classify, append.

use std::io::Write;

use slipmode::friction::Parameters;
use slipmode::number::{Dd, Rational, parse_short_decimal};
use slipmode::scene::{AllowedRange, CsvProblem, Fault, Faults, Problem, is_forbidden, parameters_from};
use slipmode::stability::{Classification, InertialThreshold, classify, classify_quickly};

use crate::cli::points::cells::push_cell;
use crate::cli::points::header::{APPENDED, Header};
use crate::cli::points::rows::{Block, LONGEST_CELL, Row};

/// What stays the same from row to row.
#[derive(Debug)]
pub struct Work {
    /// The name of the file, for messages.
    pub file: String,
    /// The columns.
    pub header: Header,
    /// From which ω/ω_n on an oscillation is called inertial.
    pub threshold: InertialThreshold,
    /// Whether a faulty row gets an `error` cell instead of stopping the run.
    pub keep_going: bool,
}

/// A block's part of the output.
#[derive(Debug, Default)]
pub struct Worked {
    /// The lines of the output.
    pub text: Vec<u8>,
    /// The faults of the rows.
    pub faults: Faults,
}

impl Work {
    /// Classifies the rows of a block.
    pub fn block(&self, block: &Block) -> Worked {
        let mut worked = Worked::default();
        for row in block.rows() {
            match self.classify_row(row) {
                Ok(found) => {
                    self.push_input(row, &mut worked.text);
                    push_result(&mut worked.text, &found);
                    worked.text.extend_from_slice(if self.keep_going { b",\n" } else { b"\n" });
                }
                Err(faults) => {
                    if self.keep_going {
                        self.push_input(row, &mut worked.text);
                        worked.text.extend_from_slice(",".repeat(APPENDED.len() + 1).as_bytes());
                        let messages: Vec<String> = faults.iter().map(short_message).collect();
                        push_cell(&mut worked.text, messages.join("; ").as_bytes());
                        worked.text.push(b'\n');
                    }
                    worked.faults.extend(faults);
                }
            }
        }
        worked
    }

    fn classify_row(&self, row: Row<'_>) -> Result<Classification, Faults> {
        let wanted = self.header.names.len();
        if row.len() != wanted {
            let problem = CsvProblem::CellCount { found: row.len(), wanted };
            return Err(vec![self.fault(row, None, problem.into())]);
        }
        self.check_text(row)?;
        let quick = self.short_parameters(row).and_then(|short| classify_quickly(&short, &self.threshold));
        match quick {
            Some(found) => Ok(found),
            None => Ok(classify(&self.parameters(row)?, &self.threshold)),
        }
    }

    /// The seven numbers when all are short and positive, as nearly all are.
    fn short_parameters(&self, row: Row<'_>) -> Option<Parameters<Dd>> {
        let mut values = [Dd::from(0.0); 7];
        for (value, position) in values.iter_mut().zip(self.header.positions) {
            *value = parse_short_decimal(std::str::from_utf8(row.cell(position)).ok()?)?;
        }
        Some(parameters_from(values))
    }

    fn parameters(&self, row: Row<'_>) -> Result<Parameters<Rational>, Faults> {
        let mut faults = Faults::new();
        let values = [0, 1, 2, 3, 4, 5, 6].map(|index| {
            let position = self.header.positions[index];
            // The row's text was checked, so that no cell is lost here.
            let text = std::str::from_utf8(row.cell(position)).unwrap_or_default();
            AllowedRange::PHYSICAL
                .parse(text)
                .map_err(|problem| faults.push(self.fault(row, Some(position), problem)))
                .ok()
        });
        match values {
            [Some(a), Some(b), Some(d), Some(k), Some(m), Some(s), Some(v)] => {
                Ok(parameters_from([a, b, d, k, m, s, v]))
            }
            _ => Err(faults),
        }
    }

    /// Cells are UTF-8 without hidden characters, and not too long. Nearly all rows are plain ASCII.
    fn check_text(&self, row: Row<'_>) -> Result<(), Faults> {
        if is_plain(row) {
            return Ok(());
        }
        let faults: Faults = (0..row.len())
            .filter_map(|index| {
                cell_problem(row.cell(index)).map(|problem| self.fault(row, Some(index), problem))
            })
            .collect();
        if faults.is_empty() { Ok(()) } else { Err(faults) }
    }

    fn fault(&self, row: Row<'_>, column: Option<usize>, problem: Problem) -> Fault {
        let key = match column.and_then(|index| self.header.names.get(index)) {
            Some(name) => format!("row {}, column {name}", row.number),
            None => format!("row {}", row.number),
        };
        let value = column.map(|index| String::from_utf8_lossy(row.cell(index)).into_owned());
        Fault { file: self.file.clone(), line: Some(row.line), key, value, problem }
    }

    /// The input's cells, brought to the header's number; a cell that is not text is left out and named by its error.
    fn push_input(&self, row: Row<'_>, out: &mut Vec<u8>) {
        let is_plain = is_plain(row);
        for index in 0..self.header.names.len() {
            if index > 0 {
                out.push(b',');
            }
            let cell = row.cell(index);
            if is_plain || cell_problem(cell).is_none() {
                push_cell(out, cell);
            }
        }
    }
}

/// Whether no cell can have a problem: printable ASCII, and not more of it than one cell may have.
fn is_plain(row: Row<'_>) -> bool {
    row.bytes().len() <= LONGEST_CELL && row.bytes().iter().all(|byte| (b' '..=b'~').contains(byte))
}

fn cell_problem(cell: &[u8]) -> Option<Problem> {
    if cell.len() > LONGEST_CELL {
        return Some(CsvProblem::CellTooLong { bytes: cell.len(), limit: LONGEST_CELL }.into());
    }
    match std::str::from_utf8(cell) {
        Err(error) => Some(Problem::NotUtf8(error.valid_up_to() + 1)),
        Ok(text) => text
            .chars()
            .find(|character| is_forbidden(*character))
            .map(|character| Problem::ForbiddenCharacter(u32::from(character))),
    }
}

/// A fault without file and row, which its own row shows.
fn short_message(fault: &Fault) -> String {
    let key = fault.key.split_once(", ").map_or("row", |(_, column)| column);
    Fault { file: String::new(), line: None, key: key.to_string(), ..fault.clone() }
        .to_string()
        .trim_start_matches(": ")
        .to_string()
}

fn push_result(out: &mut Vec<u8>, found: &Classification) {
    // A vector takes every write.
    let _ = write!(
        out,
        ",{},{},{},{},{},{},{}",
        found.transition_sign,
        found.boundary_sign,
        found.spectral_class.as_str(),
        found.slip_mode.as_str(),
        found.max_real_per_s,
        found.max_imaginary_per_s,
        found.rung.as_str(),
    );
}

/// The header line of the output.
pub fn header_line(header: &Header, keep_going: bool) -> Vec<u8> {
    let mut out = Vec::new();
    for name in &header.names {
        push_cell(&mut out, name.as_bytes());
        out.push(b',');
    }
    out.extend_from_slice(APPENDED.join(",").as_bytes());
    if keep_going {
        out.push(b',');
        out.extend_from_slice(crate::cli::points::header::ERROR_COLUMN.as_bytes());
    }
    out.push(b'\n');
    out
}
