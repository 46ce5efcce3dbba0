//! The figure of the original scheme's bias.

use crate::experiments::original_scheme::SchemeSeries;
use crate::experiments::{Figure, FigureMaker, Need, Outcome};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};

pub(crate) const FIGURES: &[FigureMaker] =
    &[FigureMaker::new("scheme-bias", &[Need::OriginalScheme], &["scheme-bias"], |outcome| bias(outcome))];

const BIAS: &str = "Size of the relative bias of the long-term peak velocity under the original scheme against its step, on logarithmic axes, at several points and for both laws. Every line falls in proportion to the step.";

/// Lines of one figure: more would repeat a look.
const MOST_LINES: usize = 6;

const CAPTION: &str = "Relative deviation of the long-term peak velocity of the original scheme from the converged one, against the step. The step is in units of √(M/K); the public form of the scheme advises less than a tenth. Biases are drawn by their absolute value; the table has their signs.";

fn bias(outcome: &Outcome) -> Option<Figure> {
    let found = outcome.scenes.iter().find_map(|scene| scene.original_scheme.as_ref())?;
    let mut lines: Vec<Series> = found.series.iter().map(bias_line).filter(|s| s.points.len() > 2).collect();
    lines.truncate(MOST_LINES);
    let caption = Caption::new("scheme-bias", "Bias of the original scheme against its step", BIAS);
    let points = || lines.iter().flat_map(|line| line.points.iter().copied());
    let least = points().map(|(_, bias)| bias).fold(f64::INFINITY, f64::min);
    let greatest = points().map(|(_, bias)| bias).fold(0.0, f64::max);
    let shortest = points().map(|(step, _)| step).fold(f64::INFINITY, f64::min);
    let longest = points().map(|(step, _)| step).fold(0.0, f64::max);
    let chart = LineChart {
        caption,
        x: Axis::log10("Step / √(*M*/*K*)", "", 0.8 * shortest, 1.25 * longest),
        y: Axis::log10(
            "Bias of the peak velocity, size",
            "",
            libm::exp10(libm::log10(least).floor()),
            libm::exp10(libm::log10(greatest).ceil()),
        ),
        series: lines.clone(),
        references: vec![Reference::Vertical { at: 0.1, label: "advised limit".into() }],
    };
    greatest.is_normal().then(|| Figure::new(&chart.caption, "Figure N1", CAPTION, chart.svg()))
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
    Series::marked(label, points)
}
