//! What keeps a record from being fitted, found before any fit.

use super::load_path::LoadPath;
use slipmode_core::number::format::{round_digits, shortest};

/// What was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// The time.
    Time,
    /// Displacement or velocity of the load point.
    Load,
    /// Shear stress or friction.
    Response,
    /// The normal stress.
    NormalStress,
}

/// Something wrong with a record.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordFault {
    /// The sample, counted from 0; none for the whole record.
    pub sample: Option<usize>,
    /// What is at fault; none for the whole record.
    pub column: Option<Column>,
    /// What is at fault, and what is wanted, in words.
    pub reason: String,
}

/// Fewest samples.
const LEAST_SAMPLES: usize = 20;
/// The smallest ratio of velocities that counts as a step.
const LEAST_RATIO: f64 = 1.02;
/// Ratios of spring stress to normal stress that are taken for friction.
const POSSIBLE_FRICTION: [f64; 2] = [0.01, 5.0];
/// Velocities of a load point that are taken for possible, m/s.
const POSSIBLE_VELOCITY: [f64; 2] = [1e-13, 10.0];
/// Equal extreme values in a row that a saturated sensor gives: a share of all samples, and at least this many.
const CLIPPED_SHARE: f64 = 0.02;
const CLIPPED: usize = 8;
/// A gap is this many times as long as the usual distance of the samples before and after it.
const GAP: f64 = 5.0;
/// Samples on each side that say what is usual.
const NEIGHBOURS: usize = 8;
/// Stick-slip: this many sudden drops in a piece of constant velocity, each of this share of the range of the whole record.
const EVENTS: usize = 5;
const EVENT_SHARE: f64 = 0.4;
/// The last drop of stick-slip is this share of the largest one, at least.
const GOES_ON: f64 = 0.7;
/// A drop of this many standard deviations of the noise is none of the noise.
const ABOVE_NOISE: f64 = 10.0;

/// All faults of a record; the ratios are those of spring stress to normal stress.
pub fn faults(times_s: &[f64], ratios: &[f64], path: Option<&LoadPath>) -> Vec<RecordFault> {
    let Some(path) = path.filter(|_| times_s.len() >= LEAST_SAMPLES) else {
        let reason = format!("{} rows (wanted: at least {LEAST_SAMPLES})", times_s.len());
        return vec![RecordFault { sample: None, column: None, reason }];
    };
    let mut found = Vec::new();
    found.extend(velocity_fault(path));
    found.extend(friction_fault(ratios));
    found.extend(clipped(ratios));
    found.extend(gap(times_s));
    if found.is_empty() {
        found.extend(events(ratios, path));
    }
    found
}

fn velocity_fault(path: &LoadPath) -> Option<RecordFault> {
    let velocities = &path.velocities_m_per_s;
    let first = velocities[0];
    let [slowest, fastest] = ends(velocities);
    let [least, most] = POSSIBLE_VELOCITY;
    let impossible = [first, fastest].into_iter().find(|velocity| !(least..=most).contains(velocity));
    let (sample, reason) = if slowest < -0.1 * fastest {
        let wanted = "forward motion; is its sign reversed?";
        (Some(0), format!("the load point moves at {slowest:.3e} m/s (wanted: {wanted})"))
    } else if first <= 0.0 {
        let wanted = "steady sliding at a positive velocity before the first step";
        (Some(0), format!("the load point moves at {} m/s (wanted: {wanted})", shortest(first)))
    } else if let Some(velocity) = impossible {
        let wanted = format!("{least:e} to {most} m/s; is the column, or the time, in another unit?");
        (None, format!("the load point moves at {velocity:.3e} m/s (wanted: {wanted})"))
    } else if fastest < LEAST_RATIO * slowest {
        let velocity = round_digits(first, 6);
        let wanted = format!("a step by a factor of at least {LEAST_RATIO}");
        let found = format!("no velocity step: the load point moves at {velocity} m/s throughout");
        (None, format!("{found} (wanted: {wanted})"))
    } else {
        return None;
    };
    Some(RecordFault { sample, column: Some(Column::Load), reason })
}

/// The sizes of the first sample and of the largest one.
fn friction_fault(ratios: &[f64]) -> Option<RecordFault> {
    let [least, most] = POSSIBLE_FRICTION;
    let is_wrong = |index: &usize| {
        let size = ratios[*index].abs();
        size > most || *index == 0 && !(least..=most).contains(&ratios[0])
    };
    let sample = (0..ratios.len()).find(is_wrong)?;
    let friction = ratios[sample];
    let question = if friction < -least {
        "is its sign reversed?"
    } else {
        "are all stresses in the unit of their column?"
    };
    let reason = format!("the friction is {friction:.4e} (wanted: {least} to {most}; {question})");
    Some(RecordFault { sample: Some(sample), column: Some(Column::Response), reason })
}

