//! `solve --points`: the solutions of every row.

use slipmode::csv::{Cells, Remark, RowWork, push_cell};
use slipmode::scene::{Faults, Quantity};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::solve::Question;
use crate::cli::solve::view::printed;
use crate::cli::unit_warnings::unit_warnings;

/// Columns of solutions.
const MOST_SOLUTIONS: usize = 4;

/// Solves for rows.
#[derive(Debug)]
pub struct SolveRows {
    /// The question that every row is asked.
    pub question: Question,
}

impl RowWork for SolveRows {
    type Input = Parameters<Rational>;
    type Kept = ();

    const APPENDED: &'static [&'static str] =
        &["solutions", "solution_1", "solution_2", "solution_3", "solution_4", "status"];
    const BLOCK_ROWS: usize = 16;
    const BLOCKS_PER_THREAD: usize = 4;

    fn unknown(&self) -> Option<Quantity> {
        Some(self.question.quantity())
    }

    fn read(&self, cells: Cells<'_>) -> Result<Parameters<Rational>, Faults> {
        cells.parameters_without(self.unknown())
    }

    fn append(&self, parameters: &Parameters<Rational>, out: &mut Vec<u8>) -> Remark {
        let digits = self.question.digits as usize;
        let (count, values, status) = match self.question.solve(parameters) {
            Ok(found) => {
                let values: Vec<String> = found.iter().map(|solution| printed(solution, digits).0).collect();
                let status = if found.is_empty() { "none" } else { "solved" };
                (found.len().to_string(), values, status.to_string())
            }
            Err(undecided) => (String::new(), Vec::new(), undecided.to_string()),
        };
        let is_unanswered = count.is_empty();
        let columns = (0..MOST_SOLUTIONS).map(|index| values.get(index).cloned().unwrap_or_default());
        for cell in [count].into_iter().chain(columns).chain([status]) {
            out.push(b',');
            push_cell(out, cell.as_bytes());
        }
        let values: [Rational; 7] = parameters.clone().into();
        let mut known = values.each_ref().map(|value| Some(nearest_f64(value)));
        known[self.question.quantity() as usize] = None;
        let warnings = unit_warnings(known, &[]);
        let warning = (!warnings.is_empty()).then(|| warnings.join("; "));
        Remark { is_unanswered, warning, ..Remark::default() }
    }
}
