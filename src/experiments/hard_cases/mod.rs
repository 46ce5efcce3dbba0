//! Points and cycles where programs go wrong, with references from independent programs.

pub(crate) mod return_tables;
pub(crate) mod returns;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use returns::{
    HardReturn, ReturnAnswer, ReturnOutcome, ReturnVerdict, read_hard_returns, run_hard_returns,
};
pub use run::{Expected, FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
pub use section::HardCasesSection;

use crate::experiments::{Experiment, Requirement, Setting, TableMaker, Work};

/// How points and returns compare with their references.
#[derive(Debug, Clone)]
pub struct HardCasesOutcome {
    /// The points, family by family.
    pub families: Vec<FamilyOutcome>,
    /// The returns; empty when the section names no file of returns.
    pub returns: Vec<ReturnOutcome>,
}

impl Experiment for HardCasesSection {
    type Outcome = HardCasesOutcome;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES, return_tables::TABLES];

    fn work(&self) -> Work {
        Work::on_a_file()
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        let cases = setting.references.hard_cases.get(&self.file)?;
        let returns = self.returns.as_ref().and_then(|file| setting.references.hard_returns.get(file));
        Some(HardCasesOutcome {
            families: compare_hard_cases(cases),
            returns: returns.map(|returns| run_hard_returns(returns)).unwrap_or_default(),
        })
    }
}
