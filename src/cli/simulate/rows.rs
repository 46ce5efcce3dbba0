//! `simulate --points`: every row simulated, its observables and errors appended; a failure stands in the row's status.

use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, is_named, joined, names, push_cells};
use slipmode::scene::{Faults, Problem};
use slipmode_core::dynamics::Simulation;
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;

use crate::cli::simulate::certified::{self, Certified};
use crate::cli::simulate::over_box::{self, BoxRuns, is_point};
use crate::cli::simulate::range;
use crate::cli::simulate::run::{Settings, Shown, simulate_point};
use crate::cli::words::{LAW_COLUMN, LAWS, law_of_word};

/// Simulates rows, over their error bars; with `CERTIFY`, the middle of the error bars, and certifies all values within them.
#[derive(Debug)]
pub struct SimulateRows<const CERTIFY: bool> {
    /// The law of all rows; none when a column chooses it.
    pub law: Option<EvolutionLaw>,
    /// What is the same for every row.
    pub settings: Settings,
    /// Runs at points spread within the error bars of a row.
    pub box_runs: u64,
}

/// A point that was simulated.
#[derive(Debug)]
pub struct Simulated {
    /// The simulation, or why there is none.
    pub found: Shown,
    /// Whether a group lies outside the ranges over which simulations were tested.
    pub outside_tested_range: bool,
}

impl Simulated {
    /// What is reported of a simulation with these parameters.
    pub fn new(found: Shown, parameters: &Parameters<Rational>) -> Self {
        Self { found, outside_tested_range: !range::outside_tested(parameters).is_empty() }
    }
}

/// The appended columns, which are also the keys of the object of one point; without a result all but the last two are empty.
pub const COLUMNS: [Column<Simulated>; 13] = [
    ("mode", |it| found(it, |run| Datum::Text(run.behaviour.as_str().into()))),
    ("slip_mode", |it| found(it, |run| Datum::Text(run.slip_mode.as_str().into()))),
    ("peak_velocity_m_per_s", |it| found(it, |run| Datum::Number(Some(run.peak_velocity_m_per_s)))),
    ("minimum_velocity_log10_ratio", |it| {
        found(it, |run| Datum::Number(Some(run.minimum_velocity_log10_ratio)))
    }),
    ("period_s", |it| found(it, |run| Datum::Number(run.period_s))),
    ("stress_drop_pa", |it| found(it, |run| Datum::Number(Some(run.stress_drop_pa)))),
    ("frequency_hz", |it| found(it, |run| Datum::Number(run.frequency_hz))),
    ("peak_relative_error", |it| found(it, |run| Datum::Number(Some(run.peak_relative_error)))),
    ("period_relative_error", |it| found(it, |run| Datum::Number(run.period_relative_error))),
    ("steps", |it| found(it, |run| Datum::Count(run.steps))),
    ("evaluations", |it| found(it, |run| Datum::Count(run.evaluations))),
    ("outside_tested_range", |answer| Datum::Flag(answer.outside_tested_range)),
    ("status", |answer| Datum::Text(answer.found.as_ref().err().map_or(ANSWERED, String::as_str).into())),
];

/// The status of a simulation that has an answer.
const ANSWERED: &str = "ok";

fn found(simulated: &Simulated, datum: fn(&Simulation) -> Datum) -> Datum {
    simulated.found.as_ref().map_or(Datum::Number(None), datum)
}

impl<const CERTIFY: bool> RowWork for SimulateRows<CERTIFY> {
    /// The middle values; all values, where they are to be certified or have error bars; and the law.
    type Input = (Parameters<Rational>, Option<ParameterBox>, EvolutionLaw);
    type Kept = ();

    const APPENDED: &'static [&'static str] = if CERTIFY {
        &joined::<{ COLUMNS.len() + certified::COLUMNS.len() }>(&names(&COLUMNS), &names(&certified::COLUMNS))
    } else {
        &names(&COLUMNS)
    };
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

    fn reads(&self, name: &str) -> bool {
        is_named(name, LAW_COLUMN)
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        let read = cells.region();
        let law = match (self.law, cells.header.position(LAW_COLUMN)) {
            (None, Some(position)) => law_of_word(cells.text(position))
                .map_err(|problem| vec![cells.fault(Some(position), problem)]),
            (law, _) => law.ok_or_else(|| vec![cells.fault(None, Problem::Missing { allowed: LAWS.into() })]),
        };
        match (read, law) {
            (Ok(region), Ok(law)) => {
                let middle = region.middle();
                Ok((middle, Some(region).filter(|region| CERTIFY || !is_point(region)), law))
            }
            (read, law) => Err([read.err(), law.err()].into_iter().flatten().flatten().collect()),
        }
    }

    fn append(&self, (middle, region, law): &Self::Input, out: &mut Vec<u8>) -> Remark {
        let found = simulate_point(middle, *law, self.settings);
        let mut is_unanswered = found.is_err();
        match region {
            Some(region) if !CERTIFY => {
                let runs = BoxRuns::new(found, region, *law, self.settings, self.box_runs);
                push_cells(&over_box::COLUMNS, &runs, out);
                is_unanswered = runs.is_unanswered();
            }
            _ => push_cells(&COLUMNS, &Simulated::new(found, middle), out),
        }
        if let Some(region) = region.as_ref().filter(|_| CERTIFY) {
            push_cells(&certified::COLUMNS, &Certified::new(region, *law, self.settings.start), out);
        }
        Remark { is_unanswered, ..Remark::warning(&range::warnings(middle)) }
    }
}
