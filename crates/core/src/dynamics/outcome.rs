//! What a simulation showed: without units, with its errors, and in SI.

use super::integrator::Work;
use super::long_term::{Cycle, LongTerm};
use super::section_return::Return;
use super::{Decay, Model};
use crate::friction::{Groups, Parameters, SlipMode};

/// Errors of what a long-term behaviour shows, in units of V_l, D_c/V_l and aσ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Errors {
    /// Of ln(V_peak/V_l).
    pub peak: f64,
    /// Of ln(period); none when there is none.
    pub period: Option<f64>,
    /// Of ln(V_min/V_l).
    pub trough: f64,
    /// Of the stress drop.
    pub drop: f64,
}

slipmode_algebra::named! {
    /// The long-term behaviour in one word.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Behaviour {
        /// A limit cycle.
        Periodic = "periodic",
        /// A return to steady sliding.
        Decaying = "decaying",
    }
}

/// What a simulation showed.
///
/// ```
/// use slipmode_core::{friction::{EvolutionLaw, Parameters}, dynamics::{Simulation, Options as SimulationOptions, simulate}, number::parse_decimal};
///
/// let number = |text| parse_decimal(text).unwrap();
/// let parameters = Parameters::from(["0.004", "0.006", "1e-5", "1e7", "1000", "1e4", "1e-5"].map(number));
/// let found: Simulation = simulate(&parameters, EvolutionLaw::Slip, &SimulationOptions::at(1e-4)).unwrap();
/// // K > K_c: the slider returns to steady sliding, with an oscillation that dies out.
/// assert_eq!(found.behaviour.as_str(), "decaying");
/// assert!(found.growth_rate_per_s.unwrap() < 0.0 && found.period_s.is_some());
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Simulation {
    /// Limit cycle or decay.
    pub behaviour: Behaviour,
    /// The slip mode, from the trajectory alone.
    pub slip_mode: SlipMode,
    /// Peak velocity of the cycle, or of the transient, m/s.
    pub peak_velocity_m_per_s: f64,
    /// log10 of the least velocity over V_l, of the cycle or the transient.
    pub minimum_velocity_log10_ratio: f64,
    /// Period of the cycle or of the long-term oscillation, s; none when nothing oscillates.
    pub period_s: Option<f64>,
    /// Largest minus least spring stress, Pa: of the cycle, or of the whole transient with its start and steady sliding, where it may only rise.
    pub stress_drop_pa: f64,
    /// The same in units of aσ.
    pub stress_drop_over_direct_effect: f64,
    /// Crossings of V = V_l per second in long-term behaviour, Hz; none when nothing oscillates.
    pub frequency_hz: Option<f64>,
    /// Growth rate of the long-term oscillation, or the rate of a long-term decay without oscillation, 1/s; none on a cycle.
    pub growth_rate_per_s: Option<f64>,
    /// Leading Floquet multiplier of the cycle as seen in its approach; an upper bound when superattracting.
    pub floquet_multiplier: Option<f64>,
    /// Estimated relative error of the peak velocity.
    pub peak_relative_error: f64,
    /// Estimated relative error of the period; none when there is none.
    pub period_relative_error: Option<f64>,
    /// Estimated error of `minimum_velocity_log10_ratio`, absolute.
    pub minimum_velocity_log10_error: f64,
    /// Estimated relative error of the stress drop.
    pub stress_drop_relative_error: f64,
    /// Accepted and refused steps of all runs.
    pub steps: u64,
    /// Evaluations of the right-hand side of all runs.
    pub evaluations: u64,
    /// Local tolerance of the finest run.
    pub local_tolerance: f64,
}

/// A simulation in units of V_l, D_c/V_l and aσ.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    long_term: LongTerm<f64>,
    groups: Groups<f64>,
    errors: Errors,
    work: Work,
    local_tolerance: f64,
}

/// Peak and period of a long-term behaviour; start and end count for a transient's peak.
pub(super) fn peak_and_period(long_term: &LongTerm<f64>) -> (f64, Option<f64>) {
    match long_term {
        LongTerm::Cycle(cycle) => (cycle.orbit.peak, Some(cycle.orbit.duration)),
        LongTerm::Decay(Decay { transient, oscillation, .. }) => {
            (transient.peak.max(transient.end[0]), oscillation.map(|oscillation| oscillation.period))
        }
    }
}

/// The extremes of a cycle or of a transient.
pub(super) const fn extremes(long_term: &LongTerm<f64>) -> &Return<f64> {
    match long_term {
        LongTerm::Cycle(cycle) => &cycle.orbit,
        LongTerm::Decay(decay) => &decay.transient,
    }
}

