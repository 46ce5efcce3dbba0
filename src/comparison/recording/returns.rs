//! Returns: what lies between two upward crossings of the loading velocity.

use super::Recording;
use super::interpolation::{crossing, vertex};

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
    pub peak: f64,
    /// Least ln(V/V_l).
    pub trough: f64,
    /// Largest and least stress, Pa; not numbers when none was recorded.
    pub stresses_pa: [f64; 2],
}

impl Return {
    /// From the least to the largest ln V.
    pub fn swing(&self) -> f64 {
        self.peak - self.trough
    }

    /// Largest minus least stress, Pa.
    pub fn stress_drop_pa(&self) -> f64 {
        self.stresses_pa[0] - self.stresses_pa[1]
    }

    fn joined(self, next: Self) -> Self {
        Self {
            end_s: next.end_s,
            duration_s: self.duration_s + next.duration_s,
            peak: self.peak.max(next.peak),
            trough: self.trough.min(next.trough),
            stresses_pa: [
                self.stresses_pa[0].max(next.stresses_pa[0]),
                self.stresses_pa[1].min(next.stresses_pa[1]),
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
    let samples = pair[0].sample + 1..pair[1].sample + 1;
    let times = &recording.times_s;
    let highest = |values: &[f64]| {
        let best = samples.clone().max_by(|one, other| values[*one].total_cmp(&values[*other]));
        best.map_or(f64::NAN, |index| vertex(times, values, index, 1.0))
    };
    let lowest = |values: &[f64]| {
        let low = samples.clone().min_by(|one, other| values[*one].total_cmp(&values[*other]));
        low.map_or(f64::NAN, |index| vertex(times, values, index, -1.0))
    };
    let stresses = &recording.stresses_pa;
    let extremes = if stresses.is_empty() { [f64::NAN; 2] } else { [highest(stresses), lowest(stresses)] };
    Return {
        end_s: pair[1].time_s,
        duration_s: pair[1].time_s - pair[0].time_s,
        peak: highest(&recording.log_velocities) - log_level,
        trough: lowest(&recording.log_velocities) - log_level,
        stresses_pa: extremes,
    }
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
