//! Figures of a fit: the record with its model and residuals, and the profiles of the values.

use super::run::FitOutcome;
use crate::experiments::described::{extent, over, with_points};
use crate::experiments::{Drawer, Outcome, Words, figure_makers};
use crate::fitting::{Estimate, Fit, Fits, Parameter, StepRecord, slider};
use slipmode_core::dynamics::{DrivenControl, DrivenSlider, Piece, drive};
use slipmode_plot::figure::{LineChart, Panel, Panels, Reference};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fit-record", |outcome, words| {
        let (_, found) = fitted(outcome)?;
        record_panels(&found.record, found.fits.as_ref().ok()?, words)
    }),
    ("fit-step", |outcome, words| {
        let (fit, found) = fitted(outcome)?;
        step_chart(fit, &found.record, words)
    }),
    ("fit-profiles", |outcome, words| {
        let (fit, _) = fitted(outcome)?;
        words.panels(fit.estimates.iter().filter_map(|estimate| profile_panel(words, estimate)))
    }),
];

/// Places along the axis at which the least and the largest sample are drawn, where there are more samples.
const PLACES: usize = 700;

fn fitted(outcome: &Outcome) -> Option<(&Fit, &FitOutcome)> {
    outcome.each(|scene| &scene.fit).find_map(|(_, found)| Some((&found.fits.as_ref().ok()?.best, found)))
}

/// The record with its fit, and the residuals, as SVG.
pub(crate) fn fit_picture(record: &StepRecord, fits: &Fits) -> String {
    let maker = figure_makers().find(|maker| maker.id == "fit-record");
    maker.and_then(|maker| record_panels(record, fits, &mut maker.words())).unwrap_or_default()
}

fn record_panels(record: &StepRecord, fits: &Fits, words: &mut Words) -> Option<String> {
    let fit = &fits.best;
    let (unit, size) = length_unit(record.displacements_m.last().copied().unwrap_or_default());
    let ways = || record.displacements_m.iter().map(|way| way / size);
    let fitted: Vec<f64> = fit.fitted(record).collect();
    let residuals: Vec<f64> = fit.differences.iter().map(|difference| -difference).collect();
    words.fill(&[("unit", unit), ("law", fit.given.law.as_str())]);
    let mut panels: Panels = words.drawing()?;
    for (panel, lines) in panels.panels.iter_mut().zip([vec![&record.frictions, &fitted], vec![&residuals]]) {
        (panel.x.min, panel.x.max) = extent(ways())?;
        panel.y = over(&panel.y, lines[0].iter().copied())?;
        for (series, values) in panel.series.iter_mut().zip(lines) {
            series.points = thinned(&ways().zip(values.iter().copied()).collect::<Vec<_>>());
        }
    }
    let deviation = fit.residuals.standard_deviation;
    let across = [-deviation, 0.0, deviation].map(|at| Reference::Horizontal { at, label: String::new() });
    panels.panels.last_mut()?.references = across.into();
    Some(panels.svg())
}

/// The unit in which a displacement has few digits, and its size in m.
fn length_unit(largest: f64) -> (&'static str, f64) {
    if largest.abs() < 2e-3 { ("µm", 1e-6) } else { ("mm", 1e-3) }
}

/// At each place along the axis the least and the largest value, in the order of the samples.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= 2 * PLACES {
        return points.to_vec();
    }
    let ends = |part: &[(f64, f64)]| {
        let by = |one: &&(f64, f64), other: &&(f64, f64)| one.1.total_cmp(&other.1);
        let mut ends: Vec<(f64, f64)> =
            [part.iter().min_by(by), part.iter().max_by(by)].into_iter().flatten().copied().collect();
        ends.sort_by(|one, other| one.0.total_cmp(&other.0));
        ends
    };
    points.chunks(points.len().div_ceil(PLACES)).flat_map(ends).collect()
}

/// The velocity behind the step over that before it, the slip shown before and after it in D_c, and the samples.
const STEP: f64 = 10.0;
const SHOWN: [f64; 2] = [1.0, 7.0];
const STEP_SAMPLES: u32 = 400;
/// Stiffness of the machine in a σ/D_c: the peak is lower than a ln 10 by less than a line is wide.
const STIFF: f64 = 3e3;

