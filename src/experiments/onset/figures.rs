//! Runs on either side of the onset of oscillation, with the velocities of theory (fig 4).

use crate::experiments::onset::ShownRun;
use crate::experiments::{Drawer, Outcome, Words};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{LineChart, Series};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-4a", |outcome, words| runs(outcome, 0, words)),
    ("fig-4b", |outcome, words| runs(outcome, 1, words)),
];

fn runs(outcome: &Outcome, index: usize, words: &mut Words) -> Option<String> {
    let scene = outcome.potentially_unstable()?;
    let found = scene.onset.as_ref()?;
    let mut lines = found.lines.iter().filter(|line| line.asymptote == Asymptote::InertialLower);
    let line = lines.nth(index)?;
    let until = line.shown.iter().filter_map(|run| run.history.last()).map(|last| last.0).fold(0.0, f64::max);
    let stress = round_digits(nearest_f64(&line.normal_stress_pa), 4);
    let exact =
        round_digits(line.boundary_velocity_m_per_s.to_f64() / line.asymptote_velocity_m_per_s.to_f64(), 5);
    let highest = line.shown.iter().flat_map(|run| &run.history).map(|sample| sample.1).fold(1.0, f64::max);
    let seen = line.seen.first().and_then(|seen| seen.second_rise).map_or("never".into(), |found| {
        round_digits(found.value / line.asymptote_velocity_m_per_s.to_f64(), 4)
    });
    let law = line.seen.first().map_or("", |seen| seen.law.as_str());
    let (count, visible) = (line.shown.len().to_string(), round_digits(nearest_f64(&found.visible), 3));
    words.fill(&[("stress", &stress), ("law", law), ("count", &count), ("exact", &exact), ("seen", &seen)]);
    words.fill(&[("visible", &visible)]);
    let mut chart: LineChart = words.drawing()?;
    (chart.x.max, chart.y.max) = (until, (5.0 * highest).ceil() / 5.0);
    chart.series =
        line.shown.iter().map(series).chain(line.at_boundary.as_ref().map(boundary_series)).collect();
    (!line.shown.is_empty()).then(|| chart.svg())
}

fn series(run: &ShownRun) -> Series {
    let ratio = round_digits(run.velocity_over_asymptote, 3);
    let side = if run.oscillates { "complex pair" } else { "real roots" };
    Series::line(format!("*V*_l = {ratio} *V*_{{20}} ({side})"), run.history.clone())
}

/// The run at the boundary as the theory line among the others.
fn boundary_series(run: &ShownRun) -> Series {
    let ratio = round_digits(run.velocity_over_asymptote, 4);
    Series::of_theory(format!("exact boundary, *V*_l = {ratio} *V*_{{20}}"), run.history.clone())
}
