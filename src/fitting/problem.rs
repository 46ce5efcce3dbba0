//! The residuals of a record at a point, with their derivatives.

use super::parameter::{PARAMETERS, Parameter, Point, slider};
use super::record::StepRecord;
use slipmode_core::dynamics::{Driven, DrivenControl, drive};
use slipmode_core::friction::EvolutionLaw;

/// What is known and what is fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitGiven {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// K, Pa/m; fitted where it is absent.
    pub stiffness_pa_per_m: Option<f64>,
    /// M, kg/m²; a slider without inertia where it is absent.
    pub mass_per_area_kg_per_m2: Option<f64>,
    /// Whether a linear drift is fitted.
    pub has_drift: bool,
}

impl FitGiven {
    /// The parameters that are fitted.
    pub(crate) fn free(&self) -> Vec<Parameter> {
        let is_free = |parameter: &Parameter| match parameter {
            Parameter::Stiffness => self.stiffness_pa_per_m.is_none(),
            Parameter::Drift => self.has_drift,
            _ => true,
        };
        Parameter::ALL.into_iter().filter(is_free).collect()
    }
}

/// The permitted local error of a run that a minimum is found on.
pub const FINE: f64 = 1e-9;
/// That of a run of a short search: under one normal stress, if it changes often.
pub const MEDIUM: f64 = 1e-6;
/// That of a run that starts are compared on: the same.
const COARSE: f64 = 1e-4;

/// Most steps of a run, and for each piece of the record: a slider that is stable next to its transition needs a few hundred.
const MOST_STEPS: u64 = 3_000;
const STEPS_PER_PIECE: u64 = 20;
/// Coordinates beyond this are no friction, and make no run.
const FARTHEST: f64 = 60.0;
/// D_c is sought from this part of the way between two samples, which a record cannot tell from zero, to this many times its longest way.
const RESOLVED: [f64; 2] = [0.02, 100.0];

/// A record with what is known of its slider.
#[derive(Debug, Clone, Copy)]
pub struct FitProblem<'r> {
    /// The record.
    pub record: &'r StepRecord,
    /// What is known.
    pub given: &'r FitGiven,
    /// The logarithms of D_c between which it is sought.
    distances: [f64; 2],
}

/// Model less record at every sample, and the derivatives by all coordinates.
#[derive(Debug, Clone)]
pub struct Evaluated {
    /// Differences in what was measured, in friction.
    pub residuals: Vec<f64>,
    /// Their derivatives; empty where none were requested.
    pub derivatives: Vec<[f64; PARAMETERS]>,
}

impl<'r> FitProblem<'r> {
    /// What is sought for a record.
    pub fn new(record: &'r StepRecord, given: &'r FitGiven) -> Self {
        let [shortest, longest] = record.ways_m();
        let distances = [RESOLVED[0] * shortest, RESOLVED[1] * longest].map(libm::log);
        Self { record, given, distances }
    }

    /// Whether a point is at an end of what a record can tell of D_c.
    pub fn is_unresolved(&self, point: &Point) -> bool {
        let distance = point[Parameter::CriticalSlipDistance as usize];
        self.distances.iter().any(|end| (distance - end).abs() < libm::log(2.0))
    }

    /// The residuals at a point; none where the slider has no run through the record in a permitted number of steps.
    pub fn evaluate(&self, point: &Point, local_tolerance: f64, with_derivatives: bool) -> Option<Evaluated> {
        if point.iter().take(4).any(|coordinate| coordinate.is_nan() || coordinate.abs() > FARTHEST) {
            return None;
        }
        let distance = point[Parameter::CriticalSlipDistance as usize];
        if !(self.distances[0]..=self.distances[1]).contains(&distance) {
            return None;
        }
        let slider = slider(point, self.given.mass_per_area_kg_per_m2, self.given.law);
        let record = self.record;
        let few = record.few_pieces.as_ref().filter(|_| local_tolerance > FINE);
        let pieces = few.unwrap_or(&record.pieces);
        let weight = |sample: usize| if few.is_some() { 1.0 } else { record.weights[sample] };
        let most_steps = MOST_STEPS + STEPS_PER_PIECE * pieces.len() as u64;
        let control = DrivenControl { local_tolerance, most_steps, with_derivatives };
        let driven = drive(&slider, pieces, &record.times_s, control).ok()?;
        let drift = point[Parameter::Drift as usize];
        // Driven stresses are over the normal stress at the start, frictions over that of their sample.
        let samples = || driven.iter().zip(&record.displacements_m).enumerate();
        let residuals: Vec<f64> = samples()
            .map(|(sample, (driven, way))| {
                let friction = driven.friction / weight(sample) + drift * way;
                record.scale(sample) * (friction - record.frictions[sample])
            })
            .collect();
        if !residuals.iter().all(|residual| residual.is_finite()) {
            return None;
        }
        let row = |(sample, (driven, way)): (usize, (&Driven, &f64))| {
            let scale = record.scale(sample);
            let [a, b, d, k, reference] =
                driven.derivatives.map(|derivative| scale * derivative / weight(sample));
            [a, b, d, k, reference, scale * way]
        };
        let derivatives = if with_derivatives { samples().map(row).collect() } else { Vec::new() };
        Some(Evaluated { residuals, derivatives })
    }

    /// The sum of squared residuals at a point, from a coarse run.
    pub fn coarse_cost(&self, point: &Point) -> Option<f64> {
        Some(sum_of_squares(&self.evaluate(point, COARSE, false)?.residuals))
    }
}

/// Σ r².
pub fn sum_of_squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|residual| residual * residual).sum()
}
