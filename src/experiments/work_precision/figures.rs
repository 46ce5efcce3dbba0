//! Figures of work against error.

use crate::experiments::work_precision::WorkCase;
use crate::experiments::{Figure, FigureMaker, Need, Outcome};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, Caption, LineChart, Series};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker::new("work-precision-1", &[Need::WorkPrecision], &["work-precision"], |outcome| {
        work(outcome, 0)
    }),
    FigureMaker::new("work-precision-2", &[Need::WorkPrecision], &["work-precision"], |outcome| {
        work(outcome, 1)
    }),
    FigureMaker::new("work-precision-3", &[Need::WorkPrecision], &["work-precision"], |outcome| {
        work(outcome, 2)
    }),
];

const WORK: &str = "Error of the logarithm of the peak velocity against evaluations of the right-hand side on one period of the limit cycle, on logarithmic axes, one line for each method. From nine digits on, the Radau methods of orders 9 and 13 need the fewest evaluations.";

/// Below this an error of ln V_peak is rounding.
const LEAST_ERROR: f64 = 1e-16;

fn work(outcome: &Outcome, index: usize) -> Option<Figure> {
    let case = outcome.scenes.iter().find_map(|scene| scene.work_precision.as_ref())?.get(index)?;
    let id = format!("work-precision-{}", index + 1);
    let place = words_of(case);
    let caption = Caption::new(&id, &format!("Work against error, {place}"), WORK);
    let mut methods: Vec<&'static str> = case.points.iter().map(|point| point.method).collect();
    methods.dedup();
    let least = case.points.iter().map(|p| p.evaluations).min()?;
    let most = case.points.iter().map(|p| p.evaluations).max()?;
    let chart = LineChart {
        caption,
        x: Axis::log10("Evaluations of the right-hand side", "", 0.7 * least as f64, 1.4 * most as f64),
        y: Axis::log10("Error of ln(*V*_{peak}/*V*_0)", "", LEAST_ERROR, 1e-2),
        series: methods.iter().map(|method| method_line(case, method)).collect(),
        references: Vec::new(),
    };
    Some(Figure::new(
        &chart.caption,
        &format!("Figure N{}", index + 2),
        &format!(
            "Work against error on one period of the limit cycle, {place}, slip law. The reference is Radau IIA of order 13 in double-double at a local tolerance of 1e-20. Errors below 1e-16 are drawn at 1e-16. Missing methods do not finish the period within 100 000 steps. For the original scheme, evaluations are Newton iterations."
        ),
        chart.svg(),
    ))
}

fn words_of(case: &WorkCase) -> String {
    format!(
        "σ = {} Pa, V0 = {} m/s",
        round_digits(nearest_f64(&case.place.normal_stress_pa), 3),
        round_digits(nearest_f64(&case.place.loading_velocity_m_per_s), 3)
    )
}

fn method_line(case: &WorkCase, method: &str) -> Series {
    let points = case
        .points
        .iter()
        .filter(|point| point.method == method)
        .map(|point| (point.evaluations as f64, point.peak_error.max(LEAST_ERROR)))
        .collect();
    Series::marked(method, points)
}
