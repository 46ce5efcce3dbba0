//! The nonlinear slider over time at named points (figs 3b to 3g and 6b to 6d).

pub(crate) mod curves;
pub(crate) mod figures;
pub(crate) mod own_runs;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod thinning;

pub use own_runs::own_run_words;
pub use run::{Course, DRAWING_TOLERANCE, Moment, TrajectoryRun, trajectories};
pub use section::{TrajectoriesSection, TrajectoryPoint};

use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

impl Experiment for TrajectoriesSection {
    type Outcome = Vec<TrajectoryRun>;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES, own_runs::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        let runs = self.points.iter().map(|point| point.laws.len()).sum::<usize>();
        Work::simulations(runs as f64, nearest_f64(&self.tolerance))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(trajectories(setting.slider()?, self, &setting.threshold()))
    }
}
