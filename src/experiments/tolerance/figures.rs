//! Figures of the asymptotes' errors: along the arcs, at the corners, and where they are small enough.

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::effect_ratio_sweep::SweepOutcome;
use crate::experiments::tolerance::ToleranceOutcome;
use crate::experiments::{Figure, FigureMaker};
use crate::experiments::{Need, SceneOutcome};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::boundary::ErrorPair;
use slipmode_plot::figure::{Axis, Caption, LineChart, RangeChart, RangeRow, Reference, Series, Span};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        id: "deviation",
        needs: &[Need::Boundary],
        data: &["boundary"],
        make: |outcome| along_arcs(outcome.potentially_unstable()?),
    },
    FigureMaker {
        id: "corners",
        needs: &[Need::EffectRatioSweep],
        data: &["corners"],
        make: |outcome| {
            worst_errors(outcome.scenes.iter().find_map(|scene| scene.effect_ratio_sweep.as_ref())?)
        },
    },
    FigureMaker {
        id: "tolerance",
        needs: &[Need::Tolerance],
        data: &["tolerance", "convergence"],
        make: |outcome| good_enough(outcome.potentially_unstable()?),
    },
];

const ALONG: &str = "Signed relative error of each of the four asymptotes along the exact boundary, against the inertial parameter. Errors of eqs 15 and 16 fall in proportion to the inertial parameter towards low velocity; those of eqs 18 and 20 fall towards the other end of their arcs.";

fn along_arcs(scene: &SceneOutcome) -> Option<Figure> {
    let outcome = scene.boundary.as_ref()?;
    let beta = scene.slider()?.effect_ratio();
    let caption = Caption::new("deviation", "Relative error of the asymptotes along the boundary", ALONG);
    let chart = LineChart {
        caption: caption.clone(),
        x: Axis::log10("Inertial parameter *η* on the boundary", "", 1e-6, 1e6),
        y: Axis::signed_log10("exact/asymptote − 1", "", 1e-4, -1.0, 10.0),
        series: Asymptote::ALL.into_iter().map(|asymptote| error_series(outcome, &beta, asymptote)).collect(),
        references: vec![
            Reference::Horizontal { at: 0.01, label: "1 %".into() },
            Reference::Horizontal { at: -0.01, label: "−1 %".into() },
        ],
        bands: Vec::new(),
        labels: Vec::new(),
    };
    Some(Figure::new(
        caption,
        "Figure A1",
        "Signed relative error of each asymptote along its arc, for a < b: error of σ at the same velocity for eqs 15 and 16, error of V0 at the same normal stress for eqs 18 and 20. The lower arc turns back at the cusp.",
        chart.svg(),
    ))
}

fn error_series(outcome: &BoundaryOutcome, beta: &Rational, asymptote: Asymptote) -> Series {
    let frame = slipmode_core::stability::ArcFrame::of_rational(beta, 128);
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
    Series { label: equation_label(asymptote), points, marked: false, theory: false }
}

fn equation_label(asymptote: Asymptote) -> String {
    asymptote.as_str().replace("eq", "eq ")
}

const WORST: &str = "Largest error of the asymptotes against the ratio of evolution to direct effect: the largest distance in log10 between the exact boundary and the nearer asymptote, for the upper and the lower arc.";

fn worst_errors(sweep: &SweepOutcome) -> Option<Figure> {
    let (first, last) = (sweep.rows.first()?, sweep.rows.last()?);
    let caption = Caption::new("corners", "Largest error of the asymptotes against b/a", WORST);
    let line =
        |label: &str, value: &dyn Fn(&crate::experiments::effect_ratio_sweep::SweepRow) -> Option<&Ball>| {
            Series {
                label: label.into(),
                points: sweep
                    .rows
                    .iter()
                    .map(|row| (row.effect_ratio.to_f64(), value(row).map_or(f64::NAN, Ball::to_f64)))
                    .collect(),
                marked: false,
                theory: false,
            }
        };
    let chart = LineChart {
        caption: caption.clone(),
        x: Axis::log10("*β* = *b*/*a*", "", first.effect_ratio.to_f64(), last.effect_ratio.to_f64()),
        y: Axis::linear("Largest log10 distance from the nearer asymptote", "", 0.0, 0.5),
        series: vec![
            line("upper arc (eqs 15 and 18)", &|row| row.errors.upper_worst_log10.as_ref()),
            line("lower arc (eqs 16 and 20)", &|row| Some(&row.errors.lower_worst_log10)),
        ],
        references: vec![Reference::Vertical { at: 1.0, label: "*a* = *b*".into() }],
        bands: Vec::new(),
        labels: Vec::new(),
    };
    Some(Figure::new(
        caption,
        "Figure A2",
        "Largest error of the asymptotes, which depends only on b/a. Every point is an enclosure.",
        chart.svg(),
    ))
}

const ENOUGH: &str = "For each asymptote, the range of velocity in which it agrees with the exact boundary within 10, 1 and 0.1 percent.";

fn good_enough(scene: &SceneOutcome) -> Option<Figure> {
    let outcome = scene.tolerance.as_ref()?;
    let mut tolerances: Vec<&Rational> = outcome.rows.iter().map(|row| &row.tolerance).collect();
    tolerances.sort();
    tolerances.dedup();
    tolerances.reverse();
    let caption = Caption::new("tolerance", "Where each asymptote is accurate enough", ENOUGH);
    let scale = velocity_scale(scene)?;
    let chart = RangeChart {
        caption: caption.clone(),
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
    Some(Figure::new(
        caption,
        "Figure A3",
        "Ranges of velocity in which each asymptote may replace the exact boundary, for a < b.",
        chart.svg(),
    ))
}

/// D_c √(K/M), m/s: the velocity at which η/κ = 1.
fn velocity_scale(scene: &SceneOutcome) -> Option<f64> {
    let parameters = scene.slider()?;
    let natural =
        (parameters.stiffness_pa_per_m.to_f64() / parameters.mass_per_area_kg_per_m2.to_f64()).sqrt();
    Some(parameters.critical_slip_distance_m.to_f64() * natural)
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
