//! Numbers of a table for sentences: the least or largest value, and counts.

use slipmode_algebra::Expression;
use slipmode_core::number::format::{Side, round_digits, rounded};

use super::truth::Rows;
use crate::scene::Formula;

/// A number and how it is written.
#[derive(Debug, Clone)]
pub(super) struct Number {
    pub what: What,
    /// The rows that it is about.
    pub selected: Formula,
}

/// What is computed.
#[derive(Debug, Clone)]
pub(super) enum What {
    /// How many rows there are.
    Count,
    /// The least (or largest) value, with this many digits, rounded to this side or else to nearest.
    Extreme { least: bool, of: Expression, digits: usize, side: Option<Side> },
}

impl Number {
    /// The expressions whose value is needed.
    pub fn side(&self) -> Option<&Expression> {
        match &self.what {
            What::Count => None,
            What::Extreme { of, .. } => Some(of),
        }
    }

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
