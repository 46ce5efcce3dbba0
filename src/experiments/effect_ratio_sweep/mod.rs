//! The worst errors of the asymptotes against b/a.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{SweepOutcome, SweepRow, sweep_effect_ratio};
pub use section::EffectRatioSweepSection;

use crate::experiments::{Experiment, FigureMaker, Requirement, Setting, TableMaker};

impl Experiment for EffectRatioSweepSection {
    type Outcome = SweepOutcome;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, _: &Setting<'_>) -> Option<Self::Outcome> {
        Some(sweep_effect_ratio(self))
    }
}
