//! Figures of work against error.

use super::WorkCase;
use crate::chart::{Chart, LogAxis, marked};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::Series;

/// Ids and labels, case by case.
const NAMES: [(&str, &str); 3] =
    [("work-precision-1", "Figure N2"), ("work-precision-2", "Figure N3"), ("work-precision-3", "Figure N4")];

/// Below this an error of ln V_peak is rounding.
const LEAST_ERROR: f64 = 1e-16;

/// A figure for each case.
#[must_use]
pub fn figures(cases: &[WorkCase]) -> Vec<Chart> {
    NAMES.into_iter().zip(cases).map(|((id, label), case)| figure(id, label, case)).collect()
}

fn figure(id: &'static str, label: &'static str, case: &WorkCase) -> Chart {
    let place = words_of(case);
    let mut methods: Vec<&'static str> = case.points.iter().map(|point| point.method).collect();
    methods.dedup();
    let evaluations = || case.points.iter().map(|point| point.evaluations);
    let [least, most] = [evaluations().min(), evaluations().max()].map(Option::unwrap_or_default);
    Chart {
        id,
        label,
        title: format!("Work against error, {place}"),
        caption: format!(
            "Work against error on one period of the limit cycle, {place}, slip law. The reference is Radau IIA of order 13 in double-double at a local tolerance of 1e-20. Errors below 1e-16 are drawn at 1e-16. Missing methods do not finish the period within 100 000 steps. For the original scheme, evaluations are Newton iterations."
        ),
        description: "Error of the logarithm of the peak velocity against evaluations of the right-hand side on one period of the limit cycle, on logarithmic axes, one line for each method. From nine digits on, the Radau methods of orders 9 and 13 need the fewest evaluations.",
        data: &["work-precision"],
        x: LogAxis::new("Evaluations of the right-hand side", "")
            .between(0.7 * least as f64, 1.4 * most as f64),
        y: LogAxis::new("Error of ln(*V*_{peak}/*V*_0)", "").between(LEAST_ERROR, 1e-2),
        series: methods.iter().map(|method| method_line(case, method)).collect(),
        vertical: None,
    }
}

fn words_of(case: &WorkCase) -> String {
    format!(
        "σ = {} Pa, V0 = {} m/s",
        round_digits(nearest_f64(&case.place.normal_stress_pa), 3),
        round_digits(nearest_f64(&case.place.loading_velocity_m_per_s), 3)
    )
}

fn method_line(case: &WorkCase, method: &str) -> Series {
    let of_method = case.points.iter().filter(|point| point.method == method);
    let points =
        of_method.map(|point| (point.evaluations as f64, point.peak_error.max(LEAST_ERROR))).collect();
    marked(method, points)
}
