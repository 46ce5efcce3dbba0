//! Frequencies along lines of constant normal stress (fig 2).

use crate::experiments::described::with_points;
use crate::experiments::frequency::{FrequencyLine, FrequencyOutcome};
use crate::experiments::shared::axes::{axes, boundary_lines, transition_line};
use crate::experiments::{Drawer, SceneOutcome, Words};
use std::cmp::Ordering;

use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_plot::figure::{Inset, LineChart, Reference, Series};

pub(crate) const FIGURES: &[Drawer] =
    &[("fig-2", |outcome, words| frequency_lines(outcome.potentially_unstable()?, words))];

fn frequency_lines(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let (parameters, outcome) = (scene.slider()?, scene.frequency.as_ref()?);
    let velocities = &outcome.loading_velocity_m_per_s;
    let (first, last) = (*velocities.first()?, *velocities.last()?);
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    let lines = in_the_order_of_the_paper(outcome);
    let mut chart: LineChart = words.drawing()?;
    (chart.x.min, chart.x.max) = (first, last);
    (chart.y.min, chart.y.max) = (natural * 1e-4, natural * 3.0);
    let per_metre = parameters.map(|value| Ball::from_rational(value, 128));
    let per_metre = per_metre.transition_angular_frequency_over_velocity_per_m().to_f64();
    // Eq 23, drawn up to three times the natural frequency.
    let ends = [first, last.min(chart.y.max / per_metre)].map(|velocity| (velocity, velocity * per_metre));
    let mut chart = with_points(chart, [ends.to_vec()])?;
    chart.series.splice(..0, lines.iter().map(|line| line_series(outcome, line)));
    chart.references.push(Reference::Horizontal { at: natural, label: "*ω*_n = √(*K*/*M*)".into() });
    Some(chart.svg_with(inset(scene, &lines).as_ref()))
}

/// Normal stresses above the critical one, those below it, and the critical one: solid, dashed and dotted, as in the paper.
fn in_the_order_of_the_paper(outcome: &FrequencyOutcome) -> Vec<&FrequencyLine> {
    let mut lines: Vec<&FrequencyLine> = outcome.lines.iter().collect();
    lines.sort_by_key(|line| {
        [Ordering::Greater, Ordering::Less, Ordering::Equal]
            .iter()
            .position(|order| line.normal_stress_over_critical.cmp(&Rational::from(1)) == *order)
    });
    lines
}

/// Where the lines lie in the plane of velocity and normal stress, with the boundary and the transition.
fn inset(scene: &SceneOutcome, lines: &[&FrequencyLine]) -> Option<Inset> {
    let (x, y) = axes(scene.map.as_ref()?)?;
    let across = |line: &&FrequencyLine| {
        let stress = nearest_f64(&line.normal_stress_pa);
        Series::line("", vec![(x.min, stress), (x.max, stress)])
    };
    let series = lines.iter().map(across).collect();
    let mut curves = boundary_lines(&scene.boundary.as_ref()?.points);
    curves.extend(transition_line(scene.slider()?, &x, &y));
    Some(Inset { series, lines: curves, x, y })
}

fn line_series(outcome: &FrequencyOutcome, line: &FrequencyLine) -> Series {
    let ratio = &line.normal_stress_over_critical;
    let label = match (ratio.numer().to_u32(), ratio.denom().to_u32()) {
        (Some(1), Some(1)) => "*σ*_c".into(),
        (Some(1), Some(n)) => format!("*σ*_c/{n}"),
        (Some(n), Some(1)) => format!("{n} *σ*_c"),
        _ => format!("{} *σ*_c", rational_to_decimal(ratio, 4)),
    };
    let places = outcome.loading_velocity_m_per_s.iter().zip(&line.max_imaginary_per_s);
    let points = places.map(|(velocity, imaginary)| (*velocity, imaginary.to_f64().unwrap_or(0.0)));
    Series::line(format!("*σ* = {label}"), points.collect())
}
