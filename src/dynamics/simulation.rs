//! One simulation from parameters in SI to observables in SI, each with an error estimate.
//!
//! Everything is computed at a local tolerance and again at a tenth of it; the finer result is reported and the difference is its
//! stated error. A result that misses the asked accuracy is computed anew, tighter; when the arithmetic allows no
//! tighter run the answer is a failure that says what was reached.

use super::deviations::oscillation_of_small_deviations;
use super::integrator::{Control, Integrator};
use super::outcome::{Outcome, Simulation};
use super::settle::{Late, settle, settle_again};
use super::stepper::Stepper;
use super::{Balance, Failure, Model, Radau, Start};
use crate::friction::{EvolutionLaw, Parameters};
use crate::number::Rational;

/// What to simulate, beyond the parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How the start is completed.
    pub start: Start,
    /// V/V_l at the start; the paper takes 1/10.
    pub velocity_ratio: f64,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: f64,
    /// μ0 of the regularised friction law; none for eq 1 as it stands.
    pub regularised_reference_friction: Option<f64>,
    /// Most steps of one run, refused ones included.
    pub most_steps: u64,
    /// Most oscillations before the late behaviour is called undecided.
    pub most_laps: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            start: Start::default(),
            velocity_ratio: 0.1,
            tolerance: 1e-8,
            regularised_reference_friction: None,
            most_steps: 5_000_000,
            most_laps: 4_000,
        }
    }
}

/// Local tolerance of the first run, for the asked error of the results: Radau IIA of order 9 is that much better than its estimate.
const LOCAL_OVER_ASKED: f64 = 100.0;

/// The loosest and the tightest local tolerance in use.
const LOOSEST: f64 = 1e-3;
const TIGHTEST: f64 = 2e-13;

/// One run at one tolerance.
struct Run {
    late: Late<f64>,
    steps: u64,
    evaluations: u64,
}

/// Simulates a slider.
///
/// # Errors
/// A [`Failure`] when the start is not admissible, the late behaviour is undecided or the tolerance is out of reach.
pub fn simulate(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    options: &Options,
) -> Result<Simulation, Failure> {
    let groups = parameters.groups().map(Rational::to_f64);
    let parameters = parameters.map(Rational::to_f64);
    let balance = match options.regularised_reference_friction {
        Some(reference) => Balance::Regularised(reference / parameters.direct_effect),
        None => Balance::Inertial,
    };
    let outcome = simulate_model(&Model::with_balance(groups, law, balance), options)?;
    Ok(outcome.in_si(&parameters))
}

/// Simulates a slider without units.
///
/// # Errors
/// Those of [`simulate`].
pub fn simulate_model(model: &Model<f64>, options: &Options) -> Result<Outcome, Failure> {
    let asked = options.tolerance;
    let mut local = (LOCAL_OVER_ASKED * asked).clamp(TIGHTEST, LOOSEST);
    let mut target = 0.01 * asked;
    let mut reached = f64::INFINITY;
    let mut last_failure = None;
    let (mut steps, mut evaluations) = (0, 0);
    while local >= TIGHTEST {
        match both_runs(model, options, local, target) {
            Ok((coarse, fine)) => {
                steps += coarse.steps + fine.steps;
                evaluations += coarse.evaluations + fine.evaluations;
                let start = libm::log(options.velocity_ratio);
                let outcome =
                    Outcome::new(model, start, &coarse.late, fine.late, [steps, evaluations], 0.1 * local);
                reached = outcome.largest_error();
                if reached <= asked {
                    return Ok(outcome);
                }
            }
            Err(failure @ (Failure::Undecided { .. } | Failure::StepVanished { .. })) => {
                last_failure = Some(failure)
            }
            Err(failure) => return Err(failure),
        }
        local *= 0.01;
        target *= 0.1;
    }
    match last_failure {
        Some(failure) if reached.is_infinite() => Err(failure),
        _ => Err(Failure::UnreachableTolerance { asked, reached }),
    }
}

/// A run at the local tolerance, followed until it is within `target` of its late behaviour, and one at a tenth of it; on a cycle the second begins where the first ended.
fn both_runs(model: &Model<f64>, options: &Options, local: f64, target: f64) -> Result<(Run, Run), Failure> {
    let start = options.start.state(model, &libm::log(options.velocity_ratio));
    let control = Control { local_tolerance: local, most_steps: options.most_steps };
    let mut integrator = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
    let late = settle(&mut integrator, target, options.most_laps)?;
    let mut coarse = Run::of(late, &integrator);
    let finer = Control { local_tolerance: 0.1 * local, ..control };
    let from = match coarse.late {
        Late::Cycle(_) => *integrator.state(),
        Late::Decay(_) => start,
    };
    let mut integrator = Integrator::new(model, Radau::<f64, 5>::new(), from, finer)?;
    let late = match &coarse.late {
        Late::Cycle(found) => settle_again(&mut integrator, found, target, options.most_laps)?,
        Late::Decay(_) => settle(&mut integrator, target, options.most_laps)?,
    };
    let mut fine = Run::of(late, &integrator);
    // A pair that dies faster than the real mode leaves no clear trace in late behaviour, but it is there.
    if let (Late::Decay(coarse), Late::Decay(fine)) = (&mut coarse.late, &mut fine.late)
        && (coarse.oscillation.is_none() || fine.oscillation.is_none())
    {
        coarse.oscillation = oscillation_of_small_deviations(model, local.min(1e-6))?;
        fine.oscillation = oscillation_of_small_deviations(model, 0.1 * local.min(1e-6))?;
    }
    Ok((coarse, fine))
}

impl Run {
    fn of(late: Late<f64>, integrator: &Integrator<'_, f64, Radau<f64, 5>>) -> Self {
        let (accepted, refused) = integrator.step_counts();
        Self { late, steps: accepted + refused, evaluations: integrator.method().evaluations() }
    }
}
