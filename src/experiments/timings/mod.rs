//! Times that other commands measured: read from the report's files, compared and fitted here, never measured.
//!
//! What is missing in the files is missing in the answers, by name.

mod aims;
mod compare;
mod coverage;
pub(crate) mod coverage_table;
mod law;
mod lookup;
mod rows;
pub(crate) mod section;
mod sheet;
pub(crate) mod tables;

pub use aims::{Aim, Bound, aims};
pub use compare::{PeerGroup, Reached, cycle_groups, micro, work_groups};
pub use coverage::{CoverageRow, read_coverage};
pub use law::{CostSeries, Form, Law, cost_series};
pub use rows::{CostRow, MachineRow, PeerRow, read_cost, read_machine, read_peers};

/// The contents of the files.
#[derive(Debug, Clone, PartialEq)]
pub struct Timings {
    /// The name of the file of peers, by which rows are traced.
    pub peers_file: String,
    /// Times of slipmode and its peers.
    pub peers: Vec<PeerRow>,
    /// The name of the file of costs.
    pub cost_file: String,
    /// How time and memory grow.
    pub cost: Vec<CostRow>,
    /// On which machine, on which day, with which versions.
    pub machine: Vec<MachineRow>,
    /// The name of the file of coverage, where there is one, and which lines of the program the tests ran.
    pub coverage: Option<(String, Vec<CoverageRow>)>,
}
pub use section::TimingsSection;

use crate::experiments::{Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for TimingsSection {
    type Outcome = Timings;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES, coverage_table::TABLES];

    fn work(&self) -> Work {
        Work::on_a_file()
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        setting.references.timings.get(self).cloned()
    }
}
