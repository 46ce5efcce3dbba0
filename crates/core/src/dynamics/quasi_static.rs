//! The quasi-static slider, where inertia provably does not matter to the requested accuracy.
//!
//! With η = 0 the spring always balances friction. The full system follows its slow trajectory at the distance η e^x x' in x, to first
//! order in η (substitute x = ζ − βy + O(η) into the equation of motion). Each swing of that distance leaves an error of its size, so the
//! total variation along a run estimates the error of ln V. A run in which it exceeds the tolerance is given up: then there is no quasi-static answer.

use super::events::{Mark, candidates, state_at};
use super::integrator::{Control, Integrator};
use super::section_return::QUIET;
use super::{Balance, Failure, Model, Options, Radau, Stepper};
use crate::friction::{EvolutionLaw, Groups};

/// What a quasi-static run showed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiStatic {
    /// ln(V_peak/V_l) of the transient.
    pub log_peak: f64,
    /// Upward crossings of V = V_l, counted up to 20.
    pub crossings: u32,
    /// Total variation of η e^x x': the estimated error of ln V from leaving inertia out.
    pub inertia_neglected: f64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Crossings after which a run ends: the transient's peak is long past.
const MOST_PASSAGES: u32 = 20;

/// Simulates the transient of a slider without inertia; `None` when inertia matters more than the tolerance allows, as in every instability.
///
/// # Errors
/// Those of the integrator.
pub fn simulate_quasi_statically(
    groups: &Groups<f64>,
    law: EvolutionLaw,
    options: &Options,
) -> Result<Option<QuasiStatic>, Failure> {
    let model = Model::with_balance(groups.clone(), law, Balance::QuasiStatic);
    let control =
        Control { local_tolerance: (100.0 * options.tolerance).min(1e-5), most_steps: options.most_steps };
    let start = options.start.state(&model, &libm::log(options.velocity_ratio));
    let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control)?;
    let mut seen = QuasiStatic {
        log_peak: start[0].max(0.0),
        crossings: 0,
        inertia_neglected: model.inertia_neglected(&start).abs(),
        evaluations: 0,
    };
    while seen.crossings < MOST_PASSAGES && run.state().iter().any(|c| c.abs() > QUIET) {
        if seen.inertia_neglected > options.tolerance {
            return Ok(None);
        }
        match run.advance(None) {
            // A velocity that runs away in finite time leaves no step to take.
            Err(Failure::StepVanished { log_velocity, .. }) if log_velocity > 0.0 => return Ok(None),
            other => other?,
        }
        let swing = model.inertia_neglected(run.state()) - model.inertia_neglected(run.step_start());
        seen.inertia_neglected += swing.abs();
        for candidate in candidates(&run).into_iter().flatten() {
            match candidate.mark {
                Mark::Rise => seen.crossings += 1,
                Mark::Peak => seen.log_peak = seen.log_peak.max(state_at(&run, candidate)[0]),
                Mark::Fall | Mark::Trough => {}
            }
        }
    }
    seen.evaluations = run.method().evaluations();
    Ok(Some(seen))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::simulate_model;

    #[test]
    // Steady sliding at V_l/10 is a kick of ln 10 that the slip law survives only for K/K_c − 1 > ln 10 or so.
    fn what_is_neglected_bounds_the_error_of_the_peak() {
        let options = Options { tolerance: 1e-2, ..Options::default() };
        for law in EvolutionLaw::ALL {
            for (inertial_parameter, stiffness_group) in [(1e-7, 2.0), (1e-5, 3.0), (1e-4, 10.0)] {
                let groups = Groups { inertial_parameter, stiffness_group, effect_ratio: 1.5 };
                let quasi_static = simulate_quasi_statically(&groups, law, &options).unwrap().unwrap();
                let full = simulate_model(&Model::new(groups, law), &Options::default()).unwrap();
                let error = (full.log_peak() - quasi_static.log_peak).abs();
                assert!(error <= quasi_static.inertia_neglected + 1e-7, "{error:e} {quasi_static:?}");
            }
        }
    }

    #[test]
    fn an_instability_has_no_quasi_static_answer() {
        let groups = Groups { inertial_parameter: 1e-8, stiffness_group: 0.1, effect_ratio: 1.5 };
        for law in EvolutionLaw::ALL {
            assert_eq!(simulate_quasi_statically(&groups, law, &Options::default()).unwrap(), None);
        }
    }
}
