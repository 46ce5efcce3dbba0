//! The figure of the original scheme's bias.

use super::{SchemeOutcome, SchemeSeries};
use crate::chart::{Chart, LogAxis, marked};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::Series;

/// Lines of one figure: more would repeat a look.
const MOST_LINES: usize = 6;

/// The size of the bias against the step.
#[must_use]
pub fn figure(found: &SchemeOutcome) -> Chart {
    let mut lines: Vec<Series> = found.series.iter().map(bias_line).filter(|s| s.points.len() > 2).collect();
    lines.truncate(MOST_LINES);
    let points = || lines.iter().flat_map(|line| line.points.iter().copied());
    let least = points().map(|(_, bias)| bias).fold(f64::INFINITY, f64::min);
    let greatest = points().map(|(_, bias)| bias).fold(0.0, f64::max);
    let shortest = points().map(|(step, _)| step).fold(f64::INFINITY, f64::min);
    let longest = points().map(|(step, _)| step).fold(0.0, f64::max);
    let decade = |round: fn(f64) -> f64, value: f64| libm::exp10(round(libm::log10(value)));
    Chart {
        id: "scheme-bias",
        label: "Figure N1",
        title: "Bias of the original scheme against its step".into(),
        caption: "Relative deviation of the long-term peak velocity of the original scheme from the converged one, against the step. The step is in units of √(M/K); the public form of the scheme advises less than a tenth. Biases are drawn by their absolute value; the table has their signs.".into(),
        description: "Size of the relative bias of the long-term peak velocity under the original scheme against its step, on logarithmic axes, at several points and for both laws. Every line falls in proportion to the step.",
        data: &["scheme-bias"],
        x: LogAxis::new("Step / √(*M*/*K*)", "").between(0.8 * shortest, 1.25 * longest),
        y: LogAxis::new("Bias of the peak velocity, size", "")
            .between(decade(f64::floor, least), decade(f64::ceil, greatest)),
        vertical: Some((0.1, "advised limit")),
        series: lines,
    }
}

fn bias_line(series: &SchemeSeries) -> Series {
    let points = series
        .steps
        .iter()
        .filter_map(|step| Some((step.fraction, libm::expm1(step.bias(series.log_peak)?.0).abs())))
        .filter(|&(_, bias)| bias > 0.0)
        .collect();
    let stress = libm::log10(nearest_f64(&series.place.normal_stress_pa));
    let velocity = libm::log10(nearest_f64(&series.place.loading_velocity_m_per_s));
    let label = format!(
        "{}, *σ* = 10^{{{}}} Pa, *V*_0 = 10^{{{}}} m/s",
        series.law.as_str(),
        round_digits(stress, 3),
        round_digits(velocity, 3).replace('-', "−")
    );
    marked(&label, points)
}
