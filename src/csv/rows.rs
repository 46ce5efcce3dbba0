//! Rows of a CSV stream: read block by block into memory of fixed size, with caps on cells, columns and row length.

use std::io::Read;

use crate::csv::dialect::{Dialect, with_points};
use crate::scene::{CsvProblem, Fault, Problem, is_utf16};
use csv_core::{ReadRecordResult, Reader, ReaderBuilder};

/// A stream of bytes to read, with its name for messages and its size when known.
pub struct Input {
    /// The name that messages use.
    pub name: String,
    /// The bytes.
    pub reader: Box<dyn Read + Send>,
    /// The number of bytes, of regular files.
    pub size: Option<u64>,
}

/// The most cells in a row.
pub const MOST_CELLS: usize = 1_000;
/// The longest cell, in bytes: room for a number of 10 000 digits.
pub const LONGEST_CELL: usize = 1 << 16;
/// The longest row, in bytes.
pub const LONGEST_ROW: usize = 1 << 20;

/// How much is read from the stream at a time.
const BUFFER_BYTES: usize = 1 << 18;

/// Rows of the stream with their numbers; the unit of parallel work.
#[derive(Debug, Default)]
pub struct Block {
    bytes: Vec<u8>,
    ends: Vec<usize>,
    rows: Vec<RowPlace>,
}

#[derive(Debug, Clone, Copy)]
struct RowPlace {
    first_byte: usize,
    first_end: usize,
    line: usize,
    number: u64,
}

/// One row: its cells and its place.
#[derive(Debug, Clone, Copy)]
pub struct Row<'b> {
    bytes: &'b [u8],
    ends: &'b [usize],
    /// The line of the file on which the row ends, counted from 1.
    pub line: usize,
    /// The number of the row, the header being row 0.
    pub number: u64,
}

impl<'b> Row<'b> {
    /// The number of cells.
    pub fn cell_count(self) -> usize {
        self.ends.len()
    }

    /// The bytes of a cell; empty beyond the end of a short row.
    pub fn cell(self, index: usize) -> &'b [u8] {
        let start = if index == 0 { 0 } else { self.ends.get(index - 1).copied().unwrap_or(0) };
        self.ends.get(index).and_then(|end| self.bytes.get(start..*end)).unwrap_or_default()
    }

    /// All bytes of the row, without separators.
    pub fn bytes(self) -> &'b [u8] {
        self.bytes
    }
}

impl Block {
    /// The rows in order.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().enumerate().map(|(index, place)| {
            let next = self.rows.get(index + 1);
            let last_byte = next.map_or(self.bytes.len(), |next| next.first_byte);
            let last_end = next.map_or(self.ends.len(), |next| next.first_end);
            Row {
                bytes: &self.bytes[place.first_byte..last_byte],
                ends: &self.ends[place.first_end..last_end],
                line: place.line,
                number: place.number,
            }
        })
    }

    /// Whether the block has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// A reader of rows; blank lines are skipped, a byte order mark at the start is dropped.
pub struct RowReader {
    input: Input,
    has_decimal_commas: bool,
    parser: Reader,
    buffer: Vec<u8>,
    unread: std::ops::Range<usize>,
    at_end: bool,
    row_bytes: Vec<u8>,
    row_ends: Vec<usize>,
    lines: usize,
    number: u64,
    consumed: u64,
}

impl RowReader {
    /// A reader at the start of the stream.
    pub fn new(input: Input, dialect: Dialect) -> Self {
        Self {
            input,
            has_decimal_commas: dialect.has_decimal_commas,
            parser: ReaderBuilder::new().delimiter(dialect.delimiter).build(),
            buffer: vec![0; BUFFER_BYTES],
            unread: 0..0,
            at_end: false,
            row_bytes: vec![0; LONGEST_ROW],
            row_ends: vec![0; MOST_CELLS],
            lines: 0,
            number: 0,
            consumed: 0,
        }
    }

