//! The nonlinear slider on a (V, σ) grid (figs 3a, 5 and 6).

mod deep_stick_slip;
pub(crate) mod least_peak;
pub(crate) mod least_peak_figures;
pub(crate) mod map_figures;
pub(crate) mod run;
mod run_tables;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod vibration_limit;
mod words;

pub use least_peak::{FLATNESS_LEVELS, LeastPeak, PERIOD_LEVELS, SIDE_WIDTH, least_peaks};
pub use run::{RunCourse, SimulatedPoint, SimulationsOutcome, simulations};
pub use section::SimulationsSection;
pub use vibration_limit::{STEP as VIBRATION_STEP, StrongVibration, strong_vibrations};
pub use words::range_of_velocities;

use crate::experiments::work::rectangle_points;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

/// Local tolerance of the pass along a cycle.
const CYCLE_TOLERANCE: f64 = 1e-9;

impl Experiment for SimulationsSection {
    type Outcome = SimulationsOutcome;
    const TABLES: &'static [&'static [TableMaker]] =
        &[tables::TABLES, deep_stick_slip::TABLES, run_tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[least_peak_figures::FIGURES, map_figures::FIGURES];

    fn work(&self) -> Work {
        let runs = rectangle_points(&self.rectangle) * self.laws.len() as f64;
        Work::simulations(runs, nearest_f64(&self.tolerance))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(simulations(setting.slider()?, self, &setting.threshold()))
    }
}
