//! max Im(s) along lines of constant normal stress (fig 2).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::{FrequencyLine, FrequencyOutcome};

use crate::experiments::work::DECISION_S;
use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, LogAxis};
use slipmode_core::number::Rational;

experiment! {
    /// `[frequency]`: max Im(s) along lines of constant normal stress.
    pub struct FrequencySection {
        /// σ/σ_c of each line, exact (decimals or fractions n/d); positive.
        pub normal_stress_over_critical: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of ratios > 0", AllowedRange::PHYSICAL)
        },
        /// Loading velocities, m/s.
        pub loading_velocity_m_per_s: LogAxis = Section::axis,
    }
    points: |section| {
        let points = u64::from(section.loading_velocity_m_per_s.points);
        points.saturating_mul(section.normal_stress_over_critical.len() as u64)
    },
    requires: CriticalNormalStress,
    outcome: FrequencyOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let lines = section.normal_stress_over_critical.len() as f64;
        Work::points(f64::from(section.loading_velocity_m_per_s.points) * lines, DECISION_S)
    },
    run: |section, earlier, _| Some(run::frequency_lines(earlier.slider()?, section)),
}
