//! Times that the other commands measured, read from their files: compared, fitted and tabulated, never measured here.
//!
//! What is missing in the files is missing in the answers, by name.

mod aims;
mod compare;
mod cost_series;
mod coverage;
mod coverage_table;
mod figures;
mod lookup;
mod rows;
mod sheet;
mod tables;

pub use aims::{Aim, Bound, aims};
pub(crate) use compare::{ERRORS, KINDS};
pub use compare::{PeerGroup, Reached, cycle_groups, micro, work_groups};
pub use cost_series::{CostSeries, cost_series};
pub use coverage::{CoverageRow, read_coverage};
pub use figures::figures;
pub use lookup::DerivedNumber;
pub use rows::{CostRow, MachineRow, PeerRow, read_cost, read_machine, read_peers};
pub use tables::tables;

use slipmode::scene::Faults;

/// Times of slipmode and its peers.
pub const PEERS_FILE: &str = "peers.csv";
/// How time and memory grow.
pub const COST_FILE: &str = "cost.csv";
/// Which lines of the program the tests ran.
pub const COVERAGE_FILE: &str = "coverage.csv";
/// On which machine, on which day, with which versions.
pub const MACHINE_FILE: &str = "machine.csv";

/// The files that other commands write.
pub const FILES: [&str; 4] = [PEERS_FILE, COST_FILE, COVERAGE_FILE, MACHINE_FILE];

/// The contents of the files.
#[derive(Debug, Clone, PartialEq)]
pub struct Timings {
    /// Times of slipmode and its peers.
    pub peers: Vec<PeerRow>,
    /// How time and memory grow.
    pub cost: Vec<CostRow>,
    /// Which lines of the program the tests ran.
    pub coverage: Vec<CoverageRow>,
    /// On which machine, on which day, with which versions.
    pub machine: Vec<MachineRow>,
}

impl Timings {
    /// Reads the texts of [`FILES`], in their order.
    ///
    /// # Errors
    /// The faults of the first file that has any.
    pub fn read([peers, cost, coverage, machine]: [&str; 4]) -> Result<Self, Faults> {
        Ok(Self {
            peers: read_peers(PEERS_FILE, peers)?,
            cost: read_cost(COST_FILE, cost)?,
            coverage: read_coverage(COVERAGE_FILE, coverage)?,
            machine: read_machine(MACHINE_FILE, machine)?,
        })
    }
}
