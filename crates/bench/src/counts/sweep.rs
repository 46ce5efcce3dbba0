//! A sweep of simulations: steps and evaluations against the worst error, tolerance by tolerance.
//!
//! The sweep spans V_l = 1e-6 … 1e-1 m/s and σ = 1e3 … 1e7 Pa under both laws. The reference is the same at a tolerance of 1e-11;
//! what the integrator itself is worth is compared with double-double elsewhere.

use rayon::prelude::*;

use super::Sizes;
use slipmode_core::dynamics::{Failure, Options, Simulation, simulate};
use slipmode_core::friction::{EvolutionLaw, Parameters, Slider};
use slipmode_core::number::Rational;

/// The sweep at one tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepCount {
    /// Relative error requested of peak velocity and period.
    pub tolerance: f64,
    /// Runs.
    pub runs: usize,
    /// Runs that ended without an answer.
    pub failed: usize,
    /// Runs whose long-term behaviour is not the reference's.
    pub wrong: usize,
    /// Runs whose true error exceeds the tolerance.
    pub beyond: usize,
    /// Steps of all runs.
    pub steps: u64,
    /// Evaluations of the right-hand side of all runs.
    pub evaluations: u64,
    /// The worst relative error of a peak velocity or a period.
    pub worst_error: f64,
}

/// The tolerance of the reference.
const REFERENCE: f64 = 1e-11;

type Run = Result<Simulation, Failure>;

/// The sweep at every tolerance.
pub(crate) fn count(parameters: &Slider<Rational>, sizes: &Sizes) -> Vec<SweepCount> {
    let points = points(parameters, sizes.sweep_side);
    let at = |tolerance: f64| -> Vec<Run> {
        let options = Options::at(tolerance);
        points.par_iter().map(|(point, law)| simulate(point, *law, &options)).collect()
    };
    let reference = at(REFERENCE);
    let tolerances = sizes.tolerances.iter().copied();
    tolerances.map(|tolerance| summed(tolerance, &at(tolerance), &reference)).collect()
}

fn points(parameters: &Slider<Rational>, side: u32) -> Vec<(Parameters<Rational>, EvolutionLaw)> {
    let at = |low: f64, high: f64, index: u32| {
        let share = f64::from(index) / f64::from(side.saturating_sub(1).max(1));
        Rational::from_f64(libm::exp10(low + (high - low) * share)).unwrap_or_default()
    };
    let cells = (0..side).flat_map(|v| (0..side).map(move |s| (v, s)));
    cells
        .flat_map(|(v, s)| {
            let point = parameters.at(at(3.0, 7.0, s), at(-6.0, -1.0, v));
            EvolutionLaw::ALL.map(|law| (point.clone(), law))
        })
        .collect()
}

fn summed(tolerance: f64, runs: &[Run], reference: &[Run]) -> SweepCount {
    let mut sum = SweepCount {
        tolerance,
        runs: runs.len(),
        failed: 0,
        wrong: 0,
        beyond: 0,
        steps: 0,
        evaluations: 0,
        worst_error: 0.0,
    };
    for (run, reference) in runs.iter().zip(reference) {
        let (Ok(run), Ok(reference)) = (run, reference) else {
            sum.failed += 1;
            continue;
        };
        sum.steps += run.steps;
        sum.evaluations += run.evaluations;
        if run.behaviour != reference.behaviour {
            sum.wrong += 1;
            continue;
        }
        let peak = (run.peak_velocity_m_per_s / reference.peak_velocity_m_per_s - 1.0).abs();
        let period =
            run.period_s.zip(reference.period_s).map_or(0.0, |(one, other)| (one / other - 1.0).abs());
        sum.beyond += usize::from(peak.max(period) > tolerance);
        sum.worst_error = sum.worst_error.max(peak).max(period);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::counts::paper;

    #[test]
    fn a_tighter_tolerance_takes_more_evaluations_and_gives_a_smaller_error() {
        let sizes = Sizes { sweep_side: 2, tolerances: &[1e-2, 1e-8], ..Sizes::REPORTED };
        let found = count(&paper(), &sizes);
        assert_eq!((found[0].runs, found[0].failed, found[0].wrong), (8, 0, 0));
        assert!(found[0].evaluations < found[1].evaluations && found[0].worst_error > found[1].worst_error);
        assert!(found.iter().all(|sum| sum.beyond == 0), "{found:?}");
    }
}
