//! The ledger: one function per claim, every verdict computed.
//!
//! Letter X: statements of this project; all others are statements of the paper. One file per letter of the claims' ids; each has a list of checks, and a check says what must be found, what it
//! needs computed, and what its verdict does not establish.

mod alterations;
mod boundary;
mod by_hand;
mod certified;
mod criteria;
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
mod new_edge;
mod new_peak;
mod new_results;
mod numerical;
mod over_rows;
mod overshoot;
mod planted_fault_tables;
mod planted_faults;
mod reading;
mod resolved;
mod rule;
mod simulated;
mod simulated_courses;
mod simulated_damping;
mod simulated_friction;
mod simulated_laws;
mod simulated_least_peak;
mod simulated_onset;
mod simulated_transition;
mod simulated_trends;
mod theory_tables;
mod zones;

pub use by_hand::{ACCEPTED, Conclusion, LIBRARY, TIES, Tie, Tied, definitions, statement};
pub use error_bars::{DecidedFor, PointWithin};
pub use evidence::{Evidence, Strength};
pub use finding::Finding;
pub use formula::{WholeStatement, WholeTheorem, statement_digest, whole_statements, whole_theorems};
pub use ledger::{Entry, Ledger, find, known_ids, needs, premises};
pub use over_rows::row_faults;
pub use planted_faults::{PlantedFaults, Survivor, plant_faults};
pub use reading::{Part, Reading, verdict_of_parts};
pub use resolved::{Resolved, sha256_hex};

use crate::experiments::{Context, Need, TableMaker};
pub use crate::scene::Verdict;

/// Bits of the certified numbers in limits: more than the digits shown.
const BITS: u32 = 64;

/// How one claim is decided.
#[derive(Debug)]
pub struct Check {
    /// The claim's id, such as `B8`.
    pub id: &'static str,
    /// What has to be found for the claim to hold.
    pub criterion: &'static str,
    /// What a verdict does not establish.
    pub not_established: &'static str,
    /// The equations that it may use, by their numbers: it is given no others.
    pub equations: &'static [&'static str],
    /// What the check needs computed.
    pub needs: &'static [Need],
    /// Claims whose truth this one presupposes.
    pub rests_on: &'static [&'static str],
    /// Computes the verdict.
    pub decide: fn(&Context) -> Finding,
}

/// All checks, in the order of the letters F, L, S, B, Q, Z, N, X.
pub fn checks() -> impl Iterator<Item = &'static Check> {
    [
        friction_law::CHECKS,
        linearisation::CHECKS,
        boundary::CHECKS,
        frequency::CHECKS,
        frequency_turns::CHECKS,
        zones::CHECKS,
        numerical::CHECKS,
        new_results::CHECKS,
        simulated_friction::CHECKS,
    ]
    .into_iter()
    .flatten()
}

/// The tables about the equations and the claims.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    [planted_fault_tables::TABLES, theory_tables::TABLES].into_iter().flatten()
}
