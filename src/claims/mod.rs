//! The ledger: every verdict computed, by the formulas, proofs and procedures that `claims.toml` names.
//!
//! A procedure has a name, knows what it needs computed, and returns a finding. What a claim says, what has to be found and what a
//! verdict does not establish stand in `claims.toml`.

mod alterations;
mod boundary;
mod by_hand;
mod check;
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
mod procedures;
mod reading;
mod resolved;
mod rule;
mod theory_tables;

pub use by_hand::{ACCEPTED, Conclusion, LIBRARY, TIES, Tie, Tied, definitions, statement};
pub(crate) use computed::equation_faults;
pub use error_bars::{DecidedFor, PointWithin};
pub use evidence::{Evidence, PROVED, Strength};
pub use finding::Finding;
pub use formula::{WholeStatement, WholeTheorem, statement_digest, whole_statements, whole_theorems};
pub use ledger::{Entry, Ledger, needs};
pub(crate) use over_rows::row_faults;
pub use part::{Part, Reading, verdict_words};
pub use planted_faults::{PlantedFaults, Survivor, plant_faults};
pub use procedures::procedures;
pub use resolved::{resolved_claim, resolved_formula, sha256_hex};

use crate::experiments::TableMaker;
pub use crate::scene::Verdict;

/// Bits of the certified numbers in limits: more than the digits shown.
const BITS: u32 = 64;

/// The tables about the equations and the claims.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    [planted_fault_tables::TABLES, theory_tables::TABLES].into_iter().flatten()
}

#[cfg(test)]
mod tests;
