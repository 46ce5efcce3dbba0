//! The figure of the asymptotes' errors along the boundary.

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::number::Rational;
use slipmode_core::stability::boundary::ErrorPair;
use slipmode_core::stability::{ArcFrame, Asymptote};
use slipmode_plot::figure::{Axis, LineChart, Reference, Series};

pub(crate) const FIGURES: &[Drawer] =
    &[("deviation", |outcome, words| along_arcs(outcome.potentially_unstable()?, words))];

fn along_arcs(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.boundary.as_ref()?;
    let beta = scene.slider()?.effect_ratio();
    let chart = LineChart {
        caption: words.caption.clone(),
        x: Axis::log10("Inertial parameter *η* on the boundary", "", 1e-6, 1e6),
        y: Axis::signed_log10("exact/asymptote − 1", "", 1e-4, -1.0, 10.0),
        series: Asymptote::ALL.into_iter().map(|asymptote| error_series(outcome, &beta, asymptote)).collect(),
        references: vec![
            Reference::Horizontal { at: 0.01, label: "1 %".into() },
            Reference::Horizontal { at: -0.01, label: "−1 %".into() },
        ],
    };
    Some(chart.svg())
}

fn error_series(outcome: &BoundaryOutcome, beta: &Rational, asymptote: Asymptote) -> Series {
    let frame = ArcFrame::of_rational(beta, 128);
    let points = outcome
        .points
        .iter()
        .filter(|point| point.arc == asymptote.arc())
        .map(|point| {
            let pair = ErrorPair::at(&frame, point.arc, &point.parameter);
            let error = if asymptote.is_quasi_static() { pair.quasi_static } else { pair.inertial };
            (point.groups.inertial_parameter.to_f64(), error.to_f64())
        })
        .collect();
    Series::line(equation_label(asymptote), points)
}

/// `eq 15` and so on.
pub(crate) fn equation_label(asymptote: Asymptote) -> String {
    asymptote.as_str().replace("eq", "eq ")
}
