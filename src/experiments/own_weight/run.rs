//! Exact slip modes in the plane of loading velocity and K/M, where σ = M·g.

use crate::parallel;

use crate::experiments::map::run::exactly;
use crate::experiments::own_weight::OwnWeightSection;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

/// The slip modes of a slider under its own weight. They depend on K and M through K/M only: with σ = M·g, η = V²/(g a D_c) and
/// κ = (K/M)·D_c/(g a).
#[derive(Debug, Clone, PartialEq)]
pub struct OwnWeightOutcome {
    /// Loading velocities, m/s, ascending.
    pub loading_velocity_m_per_s: Vec<f64>,
    /// K/M, 1/s², ascending.
    pub stiffness_over_mass_per_s2: Vec<f64>,
    /// The slip mode of each point, decided exactly; rows of constant K/M.
    pub slip_modes: Vec<SlipMode>,
}

/// Classifies every point of the plane.
pub(crate) fn own_weight(
    slider: &Slider<Rational>,
    section: &OwnWeightSection,
    threshold: &InertialThreshold,
) -> OwnWeightOutcome {
    let velocities = section.loading_velocity_m_per_s.coordinates();
    let ratios = section.stiffness_over_mass_per_s2.coordinates();
    let weight_pa = Rational::from(&slider.mass_per_area_kg_per_m2 * &section.gravity_m_per_s2);
    let mode = |ratio: f64, velocity: f64| {
        let stiffness_pa_per_m = exactly(ratio) * &slider.mass_per_area_kg_per_m2;
        let slider = Slider { stiffness_pa_per_m, ..slider.clone() };
        classify(&slider.at(weight_pa.clone(), exactly(velocity)), threshold).slip_mode
    };
    let row = |&ratio: &f64| velocities.iter().map(|&velocity| mode(ratio, velocity)).collect::<Vec<_>>();
    let slip_modes = parallel::flat_map(&ratios, row);
    OwnWeightOutcome { loading_velocity_m_per_s: velocities, stiffness_over_mass_per_s2: ratios, slip_modes }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use crate::scene::LogAxis;

    #[test]
    fn only_the_ratio_of_stiffness_to_mass_counts() {
        let axis = |from: u32, to: u32| LogAxis { from: from.into(), to: to.into(), points: 5 };
        let section = OwnWeightSection {
            gravity_m_per_s2: Rational::from((981, 100)),
            loading_velocity_m_per_s: LogAxis {
                from: Rational::from((1, 1_000_000)),
                to: Rational::from((1, 10)),
                points: 6,
            },
            stiffness_over_mass_per_s2: axis(100, 100_000),
        };
        let light = paper();
        let heavy =
            Slider { mass_per_area_kg_per_m2: light.mass_per_area_kg_per_m2.clone() * 7u32, ..light.clone() };
        let threshold = InertialThreshold::default();
        let [light, heavy] = [light, heavy].map(|slider| own_weight(&slider, &section, &threshold));
        assert_eq!(light, heavy);
        let kinds: std::collections::BTreeSet<&str> =
            light.slip_modes.iter().map(|mode| mode.as_str()).collect();
        assert!(kinds.len() > 2, "{kinds:?}");
    }
}
