//! The fixed-step scheme of the original simulations: bias of the long-term peak, order, and what becomes of figs 3a and 5.

use rayon::prelude::*;

use super::least_peak::{SchemeLeastPeak, least_peaks_of_scheme};
use super::long_term::{AFFORDABLE_STEPS, SchemePeak, converged_cycle, scheme_peak, steps_needed};
use super::stability::{SchemeMapRow, SchemeTransition, map_rows, transitions};
use crate::paper::{decimal, model_at, paper, place};
use slipmode::scene::{LogAxis, PlanePoint, Rectangle};
use slipmode_core::dynamics::Failure;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::Rational;

/// What is asked of the scheme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Where the bias of the long-term peak is followed through the steps: V_l in m/s and σ in Pa, as written.
    pub places: &'static [[&'static str; 2]],
    /// Steps in units of √(M/K).
    pub steps: &'static [f64],
    /// Velocities and stresses of the points of fig 3a at which stability and peak are looked at.
    pub map_points: [u32; 2],
    /// Normal stresses at which the velocity of the least peak is looked for, Pa.
    pub least_peak_stresses_pa: &'static [f64],
}

impl Asked {
    /// What the report on the paper shows. At the last two places (stick-slip) a fixed step is too expensive: the steps are
    /// counted, not run.
    pub const REPORTED: Self = Self {
        places: &[
            ["1e-3", "1e5"],
            ["1e-4", "1e5"],
            ["1e-2", "1e5"],
            ["1e-2", "3.1622776601683795e5"],
            ["1e-2", "1e6"],
            ["3.1622776601683795e-2", "1e4"],
            ["1e-5", "1e5"],
            ["3.1622776601683795e-6", "3.1622776601683795e6"],
        ],
        steps: &[0.2, 0.1, 0.05, 0.025, 0.0125],
        map_points: [7, 3],
        least_peak_stresses_pa: &[1e5, 3.1622776601683795e5, 1e6],
    };

    /// The points of fig 3a: 1e-4 to 1e-1 m/s by 1e4 to 1e6 Pa.
    fn rectangle(&self) -> Rectangle {
        let axis = |[from, to]: [&str; 2], points| LogAxis { from: decimal(from), to: decimal(to), points };
        let [velocities, stresses] = self.map_points;
        Rectangle {
            loading_velocity_m_per_s: axis(["1e-4", "1e-1"], velocities),
            normal_stress_pa: axis(["1e4", "1e6"], stresses),
        }
    }
}

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
    pub place: PlanePoint,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// ln(V_peak/V_l) of our limit cycle.
    pub log_peak: f64,
    /// By step, in the order that was asked.
    pub steps: Vec<SchemeStep>,
    /// Order of convergence from the three finest steps, and its error; none without three runs whose step halves.
    pub order: Option<(f64, f64)>,
}

/// What the scheme does.
#[derive(Debug, Clone, PartialEq)]
pub struct SchemeOutcome {
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

/// Runs the scheme with the paper's slider.
#[must_use]
pub fn original_scheme(asked: &Asked) -> SchemeOutcome {
    let (parameters, rectangle) = (&paper(), asked.rectangle());
    let places = asked.places.iter().map(|&written| place(written));
    let cases: Vec<(PlanePoint, EvolutionLaw)> =
        places.flat_map(|place| EvolutionLaw::ALL.map(|law| (place.clone(), law))).collect();
    let along = |(place, law): &(PlanePoint, EvolutionLaw)| series(parameters, place, *law, asked.steps);
    SchemeOutcome {
        series: cases.par_iter().filter_map(along).collect(),
        transition: transitions(parameters, &rectangle.loading_velocity_m_per_s, asked.steps),
        map: map_rows(parameters, &rectangle, asked.steps),
        least_peaks: least_peaks_of_scheme(parameters, asked.least_peak_stresses_pa, asked.steps),
    }
}

fn series(
    parameters: &Slider<Rational>,
    place: &PlanePoint,
    law: EvolutionLaw,
    fractions: &[f64],
) -> Option<SchemeSeries> {
    let model = model_at(parameters, place, law);
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

    #[test]
    fn the_scheme_is_of_first_order_and_its_bias_does_not_vanish_at_the_advised_step() {
        let place = place(["1e-3", "1e5"]);
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
        let place = place(["1e-6", "1e7"]);
        let found = series(&paper(), &place, EvolutionLaw::Slip, &[0.1]).unwrap();
        assert!(found.steps[0].peak.is_none() && found.steps[0].steps_needed > 1e8);
    }
}
