//! The figure of the asymptotes' errors along the boundary.

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use crate::scene::cited;
use slipmode_core::number::Rational;
use slipmode_core::stability::boundary::ErrorPair;
use slipmode_core::stability::{ArcFrame, Asymptote};
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};

pub(crate) const FIGURES: &[FigureMaker] =
    &[FigureMaker::new("deviation", &[Need::Boundary], &["boundary"], |outcome| {
        along_arcs(outcome.potentially_unstable()?)
    })];

const ALONG: &str = "Signed relative error of each of the four asymptotes along the exact boundary, against the inertial parameter. Errors of {quasi-static-upper, quasi-static-lower} fall in proportion to the inertial parameter towards low velocity; those of {inertial-upper, inertial-lower} fall towards the other end of their arcs.";
const CAPTION: &str = "Signed relative error of each asymptote along its arc, for a < b: error of σ at the same velocity for {quasi-static-upper, quasi-static-lower}, error of V0 at the same normal stress for {inertial-upper, inertial-lower}. The lower arc turns back at the cusp.";

fn along_arcs(scene: &SceneOutcome) -> Option<Figure> {
    let outcome = scene.boundary.as_ref()?;
    let beta = scene.slider()?.effect_ratio();
    let caption =
        Caption::new("deviation", "Relative error of the asymptotes along the boundary", &cited(ALONG));
    let chart = LineChart {
        caption,
        x: Axis::log10("Inertial parameter *η* on the boundary", "", 1e-6, 1e6),
        y: Axis::signed_log10("exact/asymptote − 1", "", 1e-4, -1.0, 10.0),
        series: Asymptote::ALL.into_iter().map(|asymptote| error_series(outcome, &beta, asymptote)).collect(),
        references: vec![
            Reference::Horizontal { at: 0.01, label: "1 %".into() },
            Reference::Horizontal { at: -0.01, label: "−1 %".into() },
        ],
    };
    Some(Figure::own(&chart.caption, &cited(CAPTION), chart.svg()))
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
