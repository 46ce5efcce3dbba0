//! The figure of the mismatch over the amplitude.

use crate::experiments::linear_regime::{Mismatch, ModeRuns};
use crate::experiments::{Figure, FigureMaker, Need, Outcome, SceneOutcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};

pub(crate) const FIGURES: &[FigureMaker] = &[FigureMaker::new(
    "small-disturbances",
    &[Need::LinearRegime],
    &["linear-regime", "linear-regime-extremes"],
    mismatch_chart,
)];

pub(crate) fn runs_of(scene: &SceneOutcome) -> impl Iterator<Item = &ModeRuns> {
    scene.linear_regime.iter().flat_map(|outcome| &outcome.runs).filter_map(|run| run.as_ref().ok())
}

const DESCRIPTION: &str = "Relative mismatch between the rate of a small disturbance and the root of the cubic, against the size of the disturbance, on logarithmic axes. Four series, the starts with the largest and smallest constant under each evolution law, follow straight lines of slope one over eight decades. The largest constants of the two laws nearly coincide. Only the smallest mismatches reach the rounding level of 64-bit runs.";
const CAPTION: &str = "Relative mismatch between the measured rate of a small disturbance and the certified root, against the size of the disturbance: for each law, the starts with the largest and the smallest predicted constant of all points. The nonlinear runs are in double-double. All lines have slope 1, as the quadratic terms require; the lines of other starts lie between them. The grey line is the largest difference of a 64-bit run at the smallest amplitude.";

fn mismatch_chart(outcome: &Outcome) -> Option<Figure> {
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
    let caption =
        Caption::new("small-disturbances", "Mismatch with the roots against amplitude", DESCRIPTION);
    let chart = LineChart {
        caption,
        x: Axis::log10("Amplitude of the start", "", least, most),
        y: Axis::log10("|*p*_m − *p*| / |*p*|", "", decade(lowest, libm::floor), decade(highest, libm::ceil)),
        series,
        references: vec![Reference::Horizontal { at: floor, label: "rounding of 64-bit runs".into() }],
    };
    (least < most && floor > 0.0).then(|| Figure::own(&chart.caption, CAPTION, chart.svg()))
}

fn measured(label: &str, run: &ModeRuns) -> Series {
    let point = |mismatch: &Mismatch| (mismatch.amplitude, mismatch.size());
    let points = run.mismatches.iter().map(point).collect();
    Series::marked(label, points)
}
