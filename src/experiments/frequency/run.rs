//! max Im(s) along lines of constant normal stress (fig 2), with eq 23 and ω_n next to it.

use crate::parallel;
use slipmode_core::friction::Slider;

use crate::experiments::frequency::FrequencySection;
use crate::experiments::map::run::exactly;
use slipmode_core::number::{Rational, Wide};
use slipmode_core::stability::{InertialThreshold, classify};

/// One line of constant normal stress.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyLine {
    /// σ/σ_c, exact.
    pub normal_stress_over_critical: Rational,
    /// σ, Pa, exact.
    pub normal_stress_pa: Rational,
    /// Largest Im(s), 1/s, at each velocity of the outcome: relative error at most 1e-14.
    pub max_imaginary_per_s: Vec<Wide>,
}

/// The lines of a scene and their velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyOutcome {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: Vec<f64>,
    /// One line per requested ratio σ/σ_c.
    pub lines: Vec<FrequencyLine>,
}

/// Computes the lines; the scene reader has made sure that b > a, so that σ_c exists.
pub(super) fn frequency_lines(parameters: &Slider<Rational>, section: &FrequencySection) -> FrequencyOutcome {
    let velocities = section.loading_velocity_m_per_s.coordinates();
    let critical = parameters.critical_normal_stress_pa();
    let threshold = InertialThreshold::default();
    let line = |ratio: &Rational| {
        let stress = critical.clone() * ratio;
        let max_imaginary_per_s = parallel::map(&velocities, |&velocity| {
            classify(&parameters.at(stress.clone(), exactly(velocity)), &threshold).max_imaginary_per_s
        });
        let normal_stress_over_critical = ratio.clone();
        FrequencyLine { normal_stress_over_critical, normal_stress_pa: stress, max_imaginary_per_s }
    };
    let lines = section.normal_stress_over_critical.iter().map(line).collect();
    FrequencyOutcome { loading_velocity_m_per_s: velocities, lines }
}
