//! Finite starts close to K = K_c: what the linear theory, which is the same for both laws, cannot tell.

use rayon::prelude::*;

use crate::dynamics::{Failure, Late, Model, Options, Outcome, simulate_model};
use crate::friction::{EvolutionLaw, Groups};
use crate::number::Rational;
use crate::scene::{NearTransition, SceneParameters};
use crate::study::effect_ratio;

/// One run from the start of the scene's simulations, V_l/10.
#[derive(Debug, Clone)]
pub struct NearRun {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: Rational,
    /// K/K_c.
    pub stiffness_over_critical: Rational,
    /// What the simulation showed, or why it has no result.
    pub outcome: Result<Outcome, Failure>,
}

impl NearRun {
    /// Whether the run ended on a limit cycle; none when it failed.
    #[must_use]
    pub fn periodic(&self) -> Option<bool> {
        self.outcome.as_ref().ok().map(|outcome| matches!(outcome.late(), Late::Cycle(_)))
    }
}

/// Simulates with each law at κ = (K/K_c)(β − 1)(1 + η), which is eq 9 in the groups.
#[must_use]
pub fn near_runs(
    parameters: &SceneParameters,
    near: &NearTransition,
    laws: &[EvolutionLaw],
    options: &Options,
) -> Vec<NearRun> {
    let cases: Vec<(EvolutionLaw, &Rational)> = laws
        .iter()
        .flat_map(|&law| near.stiffness_over_critical.iter().map(move |ratio| (law, ratio)))
        .collect();
    cases
        .par_iter()
        .map(|&(law, ratio)| {
            let effect_ratio = effect_ratio(parameters);
            let inertial = &near.inertial_parameter;
            let critical = Rational::from(&effect_ratio - 1) * Rational::from(inertial + 1);
            let groups = Groups {
                inertial_parameter: inertial.clone(),
                stiffness_group: critical * ratio,
                effect_ratio,
            };
            NearRun {
                law,
                inertial_parameter: inertial.clone(),
                stiffness_over_critical: ratio.clone(),
                outcome: simulate_model(&Model::new(groups.map(Rational::to_f64), law), options),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;

    #[test]
    fn only_the_aging_law_keeps_a_cycle_just_above_the_critical_stiffness() {
        let decimal = |text| parse_decimal(text).unwrap();
        let parameters = SceneParameters {
            direct_effect: decimal("0.004"),
            evolution_effect: decimal("0.006"),
            critical_slip_distance_m: decimal("10e-6"),
            stiffness_pa_per_m: decimal("10e6"),
            mass_per_area_kg_per_m2: decimal("1000"),
            normal_stress_pa: None,
            loading_velocity_m_per_s: None,
        };
        let near = NearTransition {
            inertial_parameter: decimal("0.01"),
            stiffness_over_critical: vec![decimal("0.999"), decimal("1.002"), decimal("1.01")],
        };
        let runs = near_runs(&parameters, &near, &EvolutionLaw::ALL, &Options::default());
        let ends: Vec<_> = runs.iter().map(|run| (run.law, run.periodic().unwrap())).collect();
        let (aging, slip) = (EvolutionLaw::Aging, EvolutionLaw::Slip);
        let expected =
            [(aging, true), (aging, true), (aging, false), (slip, true), (slip, false), (slip, false)];
        assert_eq!(ends, expected);
    }
}
