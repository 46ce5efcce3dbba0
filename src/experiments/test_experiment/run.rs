//! The critical stiffness of a slider without inertia at given normal stresses.

use crate::experiments::test_experiment::TestExperimentSection;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;

/// (b − a)σ/D_c in Pa/m, one for each normal stress.
pub fn quasi_static_critical_stiffness(
    slider: &Slider<Rational>,
    section: &TestExperimentSection,
) -> Vec<Rational> {
    let per_stress =
        (slider.evolution_effect.clone() - &slider.direct_effect) / &slider.critical_slip_distance_m;
    section.normal_stress_pa.iter().map(|stress| per_stress.clone() * stress).collect()
}
