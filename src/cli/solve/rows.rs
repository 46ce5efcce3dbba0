//! `solve --points`: the solutions of every row.

use slipmode::csv::{Cells, Remark, RowWork, push_cell};
use slipmode::scene::{Faults, Problem, Quantity, Uncertain};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::ParameterBox;

use crate::cli::options::uncertain_box;
use crate::cli::solve::over_box::StableForBox;
use crate::cli::solve::ranges::{cell, ranges};
use crate::cli::solve::view::printed;
use crate::cli::solve::{Asked, Question};
use crate::cli::unit_warnings::unit_warnings;

/// Columns of solutions.
const MOST_SOLUTIONS: usize = 4;

/// Solves for rows.
#[derive(Debug)]
pub struct SolveRows {
    /// The question that every row is asked.
    pub asked: Asked,
}

/// What a row says.
#[derive(Debug)]
pub struct Row {
    /// All values within its error bars, and 1 for the unknown.
    region: ParameterBox,
    /// The values, where none has an error bar.
    point: Option<Parameters<Rational>>,
    /// The middle of each value, but of the unknown.
    known: [Option<f64>; 7],
}

/// The solutions of a row: their number, a cell for each, and the status.
type Solved = (String, Vec<String>, String);

impl RowWork for SolveRows {
    type Input = Row;
    type Kept = ();

    const APPENDED: &'static [&'static str] =
        &["solutions", "solution_1", "solution_2", "solution_3", "solution_4", "status"];
    const BLOCK_ROWS: usize = 16;
    const BLOCKS_PER_THREAD: usize = 4;

    fn unknown(&self) -> Option<Quantity> {
        Some(self.asked.quantity())
    }

    fn read(&self, cells: Cells<'_>) -> Result<Row, Faults> {
        let values = cells.uncertain_without(self.unknown())?;
        let is_point = values.iter().all(Uncertain::is_certain);
        let middles = values.each_ref().map(Uncertain::middle);
        let mut known = middles.each_ref().map(|value| Some(nearest_f64(value)));
        known[self.asked.quantity() as usize] = None;
        let needs = || vec![cells.fault(None, Problem::Needs("positive values".into()))];
        let region = uncertain_box(values).ok_or_else(needs)?;
        Ok(Row { region, point: is_point.then(|| Parameters::from(middles)), known })
    }

    fn append(&self, row: &Row, out: &mut Vec<u8>) -> Remark {
        let (count, values, status) = match (&self.asked, &row.point) {
            (Asked::Target(question), Some(point)) => at_point(question, point),
            (Asked::Target(question), None) => over_box(question, &row.region),
            (Asked::StableForBox { digits }, _) => {
                let (least, _) = StableForBox::new(row.region.clone(), *digits).printed();
                ("1".to_string(), vec![least], "solved".to_string())
            }
        };
        let is_unanswered = count.is_empty();
        let columns = (0..MOST_SOLUTIONS).map(|index| values.get(index).cloned().unwrap_or_default());
        for cell in [count].into_iter().chain(columns).chain([status]) {
            out.push(b',');
            push_cell(out, cell.as_bytes());
        }
        let warnings = unit_warnings(row.known, &[]);
        let warning = (!warnings.is_empty()).then(|| warnings.join("; "));
        Remark { is_unanswered, warning, ..Remark::default() }
    }
}

fn status(count: usize) -> String {
    if count == 0 { "none" } else { "solved" }.to_string()
}

fn at_point(question: &Question, point: &Parameters<Rational>) -> Solved {
    match question.solve(point) {
        Ok(found) => {
            let digits = question.digits as usize;
            let values = found.iter().map(|solution| printed(solution, digits).0).collect();
            (found.len().to_string(), values, status(found.len()))
        }
        Err(undecided) => (String::new(), Vec::new(), undecided.to_string()),
    }
}

/// The ranges of solutions; beyond the columns, the last one holds all that are left.
fn over_box(question: &Question, region: &ParameterBox) -> Solved {
    let mut ranges = ranges(question, region);
    let count = ranges.len();
    if let Some(beyond) = ranges.get(MOST_SOLUTIONS..).and_then(<[_]>::last) {
        let highest = beyond.enclosure[1];
        ranges.truncate(MOST_SOLUTIONS);
        ranges[MOST_SOLUTIONS - 1].enclosure[1] = highest;
    }
    (count.to_string(), ranges.iter().map(cell).collect(), status(count))
}
