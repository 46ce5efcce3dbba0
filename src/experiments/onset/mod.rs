//! Where oscillation begins along lines of constant normal stress (figs 4 and 6).

pub(crate) mod figures;
pub(crate) mod first_swing;
pub(crate) mod run;
pub(crate) mod search;
pub(crate) mod tables;
pub(crate) mod theory;

pub use first_swing::Swing;
pub use run::{Onset, OnsetOutcome, OtherUnit, ShownRun, StressOnset};
pub use search::{Located, SeenOnset};

use crate::experiments::work::SEARCH_RUNS;
use crate::experiments::{Work, experiment};
use crate::scene::AllowedRange;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

/// Runs that one search needs at most: the count that is compared with the limit of points.
const RUNS_OF_A_SEARCH: u64 = 200;

experiment! {
    /// `[onset]`: where oscillation begins along lines of constant normal stress, and runs on either side of it (fig 4).
    pub struct OnsetSection {
        /// Normal stresses, Pa.
        pub normal_stress_pa: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of normal stresses in Pa", AllowedRange::PHYSICAL)
        },
        /// Velocities of the runs to show, in units of the asymptote's velocity (eq 20, or eq 18 on the upper arc).
        pub velocity_over_asymptote: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of ratios > 0", AllowedRange::PHYSICAL)
        },
        /// Loading velocities of the lines across eq 16, m/s; may be absent.
        pub loading_velocity_m_per_s: Vec<Rational> = |section, key| {
            section.any_decimals(key, AllowedRange::PHYSICAL)
        },
        /// The evolution laws, each once; the runs to show take the first.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
        /// Permitted relative error of a run.
        pub tolerance: Rational = |section, key| section.decimal(key, AllowedRange::SIMULATION_TOLERANCE),
        /// Depth of an undershoot below V_l, relative to V_l, from which on a reader sees it.
        pub visible: Rational = |section, key| section.decimal(key, AllowedRange::OPEN_UNIT),
        /// A unit in which the normal stresses might have been meant instead, in Pa; absent when the unit is clear.
        pub other_unit_pa: Option<Rational> = |section, key| {
            section.optionally(key, |entry| entry.decimal(AllowedRange::PHYSICAL))
        },
    }
    points: |section| {
        let lines = section.normal_stress_pa.len() + section.loading_velocity_m_per_s.len();
        (RUNS_OF_A_SEARCH.saturating_mul(section.laws.len() as u64))
            .saturating_add(section.velocity_over_asymptote.len() as u64)
            .saturating_mul(lines as u64)
    },
    outcome: OnsetOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let runs = SEARCH_RUNS * section.laws.len() as f64 + section.velocity_over_asymptote.len() as f64;
        let stress_runs = SEARCH_RUNS * (section.laws.len() * section.loading_velocity_m_per_s.len()) as f64;
        let runs = runs * section.normal_stress_pa.len() as f64 + stress_runs;
        Work::simulations(runs, nearest_f64(&section.tolerance))
    },
    run: |section, earlier, _| Some(run::onset(earlier.slider()?, section, &earlier.scene.threshold())),
}
