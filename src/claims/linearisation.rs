//! Small disturbances of the nonlinear slider.

use crate::claims::check::Asked;
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::experiments::linear_regime::ModeRuns;
use crate::scene::cited;
use slipmode_core::number::format::round_digits;

/// How far a measured mismatch may be from what the quadratic terms predict at the smallest amplitude: terms of third order change
/// it by a part in 10^6 there, and a rate that is not a root by more than the mismatch itself.
const UNEXPLAINED: f64 = 1e-3;

/// The runs of all scenes along the eigenvectors.
pub(super) fn small_disturbances(context: &Context, _: Asked) -> Finding {
    let scenes = context.outcome.scenes.iter().filter_map(|scene| scene.linear_regime.as_ref());
    let (runs, failed): (Vec<_>, Vec<_>) =
        scenes.flat_map(|outcome| &outcome.runs).partition(|run| run.is_ok());
    let runs: Vec<&ModeRuns> = runs.into_iter().flatten().collect();
    if runs.is_empty() {
        return Finding::not_checked("The report has no runs of small disturbances.");
    }
    let largest =
        |value: fn(&ModeRuns) -> Option<f64>| runs.iter().filter_map(|run| value(run)).fold(0.0, f64::max);
    let amplitude = largest(|run| run.mismatches.last().map(|last| last.amplitude));
    let unexplained = largest(ModeRuns::off_prediction);
    let of_64_bit = largest(|run| Some(run.difference_of_64_bit));
    let quantity =
        "Largest |p_measured − p|/|p| of small disturbances of the nonlinear slider, all roots, both laws";
    Finding::from_evidence(Evidence::Simulation {
        quantity: quantity.into(),
        value: format!(
            "{} at amplitude {}; the quadratic terms do not explain {} of it",
            round_digits(largest(ModeRuns::least_mismatch), 2),
            round_digits(amplitude, 2),
            round_digits(unexplained, 1)
        ),
        error: format!("{} between 64-bit and double-double runs", round_digits(of_64_bit, 1)),
        runs: runs.len(),
    })
    .require(failed.is_empty(), || format!("{} small disturbances have no result", failed.len()))
    .require(unexplained < UNEXPLAINED, || {
        cited("the rate of a small disturbance of the nonlinear slider does not tend to the root of {characteristic}")
    })
}
