//! The figure of where the asymptotes' errors are small enough.

use crate::experiments::boundary::figures::equation_label;
use crate::experiments::tolerance::ToleranceOutcome;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{Axis, RangeChart, RangeRow, Span};

pub(crate) const FIGURES: &[Drawer] =
    &[("tolerance", |outcome, words| good_enough(outcome.potentially_unstable()?, words))];

fn good_enough(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.tolerance.as_ref()?;
    let mut tolerances: Vec<&Rational> = outcome.rows.iter().map(|row| &row.tolerance).collect();
    tolerances.sort();
    tolerances.dedup();
    tolerances.reverse();
    let scale = velocity_scale(scene)?;
    let chart = RangeChart {
        caption: words.caption.clone(),
        axis: Axis::log10("Loading velocity *V*_0 on the boundary", "m/s", scale * 1e-4, scale * 1e4),
        levels: tolerances
            .iter()
            .map(|tolerance| {
                format!("within {} %", rational_to_decimal(&Rational::from(*tolerance * 100u32), 4))
            })
            .collect(),
        rows: Asymptote::ALL
            .into_iter()
            .map(|asymptote| range_row(outcome, asymptote, &tolerances, scale))
            .collect(),
    };
    Some(chart.svg())
}

/// D_c √(K/M), m/s: the velocity at which η/κ = 1.
fn velocity_scale(scene: &SceneOutcome) -> Option<f64> {
    let parameters = scene.slider()?;
    let natural = parameters.map(nearest_f64).natural_angular_frequency_per_s();
    Some(nearest_f64(&parameters.critical_slip_distance_m) * natural)
}

fn range_row(
    outcome: &ToleranceOutcome,
    asymptote: Asymptote,
    tolerances: &[&Rational],
    scale: f64,
) -> RangeRow {
    let spans = outcome
        .rows
        .iter()
        .filter(|row| row.limit.asymptote == asymptote)
        .map(|row| {
            let velocity = row.limit.velocity_squared.to_f64().sqrt() * scale;
            let level = tolerances.iter().position(|tolerance| **tolerance == row.tolerance).unwrap_or(0);
            // Eqs 15, 16 and 20 hold towards low velocity along their arc, eq 18 towards high velocity.
            if asymptote == Asymptote::InertialUpper {
                Span { from: velocity, to: scale * 1e4, level }
            } else {
                Span { from: scale * 1e-4, to: velocity, level }
            }
        })
        .collect();
    let detail = if asymptote.is_quasi_static() { "in normal stress" } else { "in velocity" };
    RangeRow { label: equation_label(asymptote), detail: detail.into(), spans }
}
