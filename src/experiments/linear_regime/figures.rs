//! The figure of the mismatch over the amplitude.

use crate::experiments::linear_regime::{Mismatch, ModeRuns};
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::figure::{Axis, LineChart, Reference, Series};

pub(crate) const FIGURES: &[Drawer] =
    &[("small-disturbances", |outcome, words| mismatch_chart(outcome, words))];

pub(crate) fn runs_of(scene: &SceneOutcome) -> impl Iterator<Item = &ModeRuns> {
    scene.linear_regime.iter().flat_map(|outcome| &outcome.runs).filter_map(|run| run.as_ref().ok())
}

fn mismatch_chart(outcome: &Outcome, words: &Words) -> Option<String> {
    let all: Vec<&ModeRuns> = outcome.scenes.iter().flat_map(runs_of).collect();
    let mut series = Vec::new();
    for law in [EvolutionLaw::Slip, EvolutionLaw::Aging] {
        let mut runs: Vec<&ModeRuns> = all.iter().copied().filter(|run| run.law == law).collect();
        runs.sort_by(|a, b| b.coefficient.total_cmp(&a.coefficient));
        for (run, which) in [(runs.first(), "largest"), (runs.last(), "smallest")] {
            series.extend(run.map(|run| measured(&format!("{} law, {which} constant", law.as_str()), run)));
        }
    }
    let amplitudes = all.iter().flat_map(|run| &run.mismatches).map(|mismatch| mismatch.amplitude);
    let (least, most) =
        amplitudes.fold((f64::INFINITY, 0.0f64), |(least, most), a| (least.min(a), most.max(a)));
    let floor = all.iter().map(|run| run.difference_of_64_bit).fold(0.0, f64::max);
    let decade = |value: f64, round: fn(f64) -> f64| libm::exp10(round(libm::log10(value)));
    let highest = series.iter().flat_map(|s| &s.points).map(|point| point.1).fold(0.0, f64::max);
    let lowest = series.iter().flat_map(|s| &s.points).map(|point| point.1).fold(floor, f64::min);
    let chart = LineChart {
        caption: words.caption.clone(),
        x: Axis::log10("Amplitude of the start", "", least, most),
        y: Axis::log10("|*p*_m − *p*| / |*p*|", "", decade(lowest, libm::floor), decade(highest, libm::ceil)),
        series,
        references: vec![Reference::Horizontal { at: floor, label: "rounding of 64-bit runs".into() }],
    };
    (least < most && floor > 0.0).then(|| chart.svg())
}

fn measured(label: &str, run: &ModeRuns) -> Series {
    let point = |mismatch: &Mismatch| (mismatch.amplitude, mismatch.size());
    let points = run.mismatches.iter().map(point).collect();
    Series::marked(label, points)
}
