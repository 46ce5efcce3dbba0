//! Points where programs go wrong, with references from independent programs.

pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{Expected, FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
pub use section::HardCasesSection;

use crate::experiments::{Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for HardCasesSection {
    type Outcome = Vec<FamilyOutcome>;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        Work::on_a_file()
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        setting.references.hard_cases.get(&self.file).map(|cases| compare_hard_cases(cases))
    }
}
