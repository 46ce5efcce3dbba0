//! Intervals by profile likelihood: a parameter is held, all others are fitted again, until the sum of squares says that it is too far.

use nalgebra::DMatrix;

use super::least_squares::{Minimum, NEAR, minimise};
use super::parameter::{Parameter, Point};
use super::problem::FitProblem;
use super::residuals::Residuals;

/// A point of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// The value of the parameter.
    pub value: f64,
    /// The root of the increase of the sum of squares over the variance: the distance from the best value in standard errors.
    pub distance: f64,
}

/// The profile of a parameter.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Profile {
    /// The ends of the 95 % interval as coordinates; none where the record sets no bound on that side.
    pub ends: [Option<f64>; 2],
    /// The points that were computed, by rising value, with the best value among them.
    pub points: Vec<ProfilePoint>,
    /// A point with a smaller sum of squares, where one was met.
    pub better: Option<Point>,
}

/// An end is found when its distance is right to this part: it is then exact to this part of its distance from the best value.
const EXACT: f64 = 2e-3;
/// Runs along a profile to find an end, at most.
const MOST_TRIALS: usize = 12;
/// Trials without a result after which the record sets no bound.
const MOST_FAILURES: usize = 3;
/// A logarithm that changes by more than this is not bounded by the record.
const FARTHEST: f64 = 6.9;

/// What all profiles of a fit share.
pub struct Profiler<'r> {
    /// The record and what is known.
    pub problem: FitProblem<'r>,
    /// The best point.
    pub minimum: &'r Minimum,
    /// The parameters that are fitted.
    pub free: &'r [Parameter],
    /// Their covariance for residuals of variance 1.
    pub covariance: &'r DMatrix<f64>,
    /// The noise.
    pub residuals: &'r Residuals,
}

impl Profiler<'_> {
    /// How many standard errors of independent samples the interval of a parameter extends to each side: the noise, and a mean error
    /// of rounding in each sample that moves the parameter to the same side.
    pub fn half_width(&self, index: usize) -> f64 {
        let moved = |row: &Point| -> f64 {
            let others = self.free.iter().enumerate();
            others.map(|(other, parameter)| self.covariance[(index, other)] * row[*parameter as usize]).sum()
        };
        let moved: f64 = self.minimum.evaluated.derivatives.iter().map(|row| moved(row).abs()).sum();
        self.residuals.half_width() + self.residuals.rounding() * moved / self.error(index)
    }

    /// The standard error of a parameter for independent samples.
    pub fn error(&self, index: usize) -> f64 {
        self.residuals.standard_deviation * self.covariance[(index, index)].sqrt()
    }

    /// The profile of one of the fitted parameters.
    pub fn profile(&self, index: usize) -> Profile {
        let parameter = self.free[index];
        let best = self.minimum.point[parameter as usize];
        let points = vec![ProfilePoint { value: parameter.value(best), distance: 0.0 }];
        let mut found = Profile { points, ..Profile::default() };
        for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
            found.ends[side] = self.end(index, sign, &mut found);
        }
        found.points.sort_by(|one, other| one.value.total_cmp(&other.value));
        found
    }

    /// The end of the interval on one side, by secants on the distance, which is nearly linear.
    fn end(&self, index: usize, sign: f64, found: &mut Profile) -> Option<f64> {
        let parameter = self.free[index];
        let best = self.minimum.point[parameter as usize];
        let wanted = self.half_width(index);
        let error = self.error(index);
        let farthest = if parameter.is_logarithmic() { FARTHEST } else { 1e3 * error };
        let [mut inside, mut outside] = [(0.0, 0.0), (f64::INFINITY, f64::INFINITY)];
        let mut offset = (wanted * error).min(farthest);
        let mut warm = self.minimum.point;
        let mut failures = 0;
        for _ in 0..MOST_TRIALS {
            let start = self.predicted(index, sign * offset, &warm, inside.0);
            let Some((distance, point)) = self.distance(index, &start) else {
                // No slider of that kind has a run.
                failures += 1;
                if failures == MOST_FAILURES {
                    return None;
                }
                outside = (offset, f64::INFINITY);
                offset = 0.5 * (inside.0 + offset);
                continue;
            };
            if distance < 0.0 {
                found.better = Some(point);
                return None;
            }
            found.points.push(ProfilePoint {
                value: parameter.value(best + sign * offset),
                distance: sign * distance,
            });
            if (distance / wanted - 1.0).abs() < EXACT {
                return Some(best + sign * offset);
            }
            if distance < wanted {
                (inside, warm) = ((offset, distance), point);
            } else {
                outside = (offset, distance);
            }
            if inside.0 >= farthest {
                return None;
            }
            offset = next(inside, outside, wanted).min(farthest);
        }
        // The bracket is what is known; where nothing beyond has a run, the record sets no bound.
        outside.1.is_finite().then_some(best + sign * outside.0)
    }

    /// A start with the parameter at an offset: along the valley of the quadratic, from the last point inside.
    fn predicted(&self, index: usize, offset: f64, warm: &Point, warm_offset: f64) -> Point {
        let mut start = *warm;
        let step = offset - offset.signum() * warm_offset;
        for (other, parameter) in self.free.iter().enumerate() {
            let slope = self.covariance[(other, index)] / self.covariance[(index, index)];
            start[*parameter as usize] += slope * step;
        }
        start[self.free[index] as usize] = self.minimum.point[self.free[index] as usize] + offset;
        start
    }

    /// How far a point is in standard errors, negative for a better minimum, and where the others went.
    fn distance(&self, index: usize, start: &Point) -> Option<(f64, Point)> {
        let others: Vec<Parameter> =
            self.free.iter().copied().filter(|parameter| *parameter != self.free[index]).collect();
        let held = minimise(self.problem, start, &others, NEAR).filter(|held| held.is_converged)?;
        let variance = self.residuals.standard_deviation * self.residuals.standard_deviation;
        let increase = (held.cost - self.minimum.cost) / variance;
        let distance = if increase < -1e-3 { -1.0 } else { increase.max(0.0).sqrt() };
        Some((distance, held.point))
    }
}

/// The next offset between a point inside of the interval and one outside, or beyond the first where none is outside.
fn next(inside: (f64, f64), outside: (f64, f64), wanted: f64) -> f64 {
    if outside.1.is_finite() {
        let part = ((wanted - inside.1) / (outside.1 - inside.1)).clamp(0.05, 0.95);
        return inside.0 + part * (outside.0 - inside.0);
    }
    if outside.0.is_finite() {
        return 0.5 * (inside.0 + outside.0);
    }
    // Never more than threefold: a distance that grows slower than linearly would lead far away.
    inside.0 * (1.02 * wanted / inside.1.max(1e-3)).clamp(1.02, 3.0)
}
