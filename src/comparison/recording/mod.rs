//! A trajectory that another program recorded: samples of time and velocity, reduced to its long-term behaviour.
//!
//! Only the samples are there, so every observable carries an error made from them. For largest and least values it is the next term
//! of an interpolation or, between samples, what the loading of the spring allows; for times and rates, the change when every second
//! sample is left out. How the last cycles differ shows how far the run still was from its limit.

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

/// What is most of the time: noise of a sensor makes the stress rise and fall for half of it each.
const MOST_TIME: f64 = 0.75;

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

    /// The recording with its times, velocities and stresses multiplied by factors, for a guess at another unit.
    pub(crate) fn scaled(&self, [time, velocity, stress]: [f64; 3]) -> Self {
        let times = |values: &[f64], factor: f64| values.iter().map(|value| value * factor).collect();
        let shift = libm::log(velocity);
        Self {
            times_s: times(&self.times_s, time),
            log_velocities: self.log_velocities.iter().map(|log| log + shift).collect(),
            stresses_pa: times(&self.stresses_pa, stress),
        }
    }

    /// Whether the stress falls for most of the time below the velocity of the load point, and rises above it: no spring is loaded so.
    pub(crate) fn has_reversed_stress(&self, log_level: f64) -> bool {
        // Below and above: the time in which the stress falls, and the time in which it rises.
        let mut times_s = [[0.0; 2]; 2];
        for at in 1..self.stresses_pa.len() {
            let [before, after] = [at - 1, at].map(|at| usize::from(self.log_velocities[at] > log_level));
            let rise = self.stresses_pa[at] - self.stresses_pa[at - 1];
            if before == after && rise != 0.0 {
                times_s[before][usize::from(rise > 0.0)] += self.times_s[at] - self.times_s[at - 1];
            }
        }
        let [[falls_below, rises_below], [falls_above, rises_above]] = times_s;
        falls_below > MOST_TIME * (falls_below + rises_below)
            && rises_above > MOST_TIME * (falls_above + rises_above)
    }

    /// Times (s) at which the velocity passes the level upwards, by interpolation between samples.
    pub(crate) fn upward_crossings_s(&self, log_level: f64) -> Vec<f64> {
        returns::crossings(self, log_level).into_iter().map(|crossing| crossing.time_s).collect()
    }
}
