//! A record: the spring stress at given times while the load point moves in steps of velocity.

use super::load_path::LoadPath;
use super::record_faults::{RecordFault, faults};
use slipmode_core::dynamics::Piece;
use slipmode_core::number::format::round_digits;

/// How the load point moves.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// Its displacement at each time, m, with the size of the last digits that are written; linear from one to the next.
    Displacement(Vec<f64>, f64),
    /// Its velocity from each time to the next, m/s.
    Velocity(Vec<f64>),
}

/// A record that a fit can use.
#[derive(Debug, Clone, PartialEq)]
pub struct StepRecord {
    /// Times since the first sample, s.
    pub times_s: Vec<f64>,
    /// Displacements of the load point since the first sample, m.
    pub displacements_m: Vec<f64>,
    /// Spring stress over normal stress.
    pub frictions: Vec<f64>,
    /// Normal stress over that of the first sample.
    pub weights: Vec<f64>,
    /// Normal stress of the first sample, Pa.
    pub normal_stress_pa: f64,
    /// Pieces of constant velocity and normal stress.
    pub pieces: Vec<Piece>,
    /// Pieces of constant velocity under the normal stress of the first sample, where the normal stress changes so often that it
    /// makes many more pieces.
    pub few_pieces: Option<Vec<Piece>>,
    /// The path of the load point.
    pub path: LoadPath,
    /// The record as it was given.
    pub measured: Measured,
}

/// What was measured at each time.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Times, s, increasing.
    pub times_s: Vec<f64>,
    /// The load point.
    pub load: Load,
    /// The spring.
    pub response: Response,
    /// Normal stress from each time to the next, Pa.
    pub normal_stresses_pa: Vec<f64>,
}

/// What was measured of the spring: the noise of its samples is alike.
#[derive(Debug, Clone, PartialEq)]
pub enum Response {
    /// Its stress, Pa.
    ShearStress(Vec<f64>),
    /// Its stress over the normal stress.
    Friction(Vec<f64>),
}

/// A normal stress that changes more often makes every run slow.
const MANY_PIECES: usize = 100;
/// Digits of a velocity that was read off a record.
const VELOCITY_DIGITS: usize = 9;
/// The rounding of a displacement that was computed with 64-bit numbers, relative to the largest.
const ROUNDING: f64 = 1e-14;
/// Distances of values are multiples of their smallest one within this part of it, where they lie on a grid.
const OFF_GRID: f64 = 0.1;

impl StepRecord {
    /// Makes a record of what was measured.
    ///
    /// # Errors
    /// All that keeps the record from being fitted.
    pub fn new(measured: Measured) -> Result<Self, Vec<RecordFault>> {
        let normal_stresses_pa = &measured.normal_stresses_pa;
        let start = measured.times_s.first().copied().unwrap_or_default();
        let times_s: Vec<f64> = measured.times_s.iter().map(|time| time - start).collect();
        let (displacements_m, resolution_m) = measured.load.displacements(&times_s);
        let normal_stress_pa = normal_stresses_pa.first().copied().unwrap_or(1.0);
        let frictions: Vec<f64> = match &measured.response {
            Response::Friction(frictions) => frictions.clone(),
            Response::ShearStress(stresses) => {
                stresses.iter().zip(normal_stresses_pa).map(|(stress, normal)| stress / normal).collect()
            }
        };
        let weights = normal_stresses_pa.iter().map(|stress| stress / normal_stress_pa).collect();
        let path = (times_s.len() > 1).then(|| LoadPath::through(&times_s, &displacements_m, resolution_m));
        let found = faults(&times_s, &frictions, path.as_ref());
        let Some(path) = path.filter(|_| found.is_empty()) else { return Err(found) };
        let under = |normal_stresses_pa: &[f64]| pieces(&times_s, &path, normal_stresses_pa);
        let pieces = under(normal_stresses_pa);
        let are_many = pieces.len() > path.ends.len() + MANY_PIECES;
        let few_pieces = are_many.then(|| under(&vec![normal_stress_pa; times_s.len()]));
        Ok(Self {
            times_s,
            displacements_m,
            frictions,
            weights,
            normal_stress_pa,
            pieces,
            few_pieces,
            path,
            measured,
        })
    }

    /// The same record with other frictions.
    pub(crate) fn with_frictions(&self, frictions: Vec<f64>) -> Self {
        Self { frictions, ..self.clone() }
    }

    /// The number of samples.
    pub(crate) fn rows(&self) -> usize {
        self.times_s.len()
    }

    /// The velocity of the load point before the first step, m/s, without the rounding errors of displacements.
    pub(crate) fn reference_velocity_m_per_s(&self) -> f64 {
        let velocity = self.pieces[0].load_point_velocity_m_per_s;
        round_digits(velocity, VELOCITY_DIGITS).parse().unwrap_or(velocity)
    }

