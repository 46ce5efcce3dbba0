//! What a fit says in sentences.

use crate::experiments::Outcome;
use crate::fitting::{Estimate, SAMPLES, advice, comparison_words};
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::SlipMode;

/// Significant digits of a standard error; a value has as many decimals.
const ERROR_DIGITS: usize = 2;

/// Digits of an estimate down to those of its error: from two, for a value that its error exceeds, to all of a 64-bit number.
pub(crate) fn digits(estimate: &Estimate) -> usize {
    digits_of(estimate.value, estimate.standard_error)
}

fn digits_of(value: f64, standard_error: f64) -> usize {
    let ratio = (value / standard_error).abs();
    let digits = if ratio.is_finite() && ratio > 1.0 { libm::log10(ratio).ceil() } else { 1.0 };
    (digits as usize + ERROR_DIGITS - 1).clamp(ERROR_DIGITS, 16)
}

/// A value with its error and its interval: `0.0081 ± 0.0002` and `0.0077 to 0.0085`.
#[must_use]
pub fn estimate_words(value: f64, standard_error: f64, ends: [Option<f64>; 2], unit: &str) -> [String; 2] {
    let digits = digits_of(value, standard_error);
    let end = |end: Option<f64>| end.map_or_else(|| "no bound".into(), |end| round_digits(end, digits));
    let error = round_digits(standard_error, ERROR_DIGITS);
    let value = format!("{} ± {error} {unit}", round_digits(value, digits));
    [value.trim_end().to_string(), format!("{} to {}", end(ends[0]), end(ends[1]))]
}

/// The slip modes of sampled sliders with their shares.
pub(crate) fn shares_of_modes(modes: &[(SlipMode, u32)]) -> String {
    let share = |count: u32| round_digits(100.0 * f64::from(count) / f64::from(SAMPLES), 3);
    let words = modes.iter().map(|(mode, count)| format!("{} {} %", mode.words(), share(*count)));
    words.collect::<Vec<_>>().join(", ")
}

/// What the record of the first scene with a fit gives; `None` when no scene has one.
pub(crate) fn fit_words(outcome: &Outcome) -> Option<String> {
    let (_, found) = outcome.each(|scene| &scene.fit).next()?;
    let fits = match &found.fits {
        Ok(fits) => fits,
        Err(failure) => return Some(format!("The record gives no friction parameters: {failure}.")),
    };
    let fit = &fits.best;
    let values = fit.estimates.iter().map(|Estimate { parameter, value, standard_error, ends, .. }| {
        let [value, range] = estimate_words(*value, *standard_error, *ends, parameter.unit());
        format!("{} = {value} (95 %: {range})", parameter.symbol())
    });
    let values = values.collect::<Vec<_>>().join(", ");
    let mut sentences = vec![format!("With the {} law the record gives {values}.", fit.given.law.as_str())];
    sentences.extend(fits.comparison().map(|comparison| comparison_words(&comparison)));
    if let Some(modes) = &found.modes {
        sentences.push(format!(
            "Of {SAMPLES} sliders with these errors and correlations: {} at the operating point (sampled).",
            shares_of_modes(modes)
        ));
    }
    sentences.extend(advice(fit, &found.record));
    Some(sentences.join(" "))
}