impl Outcome {
    /// A long-term behaviour with the errors of what it shows.
    pub(super) fn new(
        model: &Model<f64>,
        long_term: LongTerm<f64>,
        errors: Errors,
        work: Work,
        local_tolerance: f64,
    ) -> Self {
        Self { long_term, groups: model.groups().clone(), errors, work, local_tolerance }
    }

    /// The long-term behaviour in units of V_l, D_c/V_l and aσ.
    #[must_use]
    pub const fn long_term(&self) -> &LongTerm<f64> {
        &self.long_term
    }

    /// ln(V_peak/V_l).
    #[must_use]
    pub fn log_peak(&self) -> f64 {
        peak_and_period(&self.long_term).0
    }

    /// Estimated relative error of the peak velocity: e^{error of the logarithm} − 1.
    #[must_use]
    pub fn peak_relative_error(&self) -> f64 {
        libm::expm1(self.errors.peak)
    }

    fn period_relative_error(&self) -> Option<f64> {
        self.errors.period.map(libm::expm1)
    }

    /// Accepted and refused steps of all runs.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.work.steps
    }

    /// Factor by which deviations from the cycle shrank in one return of the approach; none for a decay.
    #[must_use]
    pub const fn contraction(&self) -> Option<f64> {
        if let LongTerm::Cycle(cycle) = &self.long_term { cycle.contraction } else { None }
    }

    pub(super) fn largest_error(&self) -> f64 {
        self.peak_relative_error().max(self.period_relative_error().unwrap_or(0.0))
    }

    /// The slip mode, from the trajectory alone: what it ends in, and how fast it oscillates against √(K/M).
    #[must_use]
    pub fn slip_mode(&self) -> SlipMode {
        let natural_squared = self.groups.natural_angular_frequency_squared();
        let inertial = |angular: f64| 2.0 * angular * angular > natural_squared;
        match &self.long_term {
            LongTerm::Cycle(cycle) if inertial(angular_frequency(cycle)) => SlipMode::HarmonicVibration,
            LongTerm::Cycle(_) => SlipMode::StickSlip,
            LongTerm::Decay(Decay { oscillation: Some(oscillation), .. }) => {
                if inertial(std::f64::consts::TAU / oscillation.period) {
                    SlipMode::InertialUnderdampedOscillation
                } else {
                    SlipMode::NonInertialUnderdampedOscillation
                }
            }
            // Below eq 16 every mode decays faster than e^{-V_l t/D_c}; a slower end belongs to the area above eq 15.
            LongTerm::Decay(Decay { rate: Some(rate), .. })
                if *rate > -1.0 && self.groups.effect_ratio < 1.0 =>
            {
                SlipMode::OverdampedOscillation
            }
            LongTerm::Decay(_) => SlipMode::OverdampedStableSliding,
        }
    }

    /// The same in SI.
    #[must_use]
    pub fn in_si(&self, parameters: &Parameters<f64>) -> Simulation {
        let rate_per_s = parameters.rate_per_s();
        let Return { highest_stress, lowest_stress, .. } = extremes(&self.long_term);
        let drop = highest_stress - lowest_stress;
        let (log_peak, period) = peak_and_period(&self.long_term);
        let (returns, growth) = match &self.long_term {
            LongTerm::Cycle(cycle) => (cycle.returns_per_cycle, None),
            LongTerm::Decay(decay) => {
                (1, decay.oscillation.map(|oscillation| oscillation.growth_rate).or(decay.rate))
            }
        };
        let periodic = matches!(self.long_term, LongTerm::Cycle(_));
        Simulation {
            behaviour: if periodic { Behaviour::Periodic } else { Behaviour::Decaying },
            slip_mode: self.slip_mode(),
            peak_velocity_m_per_s: parameters.point.loading_velocity_m_per_s * libm::exp(log_peak),
            minimum_velocity_log10_ratio: extremes(&self.long_term).trough / std::f64::consts::LN_10,
            period_s: period.map(|period| period / rate_per_s),
            stress_drop_pa: drop * parameters.direct_stress_pa(),
            stress_drop_over_direct_effect: drop,
            frequency_hz: period.map(|period| returns as f64 * rate_per_s / period),
            growth_rate_per_s: growth.map(|growth| growth * rate_per_s),
            floquet_multiplier: self.contraction(),
            peak_relative_error: self.peak_relative_error(),
            period_relative_error: self.period_relative_error(),
            minimum_velocity_log10_error: self.errors.trough / std::f64::consts::LN_10,
            stress_drop_relative_error: self.errors.drop / drop,
            steps: self.work.steps,
            evaluations: self.work.evaluations,
            local_tolerance: self.local_tolerance,
        }
    }
}

fn angular_frequency(cycle: &Cycle<f64>) -> f64 {
    std::f64::consts::TAU * cycle.returns_per_cycle as f64 / cycle.orbit.duration
}
