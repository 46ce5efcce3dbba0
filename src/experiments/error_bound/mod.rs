//! Estimated errors of simulations compared with true errors.

pub(crate) mod run;
pub(crate) mod section;

pub use run::{BoundCheck, error_bound};
pub use section::ErrorBoundSection;

use crate::experiments::{Experiment, Requirement, Setting};

impl Experiment for ErrorBoundSection {
    type Outcome = Vec<BoundCheck>;
    const REQUIREMENT: Requirement = Requirement::Nothing;

    fn run(&self, _: &Setting<'_>) -> Option<Self::Outcome> {
        Some(error_bound(self))
    }
}
