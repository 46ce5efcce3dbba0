//! Every completion of the start V = V_l/10 at a few points.

pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{Early, StartGroup, StartRun, start_sensitivity};
pub use section::StartSensitivitySection;

use crate::experiments::{Experiment, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

impl Experiment for StartSensitivitySection {
    type Outcome = Vec<StartGroup>;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        let runs = self.points.len() as f64 * self.laws.len() as f64 * 4.0;
        Work::simulations(runs, nearest_f64(&self.tolerance))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(start_sensitivity(setting.slider()?, self, &setting.threshold()))
    }
}
