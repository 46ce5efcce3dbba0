//! Small disturbances of the nonlinear slider compared with the roots of eq 8.

pub(crate) mod figures;
pub(crate) mod modes;
pub(crate) mod run;
pub(crate) mod snapshots;
pub(crate) mod steady_sliding;
pub(crate) mod tables;

pub use modes::Direction;
pub use run::{LinearRegimeOutcome, Mismatch, ModeRuns};
pub use steady_sliding::SteadyRun;

use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, PlanePoint};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// Starts of a linear regime at one point: one for each real root, two for a pair.
const STARTS_PER_POINT: u64 = 3;

experiment! {
    /// `[linear_regime]`: small disturbances along the eigenvectors, against the roots, at a few points (V, σ).
    pub struct LinearRegimeSection {
        /// The points.
        pub points: Vec<PlanePoint> = Section::places,
        /// The evolution laws, each once.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
        /// Sizes of the start, each once.
        pub amplitudes: Vec<Rational> = |section, key| {
            let range = AllowedRange::AMPLITUDE;
            section.read(key, &format!("a list of sizes, each {}", range.text()), |entry| {
                entry.distinct(|_| "an earlier member".into(), |size| size.decimal(range))
            })
        },
    }
    points: |section| {
        let lists = [section.points.len(), section.laws.len(), section.amplitudes.len()];
        product(&lists).saturating_mul(STARTS_PER_POINT)
    },
    outcome: LinearRegimeOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    // Three starts for each; to 1e-8, whatever the amplitude.
    work: |section| {
        let starts = section.points.len() as f64 * section.laws.len() as f64 * section.amplitudes.len() as f64 * 3.0;
        Work::simulations(starts, 1e-8)
    },
    run: |section, earlier, _| Some(run::linear_regime(earlier.slider()?, section, &earlier.scene.threshold())),
}

/// The number of combinations of members of several lists.
pub(crate) fn product(lengths: &[usize]) -> u64 {
    lengths.iter().fold(1, |product, &length| product.saturating_mul(length as u64))
}
