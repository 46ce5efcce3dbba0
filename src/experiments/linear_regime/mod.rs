//! Small disturbances of the nonlinear slider compared with the roots of eq 8.

pub(crate) mod figures;
pub(crate) mod modes;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod snapshots;
pub(crate) mod steady_sliding;
pub(crate) mod tables;

pub use modes::Direction;
pub use run::{LinearRegimeOutcome, Mismatch, ModeRuns, linear_regime};
pub use section::LinearRegimeSection;
pub use steady_sliding::{SteadyRun, steady_sliding};

use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for LinearRegimeSection {
    type Outcome = LinearRegimeOutcome;
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        // Three starts for each; to 1e-8, whatever the amplitude.
        let starts = self.points.len() as f64 * self.laws.len() as f64 * self.amplitudes.len() as f64 * 3.0;
        Work::simulations(starts, 1e-8)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(linear_regime(setting.slider()?, self, &setting.threshold()))
    }
}
