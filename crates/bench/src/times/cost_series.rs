//! The series of measured costs, each with its laws, and what these predict for sizes that were not measured.

use super::CostRow;
use crate::least_squares::Law;

/// The rows of one series, from small to large, and the laws fitted to them.
#[derive(Debug, Clone, PartialEq)]
pub struct CostSeries<'r> {
    /// Its rows.
    pub rows: Vec<&'r CostRow>,
    /// The law of all rows; none without a form.
    pub law: Option<Law>,
    /// The law of all rows but the last: what it says of the last is a test of it.
    pub law_below_top: Option<Law>,
}

impl CostSeries<'_> {
    /// (size, CPU seconds) of each row.
    #[must_use]
    pub fn points(&self) -> Vec<(f64, f64)> {
        self.rows.iter().map(|row| (row.size, row.cpu_s)).collect()
    }
}

/// The series of a file, in its order.
#[must_use]
pub fn cost_series(rows: &[CostRow]) -> Vec<CostSeries<'_>> {
    let parts = rows.chunk_by(|one, next| one.series == next.series);
    parts
        .map(|rows| {
            let points: Vec<(f64, f64)> = rows.iter().map(|row| (row.size, row.cpu_s)).collect();
            let form = rows.first().and_then(|row| row.form);
            let fit = |points: &[(f64, f64)]| form.and_then(|form| Law::fit(form, points));
            let below = points.split_last().and_then(|(_, below)| fit(below));
            CostSeries { rows: rows.iter().collect(), law: fit(&points), law_below_top: below }
        })
        .collect()
}