    /// What a difference in friction is multiplied by to be one of what was measured, over the normal stress at the start.
    pub(crate) fn scale(&self, sample: usize) -> f64 {
        match self.measured.response {
            Response::ShearStress(_) => self.weights[sample],
            Response::Friction(_) => 1.0,
        }
    }

    /// The step between the values of what was measured, over the normal stress at the start; 0 where they lie on no grid.
    pub(crate) fn resolution(&self) -> f64 {
        let mut values: Vec<f64> =
            (0..self.rows()).map(|row| self.scale(row) * self.frictions[row]).collect();
        values.sort_by(f64::total_cmp);
        let least = f64::from(f32::EPSILON) * values[0].abs().max(values[values.len() - 1].abs());
        let gaps: Vec<f64> =
            values.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > least).collect();
        let smallest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let steps = |gap: &f64| (gap / smallest).round();
        let are_on_grid = gaps.iter().all(|gap| (gap / smallest - steps(gap)).abs() < OFF_GRID);
        if are_on_grid { gaps.iter().sum::<f64>() / gaps.iter().map(steps).sum::<f64>() } else { 0.0 }
    }

    /// The shortest way from one sample to the next after a step, on average between two steps, and the longest way after a step, m.
    pub(crate) fn ways_m(&self) -> [f64; 2] {
        let strides = self.path.strides().skip(1).filter(|(_, velocity)| *velocity > 0.0);
        strides.fold([f64::INFINITY, 0.0f64], |[shortest, longest], (samples, _)| {
            let way = (self.displacements_m[samples.end] - self.displacements_m[samples.start]).abs();
            [shortest.min(way / samples.len() as f64), longest.max(way)]
        })
    }
}

impl Load {
    /// Displacements since the first sample, and how exact they are.
    fn displacements(&self, times_s: &[f64]) -> (Vec<f64>, f64) {
        let (displacements, written) = match self {
            Self::Displacement(values, resolution_m) => {
                let start = values.first().copied().unwrap_or_default();
                (values.iter().map(|value| value - start).collect::<Vec<_>>(), *resolution_m)
            }
            Self::Velocity(velocities) => {
                let mut way = 0.0;
                let steps = times_s.windows(2).zip(velocities).map(|(pair, velocity)| {
                    way += velocity * (pair[1] - pair[0]);
                    way
                });
                ([0.0].into_iter().chain(steps).collect(), 0.0)
            }
        };
        let largest = displacements.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
        (displacements, written.max(ROUNDING * largest))
    }
}

/// The pieces of the path, cut wherever the normal stress changes.
fn pieces(times_s: &[f64], path: &LoadPath, normal_stresses_pa: &[f64]) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (samples, velocity) in path.strides() {
        for sample in samples.clone() {
            let is_last = sample + 1 == samples.end;
            if is_last || normal_stresses_pa[sample + 1] != normal_stresses_pa[sample] {
                pieces.push(Piece {
                    until_s: times_s[sample + 1],
                    load_point_velocity_m_per_s: velocity,
                    normal_stress_pa: normal_stresses_pa[sample],
                });
            }
        }
    }
    pieces
}

#[cfg(test)]
pub(super) mod fixtures {
    use super::*;
    use slipmode_core::dynamics::{DrivenControl, DrivenSlider, drive};
    use slipmode_core::number::split_mix::SplitMix64;

    /// A record of this slider with three steps and normally distributed noise, made of twelve uniform numbers.
    pub fn record(slider: &DrivenSlider, noise: f64, rows: u32) -> StepRecord {
        driven([1e-6, 1e-5, 2e-6, 1e-5], slider, noise, rows)
    }

    /// A record with 30 s at each of these velocities (m/s).
    pub fn driven(velocities: [f64; 4], slider: &DrivenSlider, noise: f64, rows: u32) -> StepRecord {
        let times: Vec<f64> = (0..rows).map(|row| 120.0 * f64::from(row) / f64::from(rows - 1)).collect();
        let velocity = |time: &f64| velocities[((time / 30.0) as usize).min(3)];
        let load = Load::Velocity(times.iter().map(velocity).collect());
        // Any record without faults, for its pieces.
        let stresses = times.iter().map(|time| 5e6 * (0.6 + 1e-4 * time)).collect();
        let normal_stresses_pa = vec![5e6; times.len()];
        let path = StepRecord::new(Measured {
            times_s: times,
            load,
            response: Response::ShearStress(stresses),
            normal_stresses_pa,
        })
        .unwrap();
        let control = DrivenControl { local_tolerance: 1e-11, most_steps: 100_000, with_derivatives: false };
        let driven = drive(slider, &path.pieces, &path.times_s, control).unwrap();
        let mut random = SplitMix64(7);
        let mut normal = || (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
        path.with_frictions(driven.iter().map(|driven| driven.friction + noise * normal()).collect())
    }
}
