//! Samples over time, streamed: a time and other numbers on each row, with every fault named by line and column.

use crate::csv::header::{Beyond, Header, dd_in_unit};
use crate::csv::name::Wanted;
use crate::csv::row_work::Cells;
use crate::csv::rows::RowReader;
use crate::csv::work::cell_problem;
use crate::scene::{AllowedRange, CsvProblem, Fault, Faults, Problem, not_a_number};
use slipmode_core::number::{Dd, Rational, nearest_f64, parse_decimal};

/// Rows read at a time.
const BLOCK_ROWS: usize = 4096;
/// The most faults that are reported of one file.
pub const MOST_FAULTS: usize = 20;
/// What a cell may be, for messages.
const SIGNED: &str = "-1e300 to 1e300";

/// The columns of a file of samples, and how many it may have.
pub struct Samples<'c, const N: usize> {
    /// The columns, the time first.
    pub columns: [Wanted; N],
    /// Columns of which positive values have to be of a physical size.
    pub physical: &'c [usize],
    /// What a column of errors would need; none where errors are read.
    pub needs_for_errors: Option<&'c str>,
    /// The most samples.
    pub most: usize,
}

/// The cells of a sample.
pub type SampleCells<'r, const N: usize> = Cells<'r, [Option<usize>; N]>;

impl<const N: usize> Samples<'_, N> {
    /// Reads all samples and gives each to `take`: its cells and its numbers in SI; `take` says whether the next one has to be later.
    /// Gives the faults of rows, up to twenty.
    ///
    /// # Errors
    /// The faults of the header.
    pub fn read(
        self,
        mut reader: RowReader,
        mut take: impl FnMut(SampleCells<'_, N>, [Option<f64>; N]) -> bool,
    ) -> Result<Faults, Faults> {
        let file = reader.name().to_string();
        let first = reader.block(1).map_err(|fault| vec![fault])?;
        let beyond = Beyond { appended: &[], needs_for_errors: self.needs_for_errors, reads: &|_| false };
        let header = Header::of_columns(&file, first.rows().next(), self.columns, &beyond, |_| Vec::new())?;
        let mut faults = Faults::new();
        let (mut last, mut count) = (None, 0);
        loop {
            let block = reader.block(BLOCK_ROWS).map_err(|fault| vec![fault])?;
            if block.is_empty() || faults.len() >= MOST_FAULTS {
                break;
            }
            for row in block.rows() {
                let cells = Cells { file: &file, header: &header, row };
                match numbers(cells, self.physical, last) {
                    Ok(values) if take(cells, values) => last = values[0],
                    Ok(_) => {}
                    Err(found) => faults.extend(found),
                }
                count += 1;
            }
            if count > self.most {
                faults.push(Fault::of(&file, "", CsvProblem::TooManyRows(self.most)));
                break;
            }
        }
        faults.truncate(MOST_FAULTS);
        Ok(faults)
    }
}

/// The numbers of a row; its time is later than the last one.
fn numbers<const N: usize>(
    cells: SampleCells<'_, N>,
    physical: &[usize],
    last: Option<f64>,
) -> Result<[Option<f64>; N], Faults> {
    cells.check_count()?;
    let mut faults = Faults::new();
    let mut values = [None; N];
    for (index, position) in cells.header.positions.into_iter().enumerate() {
        let Some(position) = position else { continue };
        let (cell, unit) = (cells.row.cell(position), cells.header.unit(index));
        match number(cell, physical.contains(&index), unit) {
            Ok(value) => values[index] = Some(value),
            Err(problem) => faults.push(cells.fault(Some(position), problem)),
        }
    }
    if let (Some(time), Some(last)) = (values[0], last)
        && time <= last
    {
        let allowed = format!("more than {last:e}, the time of the row before");
        faults.push(cells.fault(cells.header.positions[0], CsvProblem::NotIncreasing(allowed).into()));
    }
    if faults.is_empty() { Ok(values) } else { Err(faults) }
}

/// A cell as the nearest 64-bit number in SI; its decimal is read exactly first.
pub fn number(cell: &[u8], is_physical: bool, unit: Option<&Rational>) -> Result<f64, Problem> {
    if let Some(problem) = cell_problem(cell) {
        return Err(problem);
    }
    let text = std::str::from_utf8(cell.trim_ascii()).unwrap_or_default();
    if let Some(value) = dd_in_unit(text, unit)
        && value.rounds_surely(Dd::UNIT * value.hi())
    {
        return Ok(value.hi());
    }
    let value = parse_decimal(text).map_err(|reason| not_a_number(text, reason, None))?;
    let value = unit.map_or_else(|| value.clone(), |size| Rational::from(&value * size));
    if is_physical && value > 0 {
        return AllowedRange::PHYSICAL.check(value).map(|value| nearest_f64(&value));
    }
    let limit = parse_decimal("1e300").unwrap_or_default();
    let size = Rational::from(value.abs_ref());
    if size <= limit { Ok(nearest_f64(&value)) } else { Err(Problem::OutOfRange { allowed: SIGNED.into() }) }
}
