//! Returns: what lies between two upward crossings of the loading velocity.

use super::Recording;
use super::interpolation::{Extreme, crossing};

/// An upward crossing.
#[derive(Debug, Clone, Copy)]
pub struct UpwardCrossing {
    /// When, s.
    pub time_s: f64,
    /// The sample before it.
    pub sample: usize,
}

/// One oscillation, or several that form a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Return {
    /// When it ends, s.
    pub end_s: f64,
    /// How long it is, s.
    pub duration_s: f64,
    /// Largest ln(V/V_l).
    pub peak: Extreme,
    /// Least ln(V/V_l).
    pub trough: Extreme,
    /// Largest and least stress, Pa; not numbers when none was recorded.
    pub stresses_pa: [Extreme; 2],
}

impl Return {
    /// From the least to the largest ln V.
    pub fn swing(&self) -> f64 {
        self.peak.value - self.trough.value
    }

    /// Largest minus least stress, Pa.
    pub fn stress_drop_pa(&self) -> f64 {
        self.stresses_pa[0].value - self.stresses_pa[1].value
    }

    /// The error that the samples leave of the stress drop, Pa.
    pub fn stress_drop_error_pa(&self) -> f64 {
        self.stresses_pa[0].error + self.stresses_pa[1].error
    }

    fn joined(self, next: Self) -> Self {
        let [highest, lowest] = self.stresses_pa;
        Self {
            end_s: next.end_s,
            duration_s: self.duration_s + next.duration_s,
            peak: self.peak.outermost(next.peak, 1.0),
            trough: self.trough.outermost(next.trough, -1.0),
            stresses_pa: [
                highest.outermost(next.stresses_pa[0], 1.0),
                lowest.outermost(next.stresses_pa[1], -1.0),
            ],
        }
    }
}

/// All upward crossings of the level.
pub fn crossings(recording: &Recording, log_level: f64) -> Vec<UpwardCrossing> {
    let values = &recording.log_velocities;
    let rises = |index: &usize| values[*index] < log_level && log_level <= values[index + 1];
    let found = (0..values.len().saturating_sub(1)).filter(rises);
    let time_s = |sample| crossing(&recording.times_s, values, sample, log_level);
    found.map(|sample| UpwardCrossing { time_s: time_s(sample), sample }).collect()
}

/// The returns between upward crossings, `per_cycle` of them joined, counted back from the last crossing.
pub fn returns(recording: &Recording, log_level: f64, per_cycle: usize) -> Vec<Return> {
    let crossings = crossings(recording, log_level);
    let single: Vec<Return> = crossings.windows(2).map(|pair| orbit(recording, log_level, pair)).collect();
    let begin = single.len() % per_cycle;
    let joined = single[begin..].chunks(per_cycle);
    joined.filter_map(|cycle| cycle.iter().copied().reduce(Return::joined)).collect()
}

fn orbit(recording: &Recording, log_level: f64, pair: &[UpwardCrossing]) -> Return {
    let Recording { times_s, log_velocities, stresses_pa } = recording;
    let samples = pair[0].sample + 1..pair[1].sample + 1;
    let near = |values: &[f64], sign: f64| {
        let order = |one: &usize, other: &usize| (sign * values[*one]).total_cmp(&(sign * values[*other]));
        let best = samples.clone().max_by(order).unwrap_or(samples.start);
        (values[best], Extreme::near(times_s, values, best, sign))
    };
    let of_velocity = |sign| {
        let (_, Extreme { value, error }) = near(log_velocities, sign);
        Extreme { value: value - log_level, error }
    };
    let trough = of_velocity(-1.0);
    let of_stress = |sign| {
        let (sample, near) = near(stresses_pa, sign);
        near.within(sample, reach(recording, pair, trough.value, sign))
    };
    Return {
        end_s: pair[1].time_s,
        duration_s: pair[1].time_s - pair[0].time_s,
        peak: of_velocity(1.0),
        trough,
        stresses_pa: if stresses_pa.is_empty() { [Extreme::NONE; 2] } else { [1.0, -1.0].map(of_stress) },
    }
}

/// The largest (`sign` 1) or least stress that the spring can have had between samples: nothing loads it faster than a slider at
/// rest, and the least ln(V/V_l) tells how much slower the fastest step was.
fn reach(recording: &Recording, pair: &[UpwardCrossing], trough: f64, sign: f64) -> f64 {
    let (times, stresses) = (&recording.times_s, &recording.stresses_pa);
    let steps = pair[0].sample..pair[1].sample + 1;
    let duration = |at: usize| times[at + 1] - times[at];
    let rates = steps.clone().map(|at| (stresses[at + 1] - stresses[at]) / duration(at));
    let at_rest = rates.fold(0.0, f64::max) / -libm::expm1(trough);
    let ends = steps.map(|at| match sign > 0.0 {
        true => stresses[at] + at_rest * duration(at),
        false => at_rest * duration(at) - stresses[at + 1],
    });
    sign * ends.fold(f64::NEG_INFINITY, f64::max)
}

/// Cycles from all samples, and from each half of them.
pub(crate) struct Reduced {
    /// From all samples.
    pub whole: Vec<Return>,
    halves: [Vec<Return>; 2],
}

impl Reduced {
    pub fn of(recording: &Recording, log_level: f64, per_cycle: usize) -> Self {
        let mut whole = returns(recording, log_level, per_cycle);
        let halves = [0, 1].map(|phase| returns(&recording.every_second(phase), log_level, per_cycle));
        if !whole.is_empty() {
            whole.remove(0);
        }
        Self { whole, halves }
    }

    /// How far `value` of a return moves when every second sample is left out: the larger of two ways to do so.
    pub fn resolution(&self, orbit: &Return, value: impl Fn(&Return) -> f64) -> f64 {
        let moved = |half: &Vec<Return>| {
            let near = half.iter().min_by(|one, other| {
                (one.end_s - orbit.end_s).abs().total_cmp(&(other.end_s - orbit.end_s).abs())
            });
            let same = near.filter(|near| (near.end_s - orbit.end_s).abs() < 0.3 * orbit.duration_s);
            same.map_or(f64::INFINITY, |same| (value(same) - value(orbit)).abs())
        };
        self.halves.iter().map(moved).fold(0.0, f64::max)
    }
}
