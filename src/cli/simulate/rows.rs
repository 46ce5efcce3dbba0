//! `simulate --points`: every row simulated, its observables and errors appended; a failure stands in the row's status.

use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, is_named, names, push_cells};
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

impl SimulateRows {
    /// What was read of a row, with its law; or all faults of both.
    pub fn with_law<T>(
        &self,
        cells: Cells<'_>,
        read: Result<T, Faults>,
    ) -> Result<(T, EvolutionLaw), Faults> {
        let law = match (self.law, cells.header.position(LAW_COLUMN)) {
            (None, Some(position)) => law_of_word(cells.text(position))
                .map_err(|problem| vec![cells.fault(Some(position), problem)]),
            (law, _) => law.ok_or_else(|| vec![cells.fault(None, Problem::Missing { allowed: LAWS.into() })]),
        };
        match (read, law) {
            (Ok(read), Ok(law)) => Ok((read, law)),
            (read, law) => Err([read.err(), law.err()].into_iter().flatten().flatten().collect()),
        }
    }
}

/// What is reported of a point.
#[derive(Debug)]
pub struct Answer {
    /// The simulation, or why there is none.
    pub found: Found,
    /// Whether a group lies outside the ranges over which simulations were tested.
    pub outside_tested_range: bool,
}

impl Answer {
    /// What is reported of a simulation with these parameters.
    pub fn new(found: Found, parameters: &Parameters<Rational>) -> Self {
        Self { found, outside_tested_range: !range::outside_tested(parameters).is_empty() }
    }
}

/// The appended columns, which are also the keys of the object of one point; without a result all but the last two are empty.
pub const COLUMNS: [Column<Answer>; 13] = [
    ("mode", |answer| word(answer, |found| found.behaviour.as_str())),
    ("slip_mode", |answer| word(answer, |found| found.slip_mode.as_str())),
    ("peak_velocity_m_per_s", |answer| number(answer, |found| Some(found.peak_velocity_m_per_s))),
    ("minimum_velocity_log10_ratio", |answer| {
        number(answer, |found| Some(found.minimum_velocity_log10_ratio))
    }),
    ("period_s", |answer| number(answer, |found| found.period_s)),
    ("stress_drop_pa", |answer| number(answer, |found| Some(found.stress_drop_pa))),
    ("frequency_hz", |answer| number(answer, |found| found.frequency_hz)),
    ("peak_relative_error", |answer| number(answer, |found| Some(found.peak_relative_error))),
    ("period_relative_error", |answer| number(answer, |found| found.period_relative_error)),
    ("steps", |answer| count(answer, |found| found.steps)),
    ("evaluations", |answer| count(answer, |found| found.evaluations)),
    ("outside_tested_range", |answer| Datum::Flag(answer.outside_tested_range)),
    ("status", |answer| Datum::Text(answer.found.as_ref().err().map_or(ANSWERED, String::as_str).into())),
];

/// The status of a simulation that has an answer.
const ANSWERED: &str = "ok";

fn word(answer: &Answer, of: fn(&Simulation) -> &'static str) -> Datum {
    answer.found.as_ref().map_or(Datum::Number(None), |found| Datum::Text(of(found).into()))
}

fn number(answer: &Answer, of: fn(&Simulation) -> Option<f64>) -> Datum {
    Datum::Number(answer.found.as_ref().ok().and_then(of))
}

fn count(answer: &Answer, of: fn(&Simulation) -> u64) -> Datum {
    answer.found.as_ref().map_or(Datum::Number(None), |found| Datum::Count(of(found)))
}

impl RowWork for SimulateRows {
    type Input = (Parameters<Rational>, EvolutionLaw);
    type Kept = ();

    const APPENDED: &'static [&'static str] = &names(&COLUMNS);
    /// A row takes milliseconds, and some a hundred times longer than others.
    const BLOCK_ROWS: usize = 1;
    const BLOCKS_PER_THREAD: usize = 64;

    fn header_faults(&self, names: &[String]) -> Vec<(String, Problem)> {
        let has_column = names.iter().any(|name| is_named(name, LAW_COLUMN));
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
        self.with_law(cells, cells.parameters())
    }

    fn append(&self, (parameters, law): &Self::Input, out: &mut Vec<u8>) -> Remark {
        let warning = range::row_warning(parameters);
        let answer = Answer::new(simulate_point(parameters, *law, self.settings), parameters);
        push_cells(&COLUMNS, &answer, out);
        Remark { is_unanswered: answer.found.is_err(), warning, kept: () }
    }
}
