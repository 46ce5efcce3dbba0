//! `simulate --points`: every row simulated, its observables and errors appended; a failure stands in the row's status.

use slipmode::csv::{Cells, Remark, RowWork, push_cell};
use slipmode::scene::{Faults, Problem};
use slipmode_core::dynamics::Simulation;
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;
use slipmode_core::number::format::shortest;

use crate::cli::simulate::range;
use crate::cli::simulate::run::{Settings, simulate_point};
use crate::cli::simulate::view::ANSWERED;
use crate::cli::words::{LAW_COLUMN, LAWS, law_of_word};

/// Simulates rows.
#[derive(Debug)]
pub struct SimulateRows {
    /// The law of all rows; none when a column chooses it.
    pub law: Option<EvolutionLaw>,
    /// What is the same for every row.
    pub settings: Settings,
}

impl RowWork for SimulateRows {
    type Input = (Parameters<Rational>, EvolutionLaw);
    type Kept = ();

    const APPENDED: &'static [&'static str] = &[
        "mode",
        "slip_mode",
        "peak_velocity_m_per_s",
        "minimum_velocity_log10_ratio",
        "period_s",
        "stress_drop_pa",
        "frequency_hz",
        "peak_relative_error",
        "period_relative_error",
        "steps",
        "evaluations",
        "status",
    ];
    /// A row takes milliseconds, and some a hundred times longer than others.
    const BLOCK_ROWS: usize = 1;
    const BLOCKS_PER_THREAD: usize = 64;

    fn header_faults(&self, names: &[String]) -> Vec<(String, Problem)> {
        let has_column = names.iter().any(|name| name == LAW_COLUMN);
        let problem = match (has_column, self.law) {
            (false, None) => {
                Problem::Missing { allowed: format!("a column of {LAWS}, or the option --law for all rows") }
            }
            (true, Some(_)) => Problem::Needs("no --law together with it: the column chooses the law".into()),
            _ => return Vec::new(),
        };
        vec![(LAW_COLUMN.into(), problem)]
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        let law = match (self.law, cells.header.position(LAW_COLUMN)) {
            (None, Some(position)) => law_of_word(cells.text(position))
                .map_err(|problem| vec![cells.fault(Some(position), problem)]),
            (law, _) => law.ok_or_else(|| vec![cells.fault(None, Problem::Missing { allowed: LAWS.into() })]),
        };
        match (cells.parameters(), law) {
            (Ok(parameters), Ok(law)) => Ok((parameters, law)),
            (parameters, law) => Err([parameters.err(), law.err()].into_iter().flatten().flatten().collect()),
        }
    }

    fn append(&self, (parameters, law): &Self::Input, out: &mut Vec<u8>) -> Remark {
        let warning = range::row_warning(parameters);
        match simulate_point(parameters, *law, self.settings) {
            Ok(found) => {
                push_found(&found, out);
                Remark { is_unanswered: false, warning, kept: () }
            }
            Err(reason) => {
                out.extend_from_slice(",".repeat(Self::APPENDED.len()).as_bytes());
                push_cell(out, reason.as_bytes());
                Remark { is_unanswered: true, warning, kept: () }
            }
        }
    }
}

fn push_found(found: &Simulation, out: &mut Vec<u8>) {
    let optional = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let cells = [
        found.behaviour.as_str().into(),
        found.slip_mode.as_str().into(),
        shortest(found.peak_velocity_m_per_s),
        shortest(found.minimum_velocity_log10_ratio),
        optional(found.period_s),
        shortest(found.stress_drop_pa),
        optional(found.frequency_hz),
        shortest(found.peak_relative_error),
        optional(found.period_relative_error),
        found.steps.to_string(),
        found.evaluations.to_string(),
        ANSWERED.into(),
    ];
    for cell in cells {
        out.push(b',');
        out.extend_from_slice(cell.as_bytes());
    }
}
