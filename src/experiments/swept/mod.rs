//! Sweeps that ran elsewhere, and what running them took.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{Swept, read_swept};
pub use section::{SweptEntry, SweptSection};

use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for SweptSection {
    type Outcome = Vec<Swept>;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::on_a_file()
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        let of = |entry: &SweptEntry| setting.references.swept.get(&entry.name).cloned();
        Some(self.sweeps.iter().filter_map(of).collect())
    }
}
