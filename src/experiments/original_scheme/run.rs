//! The fixed-step scheme of the original simulations: bias of the long-term peak, order, and what becomes of figs 3a and 5.

use rayon::prelude::*;

use crate::experiments::original_scheme::OriginalSchemeSection;
use crate::experiments::original_scheme::least_peak::{SchemeLeastPeak, least_peaks_of_scheme};
use crate::experiments::original_scheme::scheme::{
    AFFORDABLE_STEPS, SchemePeak, converged_cycle, model_at, scheme_peak, steps_needed,
};
use crate::experiments::original_scheme::stability::{SchemeMapRow, SchemeTransition, map_rows, transitions};
use crate::scene::Place;
use slipmode_core::dynamics::Failure;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};

/// The scheme at one place with one step.
#[derive(Debug, Clone, PartialEq)]
pub struct SchemeStep {
    /// Step in units of √(M/K).
    pub fraction: f64,
    /// Steps that the run takes.
    pub steps_needed: f64,
    /// The long-term peak; none when the run would take more than [`AFFORDABLE_STEPS`].
    pub peak: Option<Result<SchemePeak, Failure>>,
}

/// The scheme at one place through its steps.
#[derive(Debug, Clone, PartialEq)]
pub struct SchemeSeries {
    /// Where.
    pub place: Place,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// ln(V_peak/V_l) of our limit cycle.
    pub log_peak: f64,
    /// By step, in the order of the scene.
    pub steps: Vec<SchemeStep>,
    /// Order of convergence from the three finest steps, and its error; none without three runs whose step halves.
    pub order: Option<(f64, f64)>,
}

/// What the scheme does.
#[derive(Debug, Clone, PartialEq)]
pub struct OriginalSchemeOutcome {
    /// Bias of the long-term peak, place by place and law by law.
    pub series: Vec<SchemeSeries>,
    /// The scheme's critical stiffness, velocity by velocity of the map and step by step.
    pub transition: Vec<SchemeTransition>,
    /// The points of fig 3a, step by step and law by law.
    pub map: Vec<SchemeMapRow>,
    /// The velocity of the least peak (fig 5).
    pub least_peaks: Vec<SchemeLeastPeak>,
}

impl SchemeStep {
    /// ln of the scheme's long-term peak over ours, with its spread; none without a run.
    #[must_use]
    pub fn bias(&self, log_peak: f64) -> Option<(f64, f64)> {
        let peak = self.peak.as_ref()?.as_ref().ok()?;
        Some((peak.log_peak - log_peak, peak.spread))
    }
}

/// Runs the scheme at every point of the section.
#[must_use]
pub fn original_scheme(
    parameters: &Slider<Rational>,
    section: &OriginalSchemeSection,
) -> OriginalSchemeOutcome {
    let fractions: Vec<f64> = section.steps.iter().map(nearest_f64).collect();
    let cases: Vec<(&Place, EvolutionLaw)> = section
        .places
        .iter()
        .flat_map(|place| EvolutionLaw::ALL.into_iter().map(move |law| (place, law)))
        .collect();
    OriginalSchemeOutcome {
        series: cases
            .par_iter()
            .filter_map(|&(place, law)| series(parameters, place, law, &fractions))
            .collect(),
        transition: transitions(parameters, &section.rectangle.loading_velocity_m_per_s, &fractions),
        map: map_rows(parameters, &section.rectangle, &fractions),
        least_peaks: least_peaks_of_scheme(parameters, &section.least_peak_stresses_pa, &fractions),
    }
}

fn series(
    parameters: &Slider<Rational>,
    place: &Place,
    law: EvolutionLaw,
    fractions: &[f64],
) -> Option<SchemeSeries> {
    let (velocity, stress) = (place.loading_velocity_m_per_s.clone(), place.normal_stress_pa.clone());
    let model = model_at(parameters, velocity, stress, law);
    let cycle = converged_cycle(&model)?;
    let steps: Vec<SchemeStep> = fractions
        .par_iter()
        .map(|&fraction| {
            let steps_needed = steps_needed(&model, &cycle, fraction);
            let affordable = steps_needed <= AFFORDABLE_STEPS;
            let peak = affordable.then(|| scheme_peak(&model, &cycle, fraction));
            SchemeStep { fraction, steps_needed, peak }
        })
        .collect();
    let order = order(&steps);
    Some(SchemeSeries { place: place.clone(), law, log_peak: cycle.orbit.peak, steps, order })
}

/// The order from the differences of three peaks whose steps halve; it does not use our converged value.
///
/// Its error adds what the spreads of the peaks allow and the distance from the order of the next coarser three.
fn order(steps: &[SchemeStep]) -> Option<(f64, f64)> {
    let found: Vec<(f64, SchemePeak)> =
        steps.iter().filter_map(|step| Some((step.fraction, *step.peak.as_ref()?.as_ref().ok()?))).collect();
    let orders: Vec<(f64, f64)> = found
        .windows(3)
        .filter_map(|three| {
            let [(h1, p1), (h2, p2), (h3, p3)] = [three[0], three[1], three[2]];
            let halves = |a: f64, b: f64| (a / b - 2.0).abs() < 1e-9;
            let (coarse, fine) = (p1.log_peak - p2.log_peak, p2.log_peak - p3.log_peak);
            let known = (p1.spread + p2.spread) / coarse.abs() + (p2.spread + p3.spread) / fine.abs();
            (halves(h1, h2) && halves(h2, h3) && coarse / fine > 0.0)
                .then(|| (libm::log2(coarse / fine), known / std::f64::consts::LN_2))
        })
        .collect();
    let [.., (coarser, _), (order, known)] = orders[..] else { return None };
    Some((order, known + (order - coarser).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::number::parse_decimal;

    #[test]
    fn the_scheme_is_of_first_order_and_its_bias_does_not_vanish_at_the_advised_step() {
        let decimal = |text| parse_decimal(text).unwrap();
        let place = Place { loading_velocity_m_per_s: decimal("1e-3"), normal_stress_pa: decimal("1e5") };
        for law in EvolutionLaw::ALL {
            let found = series(&paper(), &place, law, &[0.1, 0.05, 0.025, 0.0125]).unwrap();
            let (order, error) = found.order.unwrap();
            assert!((order - 1.0).abs() < 2.0 * error && error < 0.1, "{law:?}: {order} {error}");
            let (bias, spread) = found.steps[0].bias(found.log_peak).unwrap();
            assert!(bias > 0.01 && spread < 0.1 * bias, "{law:?}: {bias} {spread}");
        }
    }

    #[test]
    fn a_run_of_deep_stick_slip_is_counted_and_not_made() {
        let decimal = |text| parse_decimal(text).unwrap();
        let place = Place { loading_velocity_m_per_s: decimal("1e-6"), normal_stress_pa: decimal("1e7") };
        let found = series(&paper(), &place, EvolutionLaw::Slip, &[0.1]).unwrap();
        assert!(found.steps[0].peak.is_none() && found.steps[0].steps_needed > 1e8);
    }
}
