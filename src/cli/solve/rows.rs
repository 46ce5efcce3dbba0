//! `solve --points`: the solutions of every row.

use serde_json::Value;
use slipmode::csv::{Cells, Remark, RowWork, push_cell};
use slipmode::scene::{Faults, Problem, Quantity, Uncertain};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::ParameterBox;

use crate::cli::answer::cell;
use crate::cli::solve::Question;
use crate::cli::unit_warnings::unit_warnings;

/// Columns of solutions.
const MOST_SOLUTIONS: usize = 4;

/// Solves for rows.
#[derive(Debug)]
pub struct SolveRows {
    /// The question that every row is asked.
    pub question: Question,
}

/// What a row says.
#[derive(Debug)]
pub struct Row {
    /// All values within its error bars, and 1 for the unknown.
    region: ParameterBox,
    is_point: bool,
    warnings: Vec<String>,
}

impl RowWork for SolveRows {
    type Input = Row;
    type Kept = ();

    const APPENDED: &'static [&'static str] =
        &["solutions", "solution_1", "solution_2", "solution_3", "solution_4", "status"];
    const BLOCK_ROWS: usize = 16;
    const BLOCKS_PER_THREAD: usize = 4;

    fn unused(&self) -> Vec<Quantity> {
        vec![self.question.quantity()]
    }

    fn read(&self, cells: Cells<'_>) -> Result<Row, Faults> {
        let values = cells.uncertain_without(&self.unused())?;
        let is_point = values.iter().all(Uncertain::is_certain);
        let mut known = values.each_ref().map(|value| Some(nearest_f64(&value.middle())));
        known[self.question.quantity() as usize] = None;
        let needs = || vec![cells.fault(None, Problem::Needs("positive values".into()))];
        let region = Uncertain::region(values).ok_or_else(needs)?;
        Ok(Row { region, is_point, warnings: unit_warnings(known, &[]) })
    }

    fn append(&self, row: &Row, out: &mut Vec<u8>) -> Remark {
        let answer = self.question.answer(&row.region, row.is_point);
        let (count, solutions, status) = match &answer {
            Ok(answer) => {
                let solutions = answer.value("solutions").as_array().map_or(&[][..], Vec::as_slice);
                let status = if solutions.is_empty() { "none" } else { "solved" };
                (solutions.len().to_string(), columns(solutions), status.to_string())
            }
            Err(undecided) => (String::new(), Vec::new(), undecided.to_string()),
        };
        let columns = (0..MOST_SOLUTIONS).map(|index| solutions.get(index).cloned().unwrap_or_default());
        for cell in [count].into_iter().chain(columns).chain([status]) {
            out.push(b',');
            push_cell(out, cell.as_bytes());
        }
        Remark { is_unanswered: answer.is_err(), ..Remark::warning(&row.warnings) }
    }
}

/// Makes a cell of each solution, a value or a range. Beyond the columns, the last range reaches to the end of all that are left.
fn columns(solutions: &[Value]) -> Vec<String> {
    let mut solutions = solutions.to_vec();
    if let Some(beyond) = solutions.get(MOST_SOLUTIONS..).and_then(<[_]>::last).cloned()
        && let Some(end) = solutions[MOST_SOLUTIONS - 1].pointer_mut("/range/1")
    {
        *end = beyond["range"][1].clone();
    }
    solutions.iter().map(|solution| cell(&solution["value"]) + &cell(&solution["range"])).collect()
}
