//! Small disturbances of the nonlinear slider.

use crate::claims::check::Asked;
use crate::claims::{Evidence, Finding};
use crate::experiments::linear_regime::ModeRuns;
use crate::experiments::{Context, Outcome};
use crate::scene::cited;
use slipmode_core::number::format::round_digits;

pub(super) fn small_disturbances(context: &Context, _: Asked) -> Finding {
    let none = || Finding::not_checked("The report has no runs of small disturbances.");
    SmallDisturbances::of(context.outcome).map_or_else(none, |seen| seen.finding())
}

/// How far a measured mismatch may be from what the quadratic terms predict at the smallest amplitude: terms of third order change
/// it by a part in 10^6 there, and a rate that is not a root by more than the mismatch itself.
const UNEXPLAINED: f64 = 1e-3;

/// The runs of all scenes along the eigenvectors.
struct SmallDisturbances<'o> {
    runs: Vec<&'o ModeRuns>,
    failures: usize,
}

impl<'o> SmallDisturbances<'o> {
    fn of(outcome: &'o Outcome) -> Option<Self> {
        let all =
            || outcome.scenes.iter().filter_map(|scene| scene.linear_regime.as_ref()).flat_map(|o| &o.runs);
        let runs: Vec<&ModeRuns> = all().filter_map(|run| run.as_ref().ok()).collect();
        let failures = all().count() - runs.len();
        (!runs.is_empty()).then_some(Self { runs, failures })
    }

    fn largest(&self, value: impl Fn(&ModeRuns) -> Option<f64>) -> f64 {
        self.runs.iter().filter_map(|run| value(run)).fold(0.0, f64::max)
    }

    fn finding(&self) -> Finding {
        let amplitude = self.largest(|run| run.mismatches.last().map(|last| last.amplitude));
        let unexplained = self.largest(ModeRuns::off_prediction);
        let of_64_bit = self.largest(|run| Some(run.difference_of_64_bit));
        let quantity = "Largest |p_measured − p|/|p| of small disturbances of the nonlinear slider, all roots, both laws";
        Finding::from_evidence(Evidence::Simulation {
            quantity: quantity.into(),
            value: format!(
                "{} at amplitude {}; the quadratic terms do not explain {} of it",
                round_digits(self.largest(ModeRuns::least_mismatch), 2),
                round_digits(amplitude, 2),
                round_digits(unexplained, 1)
            ),
            error: format!("{} between 64-bit and double-double runs", round_digits(of_64_bit, 1)),
            runs: self.runs.len(),
        })
        .require(self.failures == 0, || format!("{} small disturbances have no result", self.failures))
        .require(unexplained < UNEXPLAINED, || {
            cited("the rate of a small disturbance of the nonlinear slider does not tend to the root of {characteristic}")
        })
    }
}
