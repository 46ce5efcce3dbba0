//! The nonlinear slider on a (V, σ) grid (figs 3a, 5 and 6).

mod deep_stick_slip;
pub(crate) mod least_peak;
pub(crate) mod least_peak_figures;
pub(crate) mod map_figures;
pub(crate) mod run;
mod run_tables;
pub(crate) mod tables;
pub(crate) mod vibration_limit;
mod words;

pub use least_peak::{FLATNESS_LEVELS, LeastPeak, PERIOD_LEVELS, SIDE_WIDTH};
pub use run::{RunCourse, SimulatedPoint, SimulationsOutcome};
pub use vibration_limit::{STEP as VIBRATION_STEP, StrongVibration};
pub(crate) use words::range_of_velocities;

use crate::experiments::work::rectangle_points;
use crate::experiments::{Work, experiment};
use crate::scene::{AllowedRange, Rectangle};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

/// Local tolerance of the pass along a cycle.
const CYCLE_TOLERANCE: f64 = 1e-9;

experiment! {
    /// `[simulations]`: the nonlinear slider on a (V, σ) grid.
    pub struct SimulationsSection {
        /// The points to simulate.
        pub rectangle: Rectangle = |section, _| section.rectangle(),
        /// The evolution laws, each once.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
        /// Permitted relative error of peak velocity and period.
        pub tolerance: Rational = |section, key| section.decimal(key, AllowedRange::SIMULATION_TOLERANCE),
    }
    points: |section| section.rectangle.points().saturating_mul(section.laws.len() as u64),
    outcome: SimulationsOutcome,
    tables: [tables::TABLES, deep_stick_slip::TABLES, run_tables::TABLES],
    figures: [least_peak_figures::FIGURES, map_figures::FIGURES],
    work: |section| {
        let runs = rectangle_points(&section.rectangle) * section.laws.len() as f64;
        Work::simulations(runs, nearest_f64(&section.tolerance))
    },
    run: |section, earlier, _| Some(run::simulations(earlier.slider()?, section, &earlier.scene.threshold())),
}
