//! `simulate --trajectory` and `--svg`: the run from its start as CSV or as a picture, in SI.

use std::fmt;

use rug::Float;
use slipmode::experiments::pictures::trajectory_picture;
use slipmode::experiments::trajectories::Moment;
use slipmode_core::dynamics::{Options, Sample, Simulation};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::format::{round_float, shortest};
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::failure::Failure;
use crate::cli::simulate::run::follow;

/// The columns; the stress is counted from that of steady sliding at V0, which eq 1 gives up to μ0 only, and slip from the start.
const HEADER: &str = "time_s,velocity_m_per_s,state_variable_s,shear_stress_pa,slip_m\n";
/// Periods that a trajectory shows.
const PERIODS: f64 = 10.0;
/// Decay times that a trajectory without oscillation shows: e^-30 is 1e-13.
const DECAY_TIMES: f64 = 30.0;
/// Digits of a sample beyond those of the estimated error of the peak.
const GUARD_DIGITS: usize = 1;

/// What a trajectory shall show.
#[derive(Debug, Clone, Default)]
pub struct Extent {
    /// Its duration, s; none for the usual one.
    pub duration_s: Option<Rational>,
    /// Samples at equal steps of time, both ends included; none for those of the integrator's steps.
    pub samples: Option<u64>,
}

/// A run that was followed from its start.
pub struct History {
    units: Units,
    samples: Vec<Sample>,
}

impl History {
    /// Integrates from the start again, as accurately as the finest run of the simulation.
    ///
    /// # Errors
    /// When the integrator fails, or the duration is beyond the range of 64-bit numbers.
    pub fn of(
        parameters: &Parameters<Rational>,
        law: EvolutionLaw,
        options: Options,
        simulation: &Simulation,
        extent: &Extent,
    ) -> Result<Self, Failure> {
        let units = Units::new(parameters, simulation);
        let duration =
            extent.duration_s.as_ref().map_or_else(|| default_duration(simulation, &units), nearest_f64);
        let until = duration * units.rate_per_s;
        if !(until.is_normal() && units.rate_per_s.is_normal()) {
            return Err(failed(&"its duration is beyond the range of 64-bit numbers"));
        }
        let samples = follow(parameters, law, options, simulation, (until, extent.samples));
        Ok(Self { units, samples: samples.map_err(|failure| failed(&failure))? })
    }

    /// The samples as CSV; of samples with the same time, the first.
    pub fn csv(&self) -> String {
        let mut text = String::from(HEADER);
        let mut last = f64::NEG_INFINITY;
        for sample in &self.samples {
            let time_s = sample.time / self.units.rate_per_s;
            if time_s > last {
                text.push_str(&self.units.line(time_s, sample, self.slip(sample)));
                last = time_s;
            }
        }
        text
    }

    /// Velocity, stress and slip against time as SVG.
    ///
    /// # Errors
    /// When the samples have no extent.
    pub fn svg(&self) -> Result<String, Failure> {
        let moment = |sample: &Sample| Moment {
            time_s: sample.time / self.units.rate_per_s,
            log_velocity_ratio: sample.state[0],
            stress_change_pa: sample.state[2] * self.units.stress_pa,
        };
        let moments: Vec<(Moment, f64)> =
            self.samples.iter().map(|sample| (moment(sample), self.slip(sample))).collect();
        let picture = trajectory_picture(&moments, self.units.velocity_m_per_s.to_f64());
        picture.ok_or_else(|| failed(&"its values have no extent that can be drawn"))
    }

    /// Slip since the start, m. The spring's stress and the slip are one integral: ζ = ζ0 + κ (t − slip), in units of D_c.
    fn slip(&self, sample: &Sample) -> f64 {
        let stretched = (sample.state[2] - self.samples[0].state[2]) / self.units.stiffness_group;
        (sample.time - stretched) * self.units.slip_distance_m
    }
}

fn failed(reason: &dyn fmt::Display) -> Failure {
    Failure::Check(format!("error: the trajectory failed: {reason}"))
}

fn default_duration(simulation: &Simulation, units: &Units) -> f64 {
    match (simulation.period_s, simulation.growth_rate_per_s) {
        (Some(period_s), _) => PERIODS * period_s,
        (None, Some(rate)) if rate.is_normal() => DECAY_TIMES / rate.abs(),
        _ => DECAY_TIMES / units.rate_per_s,
    }
}

/// From the model's units to SI.
struct Units {
    rate_per_s: f64,
    velocity_m_per_s: Float,
    state_s: Float,
    stress_pa: f64,
    stiffness_group: f64,
    slip_distance_m: f64,
    digits: usize,
}

impl Units {
    fn new(parameters: &Parameters<Rational>, simulation: &Simulation) -> Self {
        let rate_per_s = parameters.rate_per_s();
        let stress_pa = parameters.direct_stress_pa();
        let certain = -libm::log10(simulation.peak_relative_error);
        Self {
            velocity_m_per_s: Float::with_val(64, &parameters.point.loading_velocity_m_per_s),
            state_s: Float::with_val(64, rate_per_s.clone().recip()),
            rate_per_s: nearest_f64(&rate_per_s),
            stress_pa: nearest_f64(&stress_pa),
            stiffness_group: nearest_f64(&parameters.groups().stiffness_group),
            slip_distance_m: nearest_f64(&parameters.slider.critical_slip_distance_m),
            // At least two digits are certain at any tolerance, and 64-bit numbers have fifteen.
            digits: certain.clamp(2.0, 14.0) as usize + GUARD_DIGITS,
        }
    }

    /// A velocity far below the least 64-bit number is still positive, so exponentials are taken in a wider range.
    fn line(&self, time_s: f64, sample: &Sample, slip_m: f64) -> String {
        let [x, y, zeta] = sample.state;
        let exponential = |exponent: f64, unit: &Float| Float::with_val(64, exponent).exp() * unit;
        let rounded = |value: f64| round_float(&Float::with_val(64, value), self.digits);
        format!(
            "{},{},{},{},{}\n",
            shortest(time_s),
            round_float(&exponential(x, &self.velocity_m_per_s), self.digits),
            round_float(&exponential(y, &self.state_s), self.digits),
            rounded(zeta * self.stress_pa),
            rounded(slip_m),
        )
    }
}
