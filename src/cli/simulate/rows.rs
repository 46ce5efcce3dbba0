//! `simulate --points`: every row simulated, its observables and errors appended; a failure stands in the row's status.

use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, names, push_cells};
use slipmode::scene::{Faults, Problem};
use slipmode_core::dynamics::Simulation;
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;

use crate::cli::simulate::range;
use crate::cli::simulate::run::{Found, Settings, simulate_point};
use crate::cli::words::{LAW_COLUMN, LAWS, law_of_word};

/// Simulates rows.
#[derive(Debug)]
pub struct SimulateRows {
    /// The law of all rows; none when a column chooses it.
    pub law: Option<EvolutionLaw>,
    /// What is the same for every row.
    pub settings: Settings,
}

/// The appended columns, which are also the keys of the object of one point; without a result all but the last are empty.
pub const COLUMNS: [Column<Found>; 12] = [
    ("mode", |found| word(found, |found| found.behaviour.as_str())),
    ("slip_mode", |found| word(found, |found| found.slip_mode.as_str())),
    ("peak_velocity_m_per_s", |found| number(found, |found| Some(found.peak_velocity_m_per_s))),
    ("minimum_velocity_log10_ratio", |found| number(found, |found| Some(found.minimum_velocity_log10_ratio))),
    ("period_s", |found| number(found, |found| found.period_s)),
    ("stress_drop_pa", |found| number(found, |found| Some(found.stress_drop_pa))),
    ("frequency_hz", |found| number(found, |found| found.frequency_hz)),
    ("peak_relative_error", |found| number(found, |found| Some(found.peak_relative_error))),
    ("period_relative_error", |found| number(found, |found| found.period_relative_error)),
    ("steps", |found| count(found, |found| found.steps)),
    ("evaluations", |found| count(found, |found| found.evaluations)),
    ("status", |found| Datum::Text(found.as_ref().err().map_or(ANSWERED, String::as_str).into())),
];

/// The status of a simulation that has an answer.
const ANSWERED: &str = "ok";

fn word(found: &Found, of: fn(&Simulation) -> &'static str) -> Datum {
    found.as_ref().map_or(Datum::Number(None), |found| Datum::Text(of(found).into()))
}

fn number(found: &Found, of: fn(&Simulation) -> Option<f64>) -> Datum {
    Datum::Number(found.as_ref().ok().and_then(of))
}

fn count(found: &Found, of: fn(&Simulation) -> u64) -> Datum {
    found.as_ref().map_or(Datum::Number(None), |found| Datum::Count(of(found)))
}

impl RowWork for SimulateRows {
    type Input = (Parameters<Rational>, EvolutionLaw);
    type Kept = ();

    const APPENDED: &'static [&'static str] = &names(&COLUMNS);
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
        let found = simulate_point(parameters, *law, self.settings);
        push_cells(&COLUMNS, &found, out);
        Remark { is_unanswered: found.is_err(), warning, kept: () }
    }
}