    /// The name of the stream for messages.
    pub fn name(&self) -> &str {
        &self.input.name
    }

    /// The number of bytes of the stream, of regular files.
    pub fn size(&self) -> Option<u64> {
        self.input.size
    }

    /// The bytes consumed so far.
    pub fn consumed(&self) -> u64 {
        self.consumed
    }

    /// The next rows, at most `count`; an empty block at the end of the stream.
    ///
    /// # Errors
    /// When the stream cannot be read or parsed: after that its rows cannot be separated.
    pub fn block(&mut self, count: usize) -> Result<Block, Fault> {
        let mut block = Block::default();
        while block.rows.len() < count && self.row_into(&mut block)? {}
        Ok(block)
    }

    fn row_into(&mut self, block: &mut Block) -> Result<bool, Fault> {
        let (mut bytes, mut ends) = (0, 0);
        loop {
            if self.unread.is_empty() && !self.at_end {
                self.fill()?;
            }
            let input = &self.buffer[self.unread.clone()];
            let (result, read, written, ended) =
                self.parser.read_record(input, &mut self.row_bytes[bytes..], &mut self.row_ends[ends..]);
            let taken = &input[..read];
            self.lines += taken.iter().filter(|byte| **byte == b'\n').count();
            let ends_in_line_feed = taken.last() == Some(&b'\n');
            self.unread.start += read;
            self.consumed += read as u64;
            bytes += written;
            ends += ended;
            match result {
                ReadRecordResult::InputEmpty if self.at_end && bytes + ends > 0 => {
                    return Err(self.fault(CsvProblem::UnclosedQuote));
                }
                ReadRecordResult::InputEmpty if self.at_end => return Ok(false),
                ReadRecordResult::InputEmpty => {}
                ReadRecordResult::OutputFull => return Err(self.fault(CsvProblem::RowTooLong(LONGEST_ROW))),
                ReadRecordResult::OutputEndsFull => {
                    return Err(self.fault(CsvProblem::TooManyCells(MOST_CELLS)));
                }
                ReadRecordResult::Record => {
                    let line = self.lines + usize::from(!ends_in_line_feed);
                    return self.keep(block, bytes, ends, line).map(|()| true);
                }
                ReadRecordResult::End => return Ok(false),
            }
        }
    }

    /// Reads more; at the end of the stream one line feed, so that a last row without one ends, and a quoted cell does not.
    fn fill(&mut self) -> Result<(), Fault> {
        let read = loop {
            match self.input.reader.read(&mut self.buffer) {
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                Err(error) => return Err(self.place(Problem::from(&error))),
                Ok(read) => break read,
            }
        };
        if self.consumed == 0 && is_utf16(&self.buffer[..read]) {
            return Err(self.place(Problem::Utf16));
        }
        self.at_end = read == 0;
        if self.at_end {
            self.buffer[0] = b'\n';
        }
        self.unread = 0..read.max(1);
        Ok(())
    }

    fn keep(&mut self, block: &mut Block, bytes: usize, ends: usize, line: usize) -> Result<(), Fault> {
        let (first_byte, first_end) = (block.bytes.len(), block.ends.len());
        block.rows.push(RowPlace { first_byte, first_end, line, number: self.number });
        if self.has_decimal_commas && self.number > 0 {
            self.keep_with_points(block, ends)?;
        } else {
            block.bytes.extend_from_slice(&self.row_bytes[..bytes]);
            block.ends.extend_from_slice(&self.row_ends[..ends]);
        }
        self.number += 1;
        Ok(())
    }

    /// Keeps a row whose numbers get decimal points.
    fn keep_with_points(&self, block: &mut Block, ends: usize) -> Result<(), Fault> {
        let (mut start, mut length) = (0, 0);
        for end in &self.row_ends[..ends] {
            let cell = &self.row_bytes[start..*end];
            let text = std::str::from_utf8(cell).unwrap_or_default();
            let replaced = with_points(text)
                .map_err(|problem| Fault { value: Some(text.to_string()), ..self.fault(problem) })?;
            let kept = replaced.as_deref().map_or(cell, str::as_bytes);
            block.bytes.extend_from_slice(kept);
            length += kept.len();
            block.ends.push(length);
            start = *end;
        }
        Ok(())
    }

