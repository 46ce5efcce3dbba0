//! Numbers of a table for sentences: the least or largest value, and counts.

use slipmode_core::number::format::{round_digits, rounded};

use super::statement::{Number, What};
use super::truth::Rows;

impl Number {
    /// The number; none where it is open which rows it is about, or where a value is missing.
    pub fn text(&self, rows: &Rows) -> Option<String> {
        let mut chosen = Vec::new();
        for at in 0..rows.rows.len() {
            chosen.extend(rows.truth(&self.selected, at).is?.then_some(at));
        }
        let What::Extreme { least, of, digits, side } = &self.what else {
            return Some(chosen.len().to_string());
        };
        let values = chosen.into_iter().map(|at| Some(rows.value(of, at)?.to_f64()));
        let values = values.collect::<Option<Vec<f64>>>()?;
        let found = values.into_iter().reduce(if *least { f64::min } else { f64::max })?;
        Some(match side {
            Some(side) => rounded(found, *digits, *side),
            None => round_digits(found, *digits),
        })
    }
}
