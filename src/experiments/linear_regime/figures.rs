//! The figure of the mismatch over the amplitude.

use crate::experiments::described::with_points;
use crate::experiments::linear_regime::ModeRuns;
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::figure::Reference;

pub(crate) const FIGURES: &[Drawer] =
    &[("small-disturbances", |outcome, words| mismatch_chart(outcome, words))];

pub(crate) fn runs_of(scene: &SceneOutcome) -> impl Iterator<Item = &ModeRuns> {
    scene.linear_regime.iter().flat_map(|outcome| &outcome.runs).filter_map(|run| run.as_ref().ok())
}

fn mismatch_chart(outcome: &Outcome, words: &Words) -> Option<String> {
    let all: Vec<&ModeRuns> = outcome.scenes.iter().flat_map(runs_of).collect();
    let lines = [EvolutionLaw::Slip, EvolutionLaw::Aging].into_iter().flat_map(|law| {
        let mut runs: Vec<&ModeRuns> = all.iter().copied().filter(|run| run.law == law).collect();
        runs.sort_by(|a, b| b.coefficient.total_cmp(&a.coefficient));
        [runs.first(), runs.last()].map(|run| run.map_or_else(Vec::new, |run| places(run)))
    });
    let mut chart = with_points(words.drawing()?, lines)?;
    chart.series.retain(|series| !series.points.is_empty());
    let floor = all.iter().map(|run| run.difference_of_64_bit).fold(0.0, f64::max);
    let decade = |value: f64, round: fn(f64) -> f64| libm::exp10(round(libm::log10(value)));
    let (low, high) = (decade(chart.y.min.min(floor), libm::floor), decade(chart.y.max, libm::ceil));
    (chart.y.min, chart.y.max) = (low, high);
    chart.references.push(Reference::Horizontal { at: floor, label: "rounding of 64-bit runs".into() });
    (chart.x.min < chart.x.max && floor > 0.0).then(|| chart.svg())
}

fn places(run: &ModeRuns) -> Vec<(f64, f64)> {
    run.mismatches.iter().map(|mismatch| (mismatch.amplitude, mismatch.size())).collect()
}
