//! Simulations at neighbouring tolerances: a tighter request must not cost less than a looser one.
//!
//! The same sliders run at every tolerance, over the paper's range of V_l and σ: they stick and slip, vibrate or return to steady sliding. One
//! sweep counts work and one measures CPU time, for each law and each b/a.

use slipmode_core::dynamics::{Model, Options, Simulation, simulate_model};
use slipmode_core::friction::{EvolutionLaw, Parameters};

use super::Sweep;
use crate::cost::series::place;
use crate::cpu_clock::cpu_seconds;

const TOLERANCES: [f64; 12] = [1e-2, 5e-3, 3e-3, 2e-3, 1e-3, 9e-4, 5e-4, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10];

const EFFECT_RATIOS: [f64; 5] = [0.5, 0.8, 1.5, 3.0, 5.0];

/// Sliders of each sweep.
const SLIDERS: u64 = 64;

/// Rounds in which all tolerances take turns.
const ROUNDS: u32 = 3;

/// What a step costs besides its evaluations, in evaluations: it factorises the Jacobian, estimates its error and looks for events. CPU times of
/// runs of orders 5 and 9 on limit cycles fit 42 ns per evaluation and 127 ns per step within 13 %.
const EVALUATIONS_OF_A_STEP: f64 = 3.0;

/// A tighter request costs at least 0.9 times as much, and at most 2.5 times (a hundred times tighter costs up to 1.9 times as much).
const ALLOWED: std::ops::RangeInclusive<f64> = 0.9..=2.5;

/// Work and CPU time of every law and b/a.
///
/// # Errors
/// When a simulation fails.
pub fn sweeps() -> Result<Vec<Sweep>, String> {
    let mut sweeps = Vec::new();
    for effect_ratio in EFFECT_RATIOS {
        for law in EvolutionLaw::ALL {
            let sliders: Vec<Slider> = sliders(effect_ratio, law, SLIDERS).collect();
            sweeps.push(work(&sliders, effect_ratio, law, &TOLERANCES)?);
            sweeps.push(time(&sliders, effect_ratio, law)?);
        }
    }
    Ok(sweeps)
}

type Slider = (Parameters<f64>, Model<f64>);

fn sliders(effect_ratio: f64, law: EvolutionLaw, count: u64) -> impl Iterator<Item = Slider> {
    (0..count).map(move |index| {
        let (velocity, stress) = place(index, [-6.0, -1.0], [3.0, 7.0]);
        let parameters = Parameters::from([0.004, 0.004 * effect_ratio, 1e-5, 1e7, 1000.0, stress, velocity]);
        (parameters.clone(), Model::new(parameters.groups(), law))
    })
}

fn simulation((parameters, model): &Slider, tolerance: f64) -> Result<Simulation, String> {
    let outcome = simulate_model(model, &Options::at(tolerance));
    let failed = |failure| format!("simulation of {parameters:?} at {tolerance:e}: {failure}");
    outcome.map(|outcome| outcome.in_si(parameters)).map_err(failed)
}

fn work(
    sliders: &[Slider],
    effect_ratio: f64,
    law: EvolutionLaw,
    tolerances: &[f64],
) -> Result<Sweep, String> {
    let mean = |&tolerance: &f64| {
        let mut sum = 0.0;
        for slider in sliders {
            let found = simulation(slider, tolerance)?;
            sum += found.evaluations as f64 + EVALUATIONS_OF_A_STEP * found.steps as f64;
        }
        Ok((format!("{tolerance:e}"), sum / sliders.len() as f64))
    };
    let points = tolerances.iter().map(mean).collect::<Result<_, String>>()?;
    Ok(sweep("work", "evaluations per run; 3 more for each step", effect_ratio, law, points))
}

fn time(sliders: &[Slider], effect_ratio: f64, law: EvolutionLaw) -> Result<Sweep, String> {
    let mut best = [f64::INFINITY; TOLERANCES.len()];
    for _ in 0..ROUNDS {
        for (best, tolerance) in best.iter_mut().zip(TOLERANCES) {
            let start = cpu_seconds();
            for slider in sliders {
                simulation(slider, tolerance)?;
            }
            *best = best.min((cpu_seconds() - start) / sliders.len() as f64);
        }
    }
    let points = TOLERANCES.iter().zip(best).map(|(tolerance, best)| (format!("{tolerance:e}"), 1e6 * best));
    Ok(sweep("time", "CPU time per run in µs", effect_ratio, law, points.collect()))
}

fn sweep(
    what: &str,
    quantity: &'static str,
    effect_ratio: f64,
    law: EvolutionLaw,
    points: Vec<(String, f64)>,
) -> Sweep {
    let name = format!("{what} of simulations; {} law; b/a {effect_ratio}", law.as_str());
    Sweep { name, variable: "tolerance", quantity, points, allowed_ratio: ALLOWED }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tighter_request_takes_no_less_work() {
        let tolerances = [1e-2, 5e-3, 3e-3, 2e-3, 1e-3, 5e-4, 1e-4, 1e-6];
        for effect_ratio in [0.8, 1.5, 5.0] {
            for law in EvolutionLaw::ALL {
                let sliders: Vec<Slider> = sliders(effect_ratio, law, 32).collect();
                let sweep = work(&sliders, effect_ratio, law, &tolerances).unwrap();
                assert_eq!(sweep.points.len(), tolerances.len());
                assert!(sweep.violations().is_empty(), "{:?}", sweep.violations());
            }
        }
    }
}
