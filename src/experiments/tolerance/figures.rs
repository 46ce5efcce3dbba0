//! The figure of where the asymptotes' errors are small enough.

use crate::experiments::tolerance::{ToleranceOutcome, ToleranceRow};
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{RangeChart, Span};

pub(crate) const FIGURES: &[Drawer] =
    &[("tolerance", |outcome, words| good_enough(outcome.potentially_unstable()?, words))];

fn good_enough(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.tolerance.as_ref()?;
    let mut tolerances: Vec<&Rational> = outcome.rows.iter().map(|row| &row.tolerance).collect();
    tolerances.sort();
    tolerances.dedup();
    tolerances.reverse();
    // D_c √(K/M), m/s: the velocity at which η/κ = 1.
    let slider = scene.slider()?.map(nearest_f64);
    let scale = slider.critical_slip_distance_m * slider.natural_angular_frequency_per_s();
    let mut chart: RangeChart = words.drawing()?;
    (chart.axis.min, chart.axis.max) = (scale * 1e-4, scale * 1e4);
    let percent = |tolerance: &&Rational| rational_to_decimal(&Rational::from(*tolerance * 100u32), 4);
    chart.levels = tolerances.iter().map(|tolerance| format!("within {} %", percent(tolerance))).collect();
    for (row, asymptote) in chart.rows.iter_mut().zip(Asymptote::ALL) {
        row.spans = spans(outcome, asymptote, &tolerances, scale);
    }
    Some(chart.svg())
}

fn spans(
    outcome: &ToleranceOutcome,
    asymptote: Asymptote,
    tolerances: &[&Rational],
    scale: f64,
) -> Vec<Span> {
    let rows = outcome.rows.iter().filter(|row| row.limit.asymptote == asymptote);
    let span = |row: &ToleranceRow| {
        let velocity = row.limit.velocity_squared.to_f64().sqrt() * scale;
        let level = tolerances.iter().position(|tolerance| **tolerance == row.tolerance).unwrap_or(0);
        // Eqs 15, 16 and 20 hold towards low velocity along their arc, eq 18 towards high velocity.
        if asymptote == Asymptote::InertialUpper {
            Span { from: velocity, to: scale * 1e4, level }
        } else {
            Span { from: scale * 1e-4, to: velocity, level }
        }
    };
    rows.map(span).collect()
}
