//! A trajectory that another program recorded: samples of time and velocity, reduced to its long-term behaviour.
//!
//! Only the samples are there, so every observable carries an error made from them: the same reduction on every second
//! sample shows what the sampling leaves open, and how the last cycles differ shows how far the run still was from its limit.

mod decay;
mod gaps;
mod interpolation;
mod long_term;
mod returns;

pub use decay::RecordedDecay;
pub use gaps::Gap;
pub use long_term::{RecordedBehaviour, Undecided};

use serde::Serialize;

/// A value with the error that the recording leaves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Its estimated relative error; infinite when the samples do not resolve it.
    pub relative_error: f64,
}

impl Measured {
    /// The value and its absolute error.
    pub(crate) fn with_absolute_error(self) -> (f64, f64) {
        (self.value, self.relative_error * self.value.abs())
    }
}

/// Samples in order of strictly increasing time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recording {
    /// Times, s.
    pub times_s: Vec<f64>,
    /// ln(V in m/s): velocities of a stick phase lie far below what differences of 64-bit numbers resolve.
    pub log_velocities: Vec<f64>,
    /// Spring stress, Pa, from any origin; as many as times, or none at all.
    pub stresses_pa: Vec<f64>,
}

/// The least number of samples that shows a long-term behaviour.
pub const LEAST_SAMPLES: usize = 8;

impl Recording {
    /// Every second sample, beginning with the first (`phase` 0) or the second (`phase` 1).
    fn every_second(&self, phase: usize) -> Self {
        let half = |values: &[f64]| values.iter().skip(phase).step_by(2).copied().collect();
        Self {
            times_s: half(&self.times_s),
            log_velocities: half(&self.log_velocities),
            stresses_pa: half(&self.stresses_pa),
        }
    }

    /// The recording with its velocities multiplied by a factor, for a guess at another unit.
    pub(crate) fn with_velocities_times(&self, factor: f64) -> Self {
        let shift = libm::log(factor);
        let log_velocities = self.log_velocities.iter().map(|log| log + shift).collect();
        Self { log_velocities, ..self.clone() }
    }

    /// The recording with its stresses multiplied by a factor, for a guess at another unit.
    pub(crate) fn with_stresses_times(&self, factor: f64) -> Self {
        Self { stresses_pa: self.stresses_pa.iter().map(|stress| stress * factor).collect(), ..self.clone() }
    }

    /// Times (s) at which the velocity passes the level upwards, by interpolation between samples.
    pub(crate) fn upward_crossings_s(&self, log_level: f64) -> Vec<f64> {
        returns::crossings(self, log_level).into_iter().map(|crossing| crossing.time_s).collect()
    }
}
