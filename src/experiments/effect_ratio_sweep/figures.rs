//! The figure of the asymptotes' largest errors.

use crate::experiments::effect_ratio_sweep::{SweepOutcome, SweepRow};
use crate::experiments::{Drawer, Words};
use crate::scene::cited;
use slipmode_core::number::{Ball, nearest_f64};
use slipmode_plot::figure::{Axis, LineChart, Reference, Series};

pub(crate) const FIGURES: &[Drawer] = &[("corners", |outcome, words| {
    worst_errors(outcome.scenes.iter().find_map(|scene| scene.effect_ratio_sweep.as_ref())?, words)
})];

fn worst_errors(sweep: &SweepOutcome, words: &Words) -> Option<String> {
    let (first, last) = (sweep.rows.first()?, sweep.rows.last()?);
    let line = |label: &str, value: &dyn Fn(&SweepRow) -> Option<&Ball>| {
        Series::line(
            label,
            sweep
                .rows
                .iter()
                .map(|row| (nearest_f64(&row.effect_ratio), value(row).map_or(f64::NAN, Ball::to_f64)))
                .collect(),
        )
    };
    let chart = LineChart {
        caption: words.caption.clone(),
        x: Axis::log10(
            "*β* = *b*/*a*",
            "",
            nearest_f64(&first.effect_ratio),
            nearest_f64(&last.effect_ratio),
        ),
        y: Axis::linear("Largest log10 distance from the nearer asymptote", "", 0.0, 0.5),
        series: vec![
            line(&cited("upper arc ({quasi-static-upper, inertial-upper})"), &|row| {
                row.errors.upper_worst_log10.as_ref()
            }),
            line(&cited("lower arc ({quasi-static-lower, inertial-lower})"), &|row| {
                Some(&row.errors.lower_worst_log10)
            }),
        ],
        references: vec![Reference::Vertical { at: 1.0, label: "*a* = *b*".into() }],
    };
    Some(chart.svg())
}
