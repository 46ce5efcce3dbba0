//! What is done with a block of rows: check the text, let the command read and work, keep what was read, append what was found.

use crate::scene::{CsvProblem, Fault, Faults, Problem, forbidden_character};

use crate::csv::cells::push_cell;
use crate::csv::header::{ERROR_COLUMN, Header};
use crate::csv::row_work::{Cells, RowWork};
use crate::csv::rows::{Block, LONGEST_CELL, Row};

/// Rows that a command reads together: enough to fill vector units, few enough to stay in the cache.
const ROWS_TOGETHER: usize = 256;

/// What stays the same from row to row.
#[derive(Debug)]
pub struct Work<W> {
    /// The name of the file, for messages.
    pub file: String,
    /// The columns.
    pub header: Header,
    /// What the command does with a row.
    pub command: W,
    /// Whether a faulty row gets an `error` cell instead of stopping the run.
    pub keep_going: bool,
}

/// A block's part of the output.
#[derive(Debug)]
pub struct Worked<K> {
    /// The lines of the output.
    pub text: Vec<u8>,
    /// The faults of the rows.
    pub faults: Faults,
    /// What the command keeps, in the order of the rows.
    pub kept: Vec<K>,
    /// The rows, counted.
    pub counts: Counts,
}

/// How many rows there are of each kind.
#[derive(Debug, Default)]
pub struct Counts {
    /// All rows.
    pub rows: u64,
    /// Rows with at least one fault.
    pub faulty: u64,
    /// Rows without an answer.
    pub unanswered: u64,
    /// Rows whose input has a warning.
    pub with_warning: u64,
    /// The number of the first row with a warning, and the warning.
    pub first_warning: Option<(u64, String)>,
}

impl Counts {
    /// Adds the rows that follow these.
    pub fn add(&mut self, next: Self) {
        self.rows += next.rows;
        self.faulty += next.faulty;
        self.unanswered += next.unanswered;
        self.with_warning += next.with_warning;
        self.first_warning = self.first_warning.take().or(next.first_warning);
    }
}

impl<W: RowWork> Work<W> {
    /// Works on the rows of a block, or only reads them when the output is lost already.
    pub fn block(&self, block: &Block, only_read: bool) -> Worked<W::Kept> {
        let (text, faults, kept) = (Vec::new(), Faults::new(), Vec::new());
        let mut worked = Worked { text, faults, kept, counts: Counts::default() };
        let rows: Vec<Row<'_>> = block.rows().collect();
        for rows in rows.chunks(ROWS_TOGETHER) {
            self.rows(rows, only_read, &mut worked);
        }
        worked
    }

    /// Reads rows together, and appends them one after the other.
    fn rows(&self, rows: &[Row<'_>], only_read: bool, worked: &mut Worked<W::Kept>) {
        let checked: Vec<Result<Cells<'_>, Faults>> = rows.iter().map(|row| self.checked(*row)).collect();
        let sound: Vec<Cells<'_>> = checked.iter().flatten().copied().collect();
        let mut inputs = self.command.read_rows(&sound).into_iter();
        for (row, cells) in rows.iter().zip(checked) {
            worked.counts.rows += 1;
            match cells.map(|_| inputs.next()).and_then(Option::transpose) {
                Ok(Some(input)) if !only_read => self.append(*row, &input, worked),
                Ok(_) => {}
                Err(faults) => {
                    if self.keep_going {
                        self.append_faults(*row, &faults, &mut worked.text);
                    }
                    worked.counts.faulty += 1;
                    worked.faults.extend(faults);
                }
            }
        }
    }

    /// The cells of a row whose number and text are sound.
    fn checked<'r>(&'r self, row: Row<'r>) -> Result<Cells<'r>, Faults> {
        let cells = Cells { file: &self.file, header: &self.header, row };
        cells.check_count()?;
        check_text(cells)?;
        Ok(cells)
    }

    fn append(&self, row: Row<'_>, input: &W::Input, worked: &mut Worked<W::Kept>) {
        self.push_input(row, &mut worked.text);
        let remark = self.command.append(input, &mut worked.text);
        worked.text.extend_from_slice(if self.keep_going { b",\n" } else { b"\n" });
        worked.kept.push(remark.kept);
        worked.counts.unanswered += u64::from(remark.is_unanswered);
        if let Some(warning) = remark.warning {
            worked.counts.with_warning += 1;
            worked.counts.first_warning.get_or_insert((row.number, warning));
        }
    }

    fn append_faults(&self, row: Row<'_>, faults: &[Fault], out: &mut Vec<u8>) {
        self.push_input(row, out);
        out.extend_from_slice(",".repeat(W::APPENDED.len() + 1).as_bytes());
        let messages: Vec<String> = faults.iter().map(short_message).collect();
        push_cell(out, messages.join("; ").as_bytes());
        out.push(b'\n');
    }

    /// The header line of the output.
    pub fn header_line(&self) -> Vec<u8> {
        let mut out = Vec::new();
        let appended = W::APPENDED.iter().copied().chain(self.keep_going.then_some(ERROR_COLUMN));
        for name in self.header.names.iter().map(String::as_str).chain(appended) {
            push_cell(&mut out, name.as_bytes());
            out.push(b',');
        }
        out.pop();
        out.push(b'\n');
        out
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

/// Cells are UTF-8 without hidden characters, and not too long. Nearly all rows are plain ASCII.
fn check_text(cells: Cells<'_>) -> Result<(), Faults> {
    let row = cells.row;
    if is_plain(row) {
        return Ok(());
    }
    let faults: Faults = (0..row.cell_count())
        .filter_map(|index| cell_problem(row.cell(index)).map(|problem| cells.fault(Some(index), problem)))
        .collect();
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// Whether no cell can have a problem: printable ASCII, and not more of it than one cell may have.
fn is_plain(row: Row<'_>) -> bool {
    // All bytes are looked at, so that the loop runs in vector units.
    let is_printable = |so_far: bool, byte: &u8| so_far & (b' '..=b'~').contains(byte);
    row.bytes().len() <= LONGEST_CELL && row.bytes().iter().fold(true, is_printable)
}

/// Why a cell is not a text of the allowed length, if it is not.
pub fn cell_problem(cell: &[u8]) -> Option<Problem> {
    if cell.len() > LONGEST_CELL {
        return Some(CsvProblem::CellTooLong { bytes: cell.len(), limit: LONGEST_CELL }.into());
    }
    match std::str::from_utf8(cell) {
        Err(error) => Some(Problem::NotUtf8(error.valid_up_to() + 1)),
        Ok(text) => forbidden_character(text),
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