/// A sensor at the end of its range repeats its largest or smallest value.
fn clipped(ratios: &[f64]) -> Option<RecordFault> {
    let most = CLIPPED.max((CLIPPED_SHARE * ratios.len() as f64) as usize);
    let [smallest, largest] = ends(ratios);
    let mut start = 0;
    for run in ratios.chunk_by(|one, other| one == other) {
        let is_extreme = run[0] == largest || run[0] == smallest;
        if is_extreme && run.len() >= most {
            let reason = format!(
                "{} samples in a row have the {} friction {}: the sensor seems saturated, or its resolution hides the noise (wanted: a record within its range, with noise of half a step)",
                run.len(),
                if run[0] == largest { "largest" } else { "smallest" },
                shortest(run[0]),
            );
            return Some(RecordFault { sample: Some(start), column: Some(Column::Response), reason });
        }
        start += run.len();
    }
    None
}

/// A distance of two samples that is far longer than those before and those after.
fn gap(times_s: &[f64]) -> Option<RecordFault> {
    let steps: Vec<f64> = times_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let usual = |range: std::ops::Range<usize>| median(steps[range].to_vec());
    (1..steps.len().saturating_sub(1)).find_map(|index| {
        let before = usual(index.saturating_sub(NEIGHBOURS)..index)?;
        let after = usual(index + 1..(index + 1 + NEIGHBOURS).min(steps.len()))?;
        let usual_s = before.max(after);
        (steps[index] > GAP * usual_s).then(|| RecordFault {
            sample: Some(index + 1),
            column: Some(Column::Time),
            reason: format!(
                "a gap of {:.4e} s, where samples are {usual_s:.4e} s apart (wanted: a record without gaps)",
                steps[index]
            ),
        })
    })
}

/// Drops within pieces of constant velocity: a friction law whose steady sliding is stable has none.
fn events(ratios: &[f64], path: &LoadPath) -> Option<RecordFault> {
    let [smallest, largest] = ends(ratios);
    let least = (EVENT_SHARE * (largest - smallest)).max(ABOVE_NOISE * noise(ratios));
    path.strides().find_map(|(samples, _)| {
        let drops = drops(&ratios[samples.start..=samples.end], least);
        // After a step next to the transition the friction oscillates, less and less.
        let largest = drops.iter().copied().fold(0.0, f64::max);
        let goes_on = drops.last().is_some_and(|last| *last > GOES_ON * largest);
        (drops.len() >= EVENTS && goes_on).then(|| RecordFault {
            sample: Some(samples.start),
            column: Some(Column::Response),
            reason: format!(
                "{} drops of the friction at constant velocity from here on: stick-slip (wanted: sliding that becomes steady after each step)",
                drops.len()
            ),
        })
    })
}

/// The smallest and the largest value.
fn ends(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(*x), high.max(*x)])
}

/// The upper median.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// The standard deviation of a noise of independent samples, from the median change between neighbours.
fn noise(values: &[f64]) -> f64 {
    let changes = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    // The median size of a normal variable is 0.6745 of its deviation, and a difference has twice the variance.
    median(changes.collect()).map_or(0.0, |median| median / (0.6745 * std::f64::consts::SQRT_2))
}

/// By how much values fall, where they fall by at least this much before they rise by it again.
fn drops(values: &[f64], least: f64) -> Vec<f64> {
    let [mut top, mut bottom] = [values[0]; 2];
    let mut drops = Vec::new();
    for value in values {
        top = top.max(*value);
        bottom = bottom.min(*value);
        if value - bottom >= least {
            if top - bottom >= least {
                drops.push(top - bottom);
            }
            (top, bottom) = (*value, *value);
        } else if top - value < least {
            bottom = *value;
        }
    }
    drops
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sawtooth_has_drops_and_a_decaying_oscillation_smaller_ones() {
        let saw: Vec<f64> = (0..200).map(|i| f64::from(i % 20) / 20.0).collect();
        let found = drops(&saw, 0.4);
        assert_eq!(found.len(), 9);
        assert!(found.iter().all(|drop| (drop - 0.95).abs() < 1e-12), "{found:?}");
        let decay = (0..400).map(|i| libm::exp(-0.005 * f64::from(i)) * libm::cos(0.2 * f64::from(i)));
        let found = drops(&decay.collect::<Vec<_>>(), 0.4);
        assert!(found.len() > 5 && found[found.len() - 1] < 0.5 * found[0], "{found:?}");
    }
}
