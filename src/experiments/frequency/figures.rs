//! Frequencies along lines of constant normal stress (fig 2).

use crate::experiments::frequency::{FrequencyLine, FrequencyOutcome};
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use slipmode_core::friction::Slider;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};

pub(crate) const FIGURES: &[FigureMaker] =
    &[FigureMaker::new("fig-2", &[Need::Frequency], &["frequency"], |outcome| {
        frequency_lines(outcome.potentially_unstable()?)
    })];

const DESCRIPTION: &str = "Largest imaginary part against loading velocity at constant normal stresses, on logarithmic axes. At the critical normal stress it follows eq 23 at low velocity and approaches the natural frequency at high velocity. The frequency is zero in the gaps of a line.";
const CAPTION: &str = "Largest imaginary part along lines of constant normal stress (compare fig 2 of the paper), with eq 23 and the natural angular frequency. In the gaps of a line all roots are real.";

fn frequency_lines(scene: &SceneOutcome) -> Option<Figure> {
    let (parameters, outcome) = (scene.slider()?, scene.frequency.as_ref()?);
    let velocities = &outcome.loading_velocity_m_per_s;
    let (first, last) = (*velocities.first()?, *velocities.last()?);
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    let mut series: Vec<Series> = outcome.lines.iter().map(|line| line_series(outcome, line)).collect();
    series.push(crossing_series(parameters, natural, first, last));
    let chart = LineChart {
        caption: Caption::new("fig-2", "Largest imaginary part at constant normal stress", DESCRIPTION),
        x: Axis::log10("Loading velocity *V*_0", "m/s", first, last),
        y: Axis::log10("max Im(*s*)", "1/s", natural * 1e-4, natural * 3.0),
        series,
        references: vec![Reference::Horizontal { at: natural, label: "*ω*_n = √(*K*/*M*)".into() }],
    };
    Some(Figure::new(&chart.caption, "Figure 2", CAPTION, chart.svg()))
}

fn line_series(outcome: &FrequencyOutcome, line: &FrequencyLine) -> Series {
    let ratio = &line.normal_stress_over_critical;
    let label = if *ratio.denom() == 1 { ratio.numer().to_string() } else { rational_to_decimal(ratio, 4) };
    let points = outcome
        .loading_velocity_m_per_s
        .iter()
        .zip(&line.max_imaginary_per_s)
        .map(|(velocity, imaginary)| (*velocity, imaginary.to_f64().unwrap_or(0.0)))
        .collect();
    Series::line(format!("*σ* = {label} *σ*_c"), points)
}

/// Eq 23, drawn up to three times the natural frequency.
fn crossing_series(parameters: &Slider<Rational>, natural: f64, first: f64, last: f64) -> Series {
    let enclosed = parameters.map(|value| Ball::from_rational(value, 128));
    let per_metre = enclosed.transition_angular_frequency_over_velocity_per_m().to_f64();
    let end = last.min(natural * 3.0 / per_metre);
    Series::of_theory("eq 23", vec![(first, first * per_metre), (end, end * per_metre)])
}
