//! Estimated errors of simulations compared with true errors.

pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{BoundCheck, error_bound};
pub use section::ErrorBoundSection;

use crate::experiments::{Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for ErrorBoundSection {
    type Outcome = Vec<BoundCheck>;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        Work::simulations_at_each(f64::from(self.groups) * 2.0, &self.tolerances)
    }

    fn run(&self, _: &Setting<'_>) -> Option<Self::Outcome> {
        Some(error_bound(self))
    }
}
