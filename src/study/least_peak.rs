//! The loading velocity at which the peak velocity is least, by minimisation, against eq 18 (fig 5).

use rayon::prelude::*;

use crate::dynamics::{Behaviour, Options, simulate};
use crate::friction::EvolutionLaw;
use crate::scene::{SceneParameters, SimulationsSection};
use crate::stability::{Asymptote, critical_normal_stress_pa, has_transition};
use crate::study::map::exactly;

/// The minimum of the peak velocity over the loading velocity at one normal stress.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastPeak {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Normal stress, Pa.
    pub normal_stress_pa: f64,
    /// Velocity of eq 18, m/s.
    pub eq18_velocity_m_per_s: f64,
    /// log10 of the minimising velocity over that of eq 18, to [`MINIMISER_ERROR_DEX`].
    pub offset_dex: f64,
    /// Peak velocity at eq 18 over the least one.
    pub peak_at_eq18_over_least: f64,
}

/// Where the search stops, dex: above the noise of a minimum whose values are known to the tolerance 1e-8 or better.
pub const MINIMISER_ERROR_DEX: f64 = 2e-3;

/// Half of the width that is searched around eq 18, dex.
const REACH_DEX: f64 = 1.0;

/// Samples that bracket the minimum before it is refined.
const SAMPLES: i32 = 9;

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Minimises at every normal stress of the section's grid above σ_c, where no velocity is stable; a stress is left out
/// when a run fails or decays, or when the least sample lies at an end of the searched range.
#[must_use]
pub fn least_peaks(
    parameters: &SceneParameters,
    section: &SimulationsSection,
    options: &Options,
) -> Vec<LeastPeak> {
    let stresses = section.rectangle.normal_stress_pa.coordinates();
    let cases: Vec<(EvolutionLaw, f64)> = section
        .laws
        .iter()
        .flat_map(|&law| stresses.iter().map(move |&stress| (law, stress)))
        .filter(|&(_, stress)| {
            let point = parameters.at(exactly(stress), exactly(1.0));
            has_transition(&point) && exactly(stress) > critical_normal_stress_pa(&point)
        })
        .collect();
    cases.par_iter().filter_map(|&(law, stress)| least_peak(parameters, law, stress, options)).collect()
}

fn least_peak(
    parameters: &SceneParameters,
    law: EvolutionLaw,
    stress: f64,
    options: &Options,
) -> Option<LeastPeak> {
    let at_unit_velocity = parameters.at(exactly(stress), exactly(1.0)).map(|value| value.to_f64());
    let eq18 = Asymptote::InertialUpper.value(&at_unit_velocity);
    let peak = |offset: f64| {
        let velocity = eq18 * libm::exp10(offset);
        let simulation = simulate(&parameters.at(exactly(stress), exactly(velocity)), law, options).ok()?;
        (simulation.behaviour == Behaviour::Periodic).then_some(simulation.peak_velocity_m_per_s)
    };
    let step = 2.0 * REACH_DEX / f64::from(SAMPLES - 1);
    let samples: Option<Vec<f64>> =
        (0..SAMPLES).map(|index| peak(f64::from(index).mul_add(step, -REACH_DEX))).collect();
    let samples = samples?;
    let least = (0..samples.len()).min_by(|&i, &j| samples[i].total_cmp(&samples[j]))?;
    if least == 0 || least + 1 == samples.len() {
        return None;
    }
    #[expect(clippy::cast_precision_loss, reason = "an index below ten")]
    let centre = (least as f64).mul_add(step, -REACH_DEX);
    let offset_dex = golden_section(centre - step, centre + step, MINIMISER_ERROR_DEX, peak)?;
    let peak_at_eq18_over_least = peak(0.0)? / peak(offset_dex)?;
    Some(LeastPeak {
        law,
        normal_stress_pa: stress,
        eq18_velocity_m_per_s: eq18,
        offset_dex,
        peak_at_eq18_over_least,
    })
}

/// The minimiser of a function with one minimum between two ends, to `width`; none where the function has no value.
fn golden_section(
    mut low: f64,
    mut high: f64,
    width: f64,
    value: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    let mut left = high - GOLDEN * (high - low);
    let mut right = low + GOLDEN * (high - low);
    let (mut at_left, mut at_right) = (value(left)?, value(right)?);
    while high - low > width {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = value(left)?;
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = value(right)?;
        }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_golden_section_finds_a_minimum_inside_and_a_hole_ends_it() {
        let found = golden_section(-1.0, 2.0, 1e-6, |x| Some((x - 0.3) * (x - 0.3))).unwrap();
        assert!((found - 0.3).abs() < 1e-6, "{found}");
        assert_eq!(golden_section(-1.0, 2.0, 1e-6, |x| (x < 0.5).then_some(x)), None);
    }
}