/// A step of velocity with what a, b and D_c do to the friction.
fn step_chart(fit: &Fit, record: &StepRecord, words: &mut Words) -> Option<String> {
    let fitted = slider(&fit.point, None, fit.given.law);
    let (a, b, distance) = (fitted.direct_effect, fitted.evolution_effect, fitted.critical_slip_distance_m);
    let stiffness_pa_per_m = STIFF * a * record.normal_stress_pa / distance;
    let velocity = record.reference_velocity_m_per_s();
    let before_s = SHOWN[0] * distance / velocity;
    let piece = |until_s: f64, load_point_velocity_m_per_s: f64| Piece {
        until_s,
        load_point_velocity_m_per_s,
        normal_stress_pa: record.normal_stress_pa,
    };
    let end_s = before_s + SHOWN[1] * distance / (STEP * velocity);
    let pieces = [piece(before_s, velocity), piece(end_s, STEP * velocity)];
    // Evenly spaced in displacement after the step.
    let after = (0..=STEP_SAMPLES).map(|i| f64::from(i) / f64::from(STEP_SAMPLES));
    let times: Vec<f64> =
        [0.0].into_iter().chain(after.map(|part| before_s + (end_s - before_s) * part * part)).collect();
    let control = DrivenControl { local_tolerance: 1e-6, most_steps: 10_000, with_derivatives: false };
    let driven = drive(&DrivenSlider { stiffness_pa_per_m, ..fitted }, &pieces, &times, control).ok()?;
    let (unit, size) = length_unit(SHOWN[1] * distance);
    let place =
        |time: f64| if time < before_s { -SHOWN[0] * distance } else { (time - before_s) * STEP * velocity };
    let points =
        times.iter().zip(&driven).map(|(time, driven)| (place(*time) / size, driven.friction)).collect();
    let decade = std::f64::consts::LN_10;
    let level = |change: f64, label: &str| Reference::Horizontal {
        at: fitted.reference_friction + change * decade,
        label: label.into(),
    };
    let levels =
        [level(0.0, "*μ*_0"), level(a, "*μ*_0 + *a* ln 10"), level(a - b, "*μ*_0 + (*a* − *b*) ln 10")];
    // Above the peak is room for its label.
    let heights = [0.0, 1.1 * a * decade, (a - b) * decade].map(|change| fitted.reference_friction + change);
    let along = Reference::Vertical { at: distance / size, label: "*D*_c".into() };
    words.fill(&[("unit", unit), ("law", fit.given.law.as_str())]);
    let mut chart: LineChart = words.drawing()?;
    (chart.x.min, chart.x.max) = (-SHOWN[0] * distance / size, SHOWN[1] * distance / size);
    chart.y = over(&chart.y, heights)?;
    chart.references = levels.into_iter().chain([along]).collect();
    Some(with_points(chart, [points])?.svg())
}

fn profile_panel(words: &Words, estimate: &Estimate) -> Option<Panel> {
    let (unit, size) = unit_of(estimate);
    let points: Vec<(f64, f64)> =
        estimate.profile.iter().map(|point| (point.value / size, point.distance)).collect();
    let symbol = estimate.parameter.symbol().replace("mu", "μ");
    let mut panel = words.panel(&[("symbol", &symbol), ("unit", unit)])?;
    let ends = [-estimate.half_width, estimate.half_width];
    panel.x = over(&panel.x, points.iter().map(|point| point.0))?;
    panel.y = over(&panel.y, points.iter().map(|point| point.1).chain(ends))?;
    panel.series.iter_mut().for_each(|series| series.points.clone_from(&points));
    panel.references = ends.map(|at| Reference::Horizontal { at, label: String::new() }).into();
    Some(panel)
}

/// The unit in which a value has few digits, and its size in SI.
fn unit_of(estimate: &Estimate) -> (&'static str, f64) {
    match estimate.parameter {
        Parameter::CriticalSlipDistance => length_unit(estimate.value),
        Parameter::Stiffness if estimate.value < 1e9 => ("MPa/m", 1e6),
        Parameter::Stiffness => ("GPa/m", 1e9),
        parameter => (parameter.unit(), 1.0),
    }
}
