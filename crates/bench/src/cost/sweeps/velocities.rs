//! Simulated decays while the loading velocity changes: from forces that balance within a part of a period to a friction state that does.

use slipmode_core::dynamics::{Model, Options, simulate_model};
use slipmode_core::friction::{EvolutionLaw, Groups, Parameters};

use super::Sweep;
use crate::cpu_clock::cpu_seconds;

/// log10 of V_l in m/s, in tenths: inertial underdamped oscillations at σ = 10^4 Pa.
const TENTHS: std::ops::RangeInclusive<i32> = -30..=-5;

/// The requested relative error.
const TOLERANCE: f64 = 1e-8;

/// Rounds in which all velocities take turns, and runs of one velocity in a round.
const ROUNDS: usize = 7;
const RUNS: usize = 8;

/// The paper's values with b < a at σ = 10^4 Pa.
fn model(law: EvolutionLaw, tenths: i32) -> Model<f64> {
    let velocity = libm::exp10(0.1 * f64::from(tenths));
    let groups = Groups {
        inertial_parameter: 1e9 * velocity * velocity / 0.6,
        stiffness_group: 5.0 / 3.0,
        effect_ratio: 2.0 / 3.0,
    };
    Model::new(groups, law)
}

fn label(tenths: i32) -> String {
    format!("10^{:.1}", 0.1 * f64::from(tenths))
}

/// Evaluations of the right-hand side, and CPU time, of one simulation under each law.
///
/// # Errors
/// When a simulation fails.
pub fn sweeps() -> Result<Vec<Sweep>, String> {
    let mut sweeps = Vec::new();
    for law in EvolutionLaw::ALL {
        sweeps.push(sweep(law, "evaluations", evaluations(law)?, 0.5..=1.5));
        // Where Radau IIA takes over from the series it does less work, and a step of it takes longer: a factor of 1.8 in all.
        sweeps.push(sweep(law, "CPU µs", cpu_times(law)?, 0.5..=2.0));
    }
    Ok(sweeps)
}

fn sweep(
    law: EvolutionLaw,
    quantity: &'static str,
    values: Vec<f64>,
    allowed_ratio: std::ops::RangeInclusive<f64>,
) -> Sweep {
    let name = format!("decays to 1e-8 under the {} law: {quantity}", law.as_str());
    let points = TENTHS.map(label).zip(values).collect();
    Sweep { name, variable: "loading velocity in m/s", quantity, points, allowed_ratio }
}

fn evaluations(law: EvolutionLaw) -> Result<Vec<f64>, String> {
    let units = Parameters::from([1.0; 7]);
    TENTHS
        .map(|tenths| {
            let outcome = simulate_model(&model(law, tenths), &Options::at(TOLERANCE));
            let outcome = outcome.map_err(|failure| format!("V_l = {} m/s: {failure}", label(tenths)))?;
            Ok(outcome.in_si(&units).evaluations as f64)
        })
        .collect()
}

fn cpu_times(law: EvolutionLaw) -> Result<Vec<f64>, String> {
    let models: Vec<Model<f64>> = TENTHS.map(|tenths| model(law, tenths)).collect();
    let mut best = vec![f64::INFINITY; models.len()];
    for _ in 0..ROUNDS {
        for (model, best) in models.iter().zip(&mut best) {
            let began = cpu_seconds();
            for _ in 0..RUNS {
                let outcome = simulate_model(std::hint::black_box(model), &Options::at(TOLERANCE));
                std::hint::black_box(outcome).map_err(|failure| failure.to_string())?;
            }
            *best = best.min((cpu_seconds() - began) / RUNS as f64 * 1e6);
        }
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn evaluations_of_decays_change_by_less_than_half_from_velocity_to_velocity() {
        for law in EvolutionLaw::ALL {
            let counted = sweep(law, "evaluations", evaluations(law).unwrap(), 0.5..=1.5);
            assert_eq!(counted.points.len(), 26);
            assert_eq!(counted.violations(), Vec::<String>::new());
            assert!(counted.points.iter().all(|(_, count)| *count < 10_000.0), "{:?}", counted.points);
        }
    }
}
