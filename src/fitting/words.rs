//! What a fit says in words: what the record does not tell, and which law it prefers.

use super::estimate::{Estimate, Fit, LawComparison};
use super::parameter::Parameter;
use super::record::StepRecord;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;

/// A correlation beyond this is reported.
const STRONG: f64 = 0.95;
/// Fewest samples within D_c that a fit should rest on.
const FEWEST_SAMPLES: f64 = 5.0;
/// A width that differs from that of the quadratic by more than this share is reported.
const DIFFERS: f64 = 0.2;
/// Vuong's statistic beyond which two laws are told apart, with 95 % confidence.
const TOLD_APART: f64 = 1.96;

/// Sentences on what the record cannot tell.
pub(crate) fn advice(fit: &Fit, record: &StepRecord) -> Vec<String> {
    let mut sentences = Vec::new();
    for (i, j, correlation) in fit.correlations().filter(|(.., correlation)| correlation.abs() > STRONG) {
        let pair = [i, j].map(|index| fit.estimates[index].parameter);
        sentences.push(correlated(pair, correlation));
    }
    sentences.extend(fit.estimates.iter().filter_map(unbounded));
    let skewed = fit.estimates.iter().filter(|estimate| is_skewed(estimate));
    let skewed: Vec<&str> = skewed.map(|estimate| estimate.parameter.symbol()).collect();
    if !skewed.is_empty() {
        sentences.push(format!(
            "The intervals of {} differ from value and standard error by more than {}: use the intervals.",
            skewed.join(", "),
            percent(DIFFERS)
        ));
    }
    if fit.samples_per_slip_distance < FEWEST_SAMPLES {
        sentences.push(format!(
            "A step has {} samples within D_c: sample faster than {FEWEST_SAMPLES} per D_c.",
            round_digits(fit.samples_per_slip_distance, 2)
        ));
    }
    if fit.residuals.inflation > 1.0 {
        sentences.push(format!(
            "Neighbouring residuals are correlated, {}: the intervals are {} times as wide as for independent samples. The model may miss something.",
            round_digits(fit.residuals.autocorrelation, 2),
            round_digits(fit.residuals.inflation.sqrt(), 2)
        ));
    }
    let from_noise = (1.0 + DIFFERS) * fit.residuals.half_width();
    if fit.estimates.iter().any(|estimate| estimate.half_width > from_noise) {
        sentences.push(format!(
            "The noise is {} of the resolution of the record, {} in friction: rounding errors do not average out. The intervals include them, the standard errors do not.",
            percent(fit.residuals.noise / fit.residuals.step),
            round_digits(fit.residuals.step, 2)
        ));
    }
    let distance = fit.estimate(Parameter::CriticalSlipDistance).map(|estimate| estimate.value);
    if distance.is_some_and(|distance| record.path.resolution_m > 0.1 * distance) {
        sentences.push(format!(
            "The displacement of the load point is known to {} m, more than a tenth of D_c.",
            round_digits(record.path.resolution_m, 2)
        ));
    }
    sentences
}

fn correlated([one, other]: [Parameter; 2], correlation: f64) -> String {
    let remedy = match (one, other) {
        (Parameter::Stiffness, _) | (_, Parameter::Stiffness) => {
            "give the stiffness of the machine with --stiffness-pa-per-m"
        }
        (_, Parameter::Drift) => "fit without --drift, or record a longer time before the step",
        _ => "steps of other sizes and more samples within D_c tell them apart",
    };
    format!(
        "{} and {} are correlated, {}: {remedy}.",
        one.symbol(),
        other.symbol(),
        round_digits(correlation, 3)
    )
}

fn unbounded(estimate: &Estimate) -> Option<String> {
    let sides = match estimate.ends {
        [Some(_), Some(_)] => return None,
        [None, Some(_)] => "from below",
        [Some(_), None] => "from above",
        [None, None] => "from either side",
    };
    Some(format!("No bound of {} was found {sides}.", estimate.parameter.symbol()))
}

fn is_skewed(estimate: &Estimate) -> bool {
    let [low, high] = estimate.quadratic_ends;
    let differs = |end: Option<f64>, quadratic: f64| {
        end.is_some_and(|end| ((end - estimate.value) / (quadratic - estimate.value) - 1.0).abs() > DIFFERS)
    };
    differs(estimate.ends[0], low) || differs(estimate.ends[1], high)
}

fn percent(share: f64) -> String {
    format!("{} %", round_digits(100.0 * share, 2))
}

/// What the comparison of the two laws means.
pub(crate) fn comparison_words(comparison: &LawComparison) -> String {
    let better = comparison.better;
    let other =
        EvolutionLaw::ALL.into_iter().find(|law| *law != better).map_or("other", EvolutionLaw::as_str);
    let ratio = round_digits(comparison.log_likelihood_ratio, 3);
    let vuong = round_digits(comparison.vuong, 3);
    if comparison.vuong > TOLD_APART {
        return format!(
            "The record tells the laws apart: the {better} law fits better than the {other} law. The logarithm of the likelihood ratio is {ratio}, {vuong} times its standard deviation."
        );
    }
    format!(
        "The record does not tell the laws apart: the {better} law fits slightly better than the {other} law. The logarithm of the likelihood ratio is {ratio}, only {vuong} times its standard deviation."
    )
}
