//! Every completion of the start V = V_l/10 at a few points.

pub(crate) mod run;
pub(crate) mod tables;

pub use run::{Early, StartGroup, StartRun};

use crate::experiments::linear_regime::product;
use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, PlanePoint};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

experiment! {
    /// `[start_sensitivity]`: every completion of the start V_l/10 at a few points (V, σ).
    pub struct StartSensitivitySection {
        /// V (m/s) and σ (Pa) of each point.
        pub points: Vec<PlanePoint> = Section::places,
        /// The evolution laws, each once.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
        /// Permitted relative error of peak velocity and period.
        pub tolerance: Rational = |section, key| section.decimal(key, AllowedRange::SIMULATION_TOLERANCE),
    }
    points: |section| product(&[section.points.len(), section.laws.len(), 4]),
    outcome: Vec<StartGroup>,
    tables: [tables::TABLES],
    work: |section| {
        let runs = section.points.len() as f64 * section.laws.len() as f64 * 4.0;
        Work::simulations(runs, nearest_f64(&section.tolerance))
    },
    run: |section, earlier, _| Some(run::start_sensitivity(earlier.slider()?, section, &earlier.scene.threshold())),
}
