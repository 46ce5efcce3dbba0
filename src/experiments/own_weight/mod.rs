//! A slider that its own weight presses on: slip modes over loading velocity and K/M.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;

pub use run::{OwnWeightOutcome, own_weight};
pub use section::OwnWeightSection;

use crate::experiments::work::DECISION_S;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for OwnWeightSection {
    type Outcome = OwnWeightOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::points(self.points() as f64, DECISION_S)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(own_weight(setting.slider()?, self, &setting.threshold()))
    }
}
