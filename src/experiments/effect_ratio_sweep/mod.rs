//! The worst errors of the asymptotes against b/a.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{SweepOutcome, SweepRow, sweep_effect_ratio};
pub use section::EffectRatioSweepSection;

use crate::experiments::work::certified_point_s;
use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for EffectRatioSweepSection {
    type Outcome = SweepOutcome;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        let ratios = f64::from(self.effect_ratio.points) + 2.0 * self.near_equal.len() as f64;
        Work::points(ratios, 10.0 * certified_point_s(0.0))
    }

    fn run(&self, _: &Setting<'_>) -> Option<Self::Outcome> {
        Some(sweep_effect_ratio(self))
    }
}
