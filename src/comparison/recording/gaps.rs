//! Gaps: a stretch of time without samples in which the run did something.

use super::Recording;
use super::returns::crossings;

/// A step that is too long for what happens around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// The sample that ends it, counted from 0.
    pub sample: usize,
    /// How long it is, s.
    pub step_s: f64,
    /// What it is compared with, s: the usual step of an evenly sampled run, or else the usual return.
    pub usual_s: f64,
    /// Whether the usual return is meant.
    pub is_return: bool,
}

/// A step beyond this many usual ones is a gap where nine tenths of the steps are equal.
const MOST_USUAL_STEPS: f64 = 2.5;
/// Steps are equal when they differ by less than this: times are often written with few digits.
const EVEN: f64 = 0.01;
/// A return this much longer than the usual one, half of which is a single step, hides at least one return.
const LONGEST_RETURN: f64 = 1.5;

impl Recording {
    /// The first gap, if there is one.
    ///
    /// Adaptive programs take long steps while the slider sticks, so a long step alone says nothing: in unevenly sampled
    /// runs it is a gap when the return around it is longer than the others by as much.
    #[must_use]
    pub fn gap(&self, log_level: f64) -> Option<Gap> {
        let steps: Vec<f64> = self.times_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let usual_s = median(&steps)?;
        let even = steps.iter().filter(|step| (*step / usual_s - 1.0).abs() < EVEN).count();
        if even * 10 >= steps.len() * 9 {
            let long = steps.iter().position(|step| *step > MOST_USUAL_STEPS * usual_s)?;
            return Some(Gap { sample: long + 1, step_s: steps[long], usual_s, is_return: false });
        }
        let crossings = crossings(self, log_level);
        let durations: Vec<f64> = crossings.windows(2).map(|pair| pair[1].time_s - pair[0].time_s).collect();
        let usual_s = median(&durations)?;
        crossings.windows(2).zip(&durations).find_map(|(pair, duration)| {
            let samples = pair[0].sample..pair[1].sample + 1;
            let long = samples.max_by(|one, other| steps[*one].total_cmp(&steps[*other]))?;
            let hides = *duration > LONGEST_RETURN * usual_s && steps[long] > 0.5 * usual_s;
            hides.then_some(Gap { sample: long + 1, step_s: steps[long], usual_s, is_return: true })
        })
    }
}

fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(times_s: Vec<f64>) -> Recording {
        let log_velocities = times_s.iter().map(|t| libm::sin(*t)).collect();
        Recording { times_s, log_velocities, stresses_pa: Vec::new() }
    }

    #[test]
    fn rows_taken_out_of_an_even_run_are_a_gap() {
        let mut times: Vec<f64> = (0..1000).map(|i| f64::from(i) * 0.1).collect();
        assert_eq!(wave(times.clone()).gap(0.0), None);
        times.drain(500..530);
        let gap = wave(times).gap(0.0).unwrap();
        assert_eq!((gap.sample, gap.is_return), (500, false));
        assert!((gap.step_s - 3.1).abs() < 1e-9 && (gap.usual_s - 0.1).abs() < 1e-9);
    }

    #[test]
    fn an_uneven_run_has_a_gap_only_where_returns_are_missing() {
        // Five short steps and a long one, over and over.
        let mut times: Vec<f64> =
            (0..1100).map(|i| f64::from(i / 6) * 1.5 + 0.1 * f64::from(i % 6)).collect();
        assert_eq!(wave(times.clone()).gap(0.0), None);
        times.retain(|time| !(60.0..80.0).contains(time));
        let gap = wave(times).gap(0.0).unwrap();
        assert!(
            gap.is_return && gap.step_s > 19.0 && (gap.usual_s / std::f64::consts::TAU - 1.0).abs() < 0.01
        );
    }
}
