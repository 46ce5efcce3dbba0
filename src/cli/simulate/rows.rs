//! `simulate --points`: every row simulated, its observables and errors appended; a failure stands in the row's status.

use slipmode::csv::{Cells, Remark, RowWork, is_named, joined, names, push_cells};
use slipmode::scene::{Faults, Problem};
use slipmode_core::dynamics::Options;
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;

use crate::cli::simulate::certified::{self, Certified};
use crate::cli::simulate::over_box::{self, BoxRuns, is_point};
use crate::cli::simulate::range;
use crate::cli::simulate::run::{COLUMNS, Simulated, simulate_point};
use crate::cli::words::{LAW_COLUMN, LAWS, law_of_word};

/// Simulates rows, over their error bars; with `CERTIFY`, the middle of the error bars, and certifies all values within them.
#[derive(Debug)]
pub struct SimulateRows<const CERTIFY: bool> {
    /// The law of all rows; none when a column chooses it.
    pub law: Option<EvolutionLaw>,
    /// What is the same for every row.
    pub options: Options,
    /// Runs at points spread within the error bars of a row.
    pub box_runs: u64,
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
        let found = simulate_point(middle, *law, self.options);
        let mut is_unanswered = found.is_err();
        match region {
            Some(region) if !CERTIFY => {
                let runs = BoxRuns::new(found, region, *law, self.options, self.box_runs);
                push_cells(&over_box::COLUMNS, &runs, out);
                is_unanswered = runs.is_unanswered();
            }
            _ => push_cells(&COLUMNS, &Simulated::new(found, middle), out),
        }
        if let Some(region) = region.as_ref().filter(|_| CERTIFY) {
            push_cells(&certified::COLUMNS, &Certified::new(region, *law, self.options.start), out);
        }
        Remark { is_unanswered, ..Remark::warning(&range::warnings(middle)) }
    }
}