    fn fault(&self, problem: CsvProblem) -> Fault {
        self.place(Problem::Csv(problem))
    }

    fn place(&self, problem: Problem) -> Fault {
        let key = if self.number == 0 { "header".into() } else { format!("row {}", self.number) };
        Fault::of(&self.input.name, key, problem).at(Some(self.lines + 1))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::csv::cells::push_cell;

    fn read(text: &[u8]) -> Result<Vec<(usize, u64, Vec<String>)>, Fault> {
        let input =
            Input { name: "f".into(), reader: Box::new(std::io::Cursor::new(text.to_vec())), size: None };
        let block = RowReader::new(input, Dialect::default()).block(1_000_000)?;
        let cells = |row: Row<'_>| -> Vec<String> {
            (0..row.cell_count()).map(|i| String::from_utf8_lossy(row.cell(i)).into_owned()).collect()
        };
        Ok(block.rows().map(|row| (row.line, row.number, cells(row))).collect())
    }

    #[test]
    fn rows_know_their_number_and_line() {
        for end in ["\n", "\r\n"] {
            let text = ["a,b", "", "1,\"x\ny\"", "2,3"].join(end);
            let rows = read(text.as_bytes()).unwrap();
            let places: Vec<_> = rows.iter().map(|(line, number, _)| (*line, *number)).collect();
            assert_eq!(places, [(1, 0), (4, 1), (5, 2)]);
            assert_eq!(rows[1].2, ["1", "x\ny"]);
        }
        assert_eq!(read(b"\xef\xbb\xbfa\n").unwrap()[0].2, ["a"]);
        assert!(read(b"").unwrap().is_empty());
    }

    #[test]
    fn a_quote_that_never_closes_is_a_fault_not_a_cell() {
        assert_eq!(read(b"a,b\n1,\"2\n3,4\n").unwrap_err().problem, CsvProblem::UnclosedQuote.into());
        assert_eq!(read(b"a,\"").unwrap_err().problem, CsvProblem::UnclosedQuote.into());
        let long = format!("a\n\"{}", "x\n".repeat(LONGEST_ROW));
        assert_eq!(read(long.as_bytes()).unwrap_err().problem, CsvProblem::RowTooLong(LONGEST_ROW).into());
    }

    #[test]
    fn the_number_of_cells_is_capped() {
        assert!(read(",".repeat(MOST_CELLS - 1).as_bytes()).is_ok());
        let wide = read(",".repeat(20_000_000).as_bytes()).unwrap_err();
        assert_eq!(wide.problem, CsvProblem::TooManyCells(MOST_CELLS).into());
    }

    proptest! {
        #[test]
        fn any_bytes_end_in_rows_or_a_fault(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            if let Err(fault) = read(&bytes) {
                prop_assert!(fault.to_string().starts_with("f:"));
            }
        }

        #[test]
        fn cells_that_are_written_are_read_back(
            rows in prop::collection::vec(prop::array::uniform3("[a-z0-9 ,\"\n\r]{1,6}"), 1..5),
        ) {
            let mut text = Vec::new();
            for row in &rows {
                for (index, cell) in row.iter().enumerate() {
                    if index > 0 {
                        text.push(b',');
                    }
                    push_cell(&mut text, cell.as_bytes());
                }
                text.push(b'\n');
            }
            let back: Vec<_> = read(&text).unwrap().into_iter().map(|(_, _, cells)| cells).collect();
            // A leading carriage return would start a formula and is disarmed.
            let disarmed = |cell: &String| if cell.starts_with('\r') { format!("'{cell}") } else { cell.clone() };
            let expected: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(disarmed).collect()).collect();
            prop_assert_eq!(back, expected);
        }
    }
}
