//! Where a search begins: values read off the record, and the best of a grid around them.

use super::parameter::Point;
use super::problem::FitProblem;
use super::record::StepRecord;

/// What can be read off a record.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Readings {
    /// Friction before the first step.
    before: f64,
    /// a − b: change of the steady friction per ln V.
    rate_dependence: f64,
    /// The largest excursion of friction in the direction of a step, per ln V.
    direct: f64,
    /// The steepest rise of friction per displacement of the load point after a step, 1/m.
    slope_per_m: f64,
}

/// Shares of a piece at its end that count as steady.
const STEADY_SHARE: f64 = 0.15;
/// Factors of the direct effect and of the slope that are tried: a soft or slow record shows less than all of them.
const DIRECT_FACTORS: [f64; 4] = [1.0, 1.4, 2.2, 4.0];
const SLOPE_FACTORS: [f64; 5] = [0.5, 1.0, 2.0, 5.0, 15.0];
/// The smallest ln of a ratio of velocities that shows something.
const LEAST_LOG: f64 = 0.05;
/// A normal stress that differs by less shifts the friction by less than a step of velocity does.
const SAME_STRESS: f64 = 3e-3;
/// While the load point rests the slider slows down, to about this share of its velocity.
const AT_REST: f64 = 0.01;
/// Values of D_c that are tried.
const DISTANCES: u32 = 12;
/// Starts that are searched from.
const STARTS: usize = 8;

/// The best starts of a grid, at most one for each value of D_c, the best one first, each with its sum of squares.
///
/// Next to the best start there may be a minimum with a D_c far too short, where b only lessens a.
pub fn starts(problem: FitProblem<'_>) -> Vec<(Point, f64)> {
    let Some(readings) = Readings::of(problem.record) else { return Vec::new() };
    let mut found: Vec<(Point, f64)> = Vec::new();
    for distance in distances(problem.record) {
        let points = readings.grid(problem, distance).into_iter();
        let costs = points.filter_map(|point| Some((point, problem.coarse_cost(&point)?)));
        found.extend(costs.min_by(|one, other| one.1.total_cmp(&other.1)));
    }
    found.sort_by(|one, other| one.1.total_cmp(&other.1));
    found.truncate(STARTS);
    found
}

impl Readings {
    fn of(record: &StepRecord) -> Option<Self> {
        let ratios = &record.frictions;
        let levels: Vec<f64> = record.path.strides().map(|(samples, _)| steady(&ratios[samples])).collect();
        let reference = record.reference_velocity_m_per_s();
        let [mut product, mut square] = [0.0; 2];
        let at_levels = record.path.strides().zip(&levels);
        for ((samples, velocity), level) in at_levels.filter(|((_, velocity), _)| *velocity > 0.0) {
            let log = libm::log(velocity / reference);
            // Longer pieces are nearer to steady sliding at their end.
            let weight = record.times_s[samples.end] - record.times_s[samples.start];
            product += weight * log * (level - levels[0]);
            square += weight * log * log;
        }
        let mut readings = Self {
            before: levels[0],
            rate_dependence: if square > 0.0 { product / square } else { 0.0 },
            direct: 0.0,
            slope_per_m: 0.0,
        };
        let mut velocity = reference;
        let moving = |velocity: f64| velocity.max(AT_REST * reference);
        for ((samples, after), level) in record.path.strides().skip(1).zip(&levels) {
            let stop = under_one_normal_stress(record, samples.clone());
            readings.read_step((&record.times_s, ratios), stop, *level, [velocity, after].map(moving));
            velocity = after;
        }
        (readings.direct > 0.0 && readings.slope_per_m > 0.0).then_some(readings)
    }

    /// What one step shows: the samples after it, the level before it, and the velocities before and after it, m/s.
    fn read_step(
        &mut self,
        (times_s, ratios): (&[f64], &[f64]),
        samples: std::ops::Range<usize>,
        level: f64,
        [before, after]: [f64; 2],
    ) {
        let log = libm::log(after / before);
        if log.abs() < LEAST_LOG {
            return;
        }
        let start = samples.start;
        let excursion = |sample: usize| (ratios[sample] - level) * log.signum();
        let later = || start + 1..samples.end + 1;
        let Some(peak) = later().max_by(|one, other| excursion(*one).total_cmp(&excursion(*other))) else {
            return;
        };
        self.direct = self.direct.max(excursion(peak) / log.abs());
        // The first sample beyond half of the peak: between two samples noise would make any slope. Until then the slider keeps its
        // velocity, and the spring gains what the load point is ahead.
        if let Some(risen) = later().find(|sample| excursion(*sample) >= 0.5 * excursion(peak)) {
            let ahead = (after - before).abs() * (times_s[risen] - times_s[start]);
            self.slope_per_m = self.slope_per_m.max(excursion(risen) / ahead);
        }
    }

    /// The points of the grid with this ln D_c.
    fn grid(&self, problem: FitProblem<'_>, distance: f64) -> Vec<Point> {
        let weight = problem.record.normal_stress_pa;
        let stiffnesses: Vec<f64> = match problem.given.stiffness_pa_per_m {
            Some(stiffness) => vec![stiffness],
            None => SLOPE_FACTORS.iter().map(|factor| factor * self.slope_per_m * weight).collect(),
        };
        let mut points = Vec::new();
        for factor in DIRECT_FACTORS {
            let direct = factor * self.direct.max(1.05 * self.rate_dependence);
            // b > 0, whatever the noise makes of the steady levels.
            let evolution = (direct - self.rate_dependence).max(0.05 * direct);
            for stiffness in &stiffnesses {
                let [direct, evolution, stiffness] = [direct, evolution, *stiffness].map(libm::log);
                points.push([direct, evolution, distance, stiffness, self.before, 0.0]);
            }
        }
        points
    }
}

/// The samples from the first one on whose normal stress is nearly that of the first one.
fn under_one_normal_stress(record: &StepRecord, samples: std::ops::Range<usize>) -> std::ops::Range<usize> {
    let stresses = &record.measured.normal_stresses_pa;
    let differs = |sample: &usize| (stresses[*sample] / stresses[samples.start] - 1.0).abs() > SAME_STRESS;
    let end = samples.clone().find(differs).unwrap_or(samples.end);
    samples.start..end.max(samples.start + 1) - usize::from(end < samples.end)
}

/// Logarithms of the values of D_c that are tried.
fn distances(record: &StepRecord) -> Vec<f64> {
    let [shortest, longest] = record.ways_m().map(|way| libm::log(0.5 * way));
    let part = |index: u32| f64::from(index) / f64::from(DISTANCES - 1);
    (0..DISTANCES).map(|index| shortest + (longest - shortest) * part(index)).collect()
}

/// The mean of the last part of a piece.
fn steady(frictions: &[f64]) -> f64 {
    let from = ((1.0 - STEADY_SHARE) * frictions.len() as f64) as usize;
    let last = &frictions[from.min(frictions.len() - 1)..];
    last.iter().sum::<f64>() / last.len() as f64
}
