//! A table of a program, read as a points file is: by the names of its columns, with units and errors.

use std::io::{Cursor, sink};

use slipmode::csv::{Cells, Dialect, Input, Remark, RowReader, RowWork};
use slipmode::scene::{Faults, Quantity, Uncertain};
use slipmode_core::number::Rational;
use slipmode_core::number::format::exact_text;

use crate::cli::failure::Failure;
use crate::cli::points::Started;
use crate::cli::progress::Progress;
use crate::cli::{Captured, captured};

/// Where the seven quantities and their errors stand in a table.
#[derive(Debug)]
pub struct TableColumns {
    /// The column of each of [`Quantity::ALL`]; none for the unused.
    pub positions: [Option<usize>; 7],
    /// The size in SI of the unit that the name of each column states; none for SI.
    pub units: [Option<Rational>; 7],
    /// The columns of errors.
    pub errors: Vec<usize>,
}

/// Finds the quantities by the names of columns: the header line of a CSV file. The columns of the unused ones may be missing.
///
/// ```
/// let header = b"a,b,Dc [um],K_MPa_per_mm,m,sigma,v,a_err\n".to_vec();
/// let (found, messages) = slipmode::cli::capture_columns(header, vec![]);
/// let found = found.unwrap();
/// assert_eq!((found.positions[2], found.errors, messages.exit_code), (Some(2), vec![7], 0));
/// assert_eq!(found.units[3].as_ref().unwrap(), &1_000_000_000);
/// ```
pub fn capture_columns(header: Vec<u8>, unused: Vec<Quantity>) -> (Option<TableColumns>, Captured) {
    captured(false, || {
        let mut reader = reader(header);
        let first = reader.block(1)?;
        let work = ReadRows { unused };
        let header = work.read_header(TABLE, first.rows().next(), false)?;
        let known = |quantity: Quantity| !work.unused.contains(&quantity);
        Ok(TableColumns {
            positions: Quantity::ALL.map(|of| known(of).then_some(header.positions[of as usize])),
            units: Quantity::ALL.map(|of| header.unit(of as usize).filter(|_| known(of)).cloned()),
            errors: Quantity::ALL.into_iter().filter_map(|of| header.error_position(of)).collect(),
        })
    })
}

/// The seven values of every row in SI, exact, as `0.009` or with its error bar as `[0.008, 0.01]`. A row with an empty cell has
/// empty texts, and so have the unused quantities.
pub fn capture_rows(csv: Vec<u8>, unused: Vec<Quantity>) -> (Option<Vec<[String; 7]>>, Captured) {
    captured(false, || {
        let started = Started::new(reader(csv), ReadRows { unused }, false, Progress::new(true))?;
        Ok::<_, Failure>(started.work(&mut sink())?.kept)
    })
}

/// What messages call the table.
const TABLE: &str = "table";

fn reader(csv: Vec<u8>) -> RowReader {
    let input = Input { name: TABLE.into(), reader: Box::new(Cursor::new(csv)), size: None };
    RowReader::new(input, Dialect { delimiter: b',', has_decimal_commas: false })
}

/// Reads rows and does nothing else.
struct ReadRows {
    unused: Vec<Quantity>,
}

impl RowWork for ReadRows {
    type Input = [String; 7];
    type Kept = [String; 7];

    const APPENDED: &'static [&'static str] = &[];
    const BLOCK_ROWS: usize = 2048;
    const BLOCKS_PER_THREAD: usize = 1;

    fn unused(&self) -> Vec<Quantity> {
        self.unused.clone()
    }

    fn read(&self, cells: Cells<'_>) -> Result<[String; 7], Faults> {
        let is_known = |quantity: &Quantity| !self.unused.contains(quantity);
        let mut texts = Quantity::ALL.into_iter().filter(is_known);
        if texts.any(|of| cells.text(cells.header.positions[of as usize]).trim().is_empty()) {
            return Ok(<[String; 7]>::default());
        }
        let values = cells.uncertain_without(&self.unused)?;
        let text = |quantity: Quantity| match &values[quantity as usize] {
            _ if !is_known(&quantity) => String::new(),
            value if value.is_certain() => exact_text(&value.lower),
            Uncertain { lower, upper } => format!("[{}, {}]", exact_text(lower), exact_text(upper)),
        };
        Ok(Quantity::ALL.map(text))
    }

    fn append(&self, texts: &[String; 7], _: &mut Vec<u8>) -> Remark<[String; 7]> {
        Remark { kept: texts.clone(), ..Remark::default() }
    }
}
