//! Figures of what the numerical method does to the answer: the original scheme's bias, and work against error.

use crate::experiments::original_scheme::SchemeSeries;
use crate::experiments::work_precision::WorkCase;
use crate::experiments::{Figure, FigureMaker};
use crate::experiments::{Need, Outcome};
use slipmode_core::number::format::round_digits;
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker {
        id: "scheme-bias",
        needs: &[Need::OriginalScheme],
        data: &["scheme-bias"],
        make: |outcome| bias(outcome),
    },
    FigureMaker {
        id: "work-precision-1",
        needs: &[Need::WorkPrecision],
        data: &["work-precision"],
        make: |outcome| work(outcome, 0),
    },
    FigureMaker {
        id: "work-precision-2",
        needs: &[Need::WorkPrecision],
        data: &["work-precision"],
        make: |outcome| work(outcome, 1),
    },
    FigureMaker {
        id: "work-precision-3",
        needs: &[Need::WorkPrecision],
        data: &["work-precision"],
        make: |outcome| work(outcome, 2),
    },
];

const BIAS: &str = "Size of the relative bias of the long-term peak velocity under the original scheme against its step, on logarithmic axes, at several points and for both laws. Every line falls in proportion to the step.";

/// Lines of one figure: more would repeat a look.
const MOST_LINES: usize = 6;

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
        caption: caption.clone(),
        x: Axis::log10("Step / √(*M*/*K*)", "", 0.8 * shortest, 1.25 * longest),
        y: Axis::log10(
            "Bias of the peak velocity, size",
            "",
            libm::exp10(libm::log10(least).floor()),
            libm::exp10(libm::log10(greatest).ceil()),
        ),
        series: lines.clone(),
        references: vec![Reference::Vertical { at: 0.1, label: "advised limit".into() }],
        bands: Vec::new(),
        labels: Vec::new(),
    };
    greatest.is_normal().then(|| Figure {
        id: caption.id,
        label: "Figure N1".into(),
        caption_markdown: "Relative deviation of the long-term peak velocity of the original scheme from the converged one, against the step. The step is in units of √(M/K); the public form of the scheme advises less than a tenth. Biases are drawn by their absolute value; the table has their signs.".into(),
        description: caption.description,
        svg: chart.svg(),
    })
}

fn bias_line(series: &SchemeSeries) -> Series {
    let points = series
        .steps
        .iter()
        .filter_map(|step| Some((step.fraction, libm::expm1(step.bias(series.log_peak)?.0).abs())))
        .filter(|&(_, bias)| bias > 0.0)
        .collect();
    let stress = libm::log10(series.place.normal_stress_pa.to_f64());
    let velocity = libm::log10(series.place.loading_velocity_m_per_s.to_f64());
    let label = format!(
        "{}, *σ* = 10^{{{}}} Pa, *V*_0 = 10^{{{}}} m/s",
        series.law.as_str(),
        round_digits(stress, 3),
        round_digits(velocity, 3).replace('-', "−")
    );
    Series { label, points, marked: true, theory: false }
}

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
        caption: caption.clone(),
        x: Axis::log10("Evaluations of the right-hand side", "", 0.7 * least as f64, 1.4 * most as f64),
        y: Axis::log10("Error of ln(*V*_{peak}/*V*_0)", "", LEAST_ERROR, 1e-2),
        series: methods.iter().map(|method| method_line(case, method)).collect(),
        references: Vec::new(),
        bands: Vec::new(),
        labels: Vec::new(),
    };
    Some(Figure {
        id,
        label: format!("Figure N{}", index + 2),
        caption_markdown: format!(
            "Work against error on one period of the limit cycle, {place}, slip law. The reference is Radau IIA of order 13 in double-double at a local tolerance of 1e-20. Errors below 1e-16 are drawn at 1e-16. Missing methods do not finish the period within 100 000 steps. For the original scheme, evaluations are Newton iterations."
        ),
        description: caption.description,
        svg: chart.svg(),
    })
}

fn words_of(case: &WorkCase) -> String {
    format!(
        "σ = {} Pa, V0 = {} m/s",
        round_digits(case.place.normal_stress_pa.to_f64(), 3),
        round_digits(case.place.loading_velocity_m_per_s.to_f64(), 3)
    )
}

fn method_line(case: &WorkCase, method: &str) -> Series {
    let points = case
        .points
        .iter()
        .filter(|point| point.method == method)
        .map(|point| (point.evaluations as f64, point.peak_error.max(LEAST_ERROR)))
        .collect();
    Series { label: method.into(), points, marked: true, theory: false }
}
