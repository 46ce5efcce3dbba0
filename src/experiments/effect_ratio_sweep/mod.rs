//! The worst errors of the asymptotes against b/a.

pub(crate) mod run;
pub(crate) mod section;

pub use run::{SweepOutcome, SweepRow, sweep_effect_ratio};
pub use section::EffectRatioSweepSection;

use crate::experiments::{Experiment, Requirement, Setting};

impl Experiment for EffectRatioSweepSection {
    type Outcome = SweepOutcome;
    const REQUIREMENT: Requirement = Requirement::Nothing;

    fn run(&self, _: &Setting<'_>) -> Option<Self::Outcome> {
        Some(sweep_effect_ratio(self))
    }
}
