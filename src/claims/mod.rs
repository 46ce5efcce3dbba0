//! The ledger: every verdict computed, by the formulas, proofs and procedures that `claims.toml` names.
//!
//! A procedure has a name, knows what it needs computed, and returns a finding. What a claim says, what has to be found and what a
//! verdict does not establish stand in `claims.toml`.

mod alterations;
mod boundary;
mod by_hand;
mod computed;
mod criteria;
mod criticality;
mod error_bars;
mod evidence;
mod exchange;
mod finding;
mod formula;
mod frequency;
mod frequency_turns;
mod friction_law;
mod gate;
mod ledger;
mod linearisation;
mod over_rows;
mod part;
mod planted_fault_tables;
mod planted_faults;
mod reading;
mod resolved;
mod rule;
mod theory_tables;

pub use by_hand::{ACCEPTED, Conclusion, LIBRARY, TIES, Tie, Tied, definitions, statement};
use computed::Asked;
pub use computed::{equation_faults, procedures};
pub use error_bars::{DecidedFor, PointWithin};
pub use evidence::{Evidence, Strength};
pub use finding::Finding;
pub use formula::{WholeStatement, WholeTheorem, statement_digest, whole_statements, whole_theorems};
pub use ledger::{Entry, Ledger, needs};
pub use over_rows::row_faults;
pub use part::{Part, Reading};
pub use planted_faults::{PlantedFaults, Survivor, plant_faults};
pub use reading::verdict_of_parts;
pub use resolved::{Resolved, sha256_hex};

use crate::experiments::{Context, Need, TableMaker};
pub use crate::scene::Verdict;
use slipmode_core::theory::Role;

/// Bits of the certified numbers in limits: more than the digits shown.
const BITS: u32 = 64;

/// A procedure that decides a part of a claim. `claims.toml` names it.
#[derive(Debug)]
pub(crate) struct Check {
    /// Its name.
    name: &'static str,
    /// Whether it is about runs, which are computed without the equations of the report.
    is_of_runs: bool,
    /// The equations that it starts from.
    roles: &'static [Role],
    /// What it needs computed.
    needs: &'static [Need],
    /// Computes the verdict.
    decide: fn(&Context, Asked) -> Finding,
}

/// A procedure that computes evidence beside what decides. `claims.toml` names it.
#[derive(Debug)]
pub(crate) struct Show {
    /// Its name.
    name: &'static str,
    /// What it needs computed.
    needs: &'static [Need],
    /// Computes the evidence.
    evidence: fn(&Context) -> Vec<Evidence>,
}

fn checks() -> impl Iterator<Item = &'static Check> {
    [
        friction_law::CHECKS,
        linearisation::CHECKS,
        boundary::CHECKS,
        frequency::CHECKS,
        frequency_turns::CHECKS,
        criteria::CHECKS,
        criticality::CHECKS,
    ]
    .into_iter()
    .flatten()
}

fn shows() -> impl Iterator<Item = &'static Show> {
    [boundary::SHOWS, exchange::SHOWS, frequency::SHOWS].into_iter().flatten()
}

/// The tables about the equations and the claims.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    [planted_fault_tables::TABLES, theory_tables::TABLES].into_iter().flatten()
}

#[cfg(test)]
mod tests;
