//! The answer of `fit`, and its rows.

use serde_json::json;
use slipmode::experiments::fit::{estimate_words, shares_of_modes};
use slipmode::fitting::{Estimate, Fit, Fits, SAMPLES, StepRecord, advice, comparison_words, sampled_modes};
use slipmode_core::friction::OperatingPoint;
use slipmode_core::number::format::{round_digits, shortest};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::InertialThreshold;

use crate::cli::answer::{Answer, csv_of_numbers};

/// States the fitted values with their intervals, the noise, and what the record cannot tell.
pub fn answer(record: &StepRecord, fits: &Fits, point: &OperatingPoint<Rational>) -> Answer {
    let fit = &fits.best;
    let given = &fit.given;
    let inputs = json!({
        "normal_stress_pa": record.normal_stress_pa,
        "reference_velocity_m_per_s": record.reference_velocity_m_per_s(),
        "stiffness_pa_per_m": given.stiffness_pa_per_m,
        "mass_per_area_kg_per_m2": given.mass_per_area_kg_per_m2,
        "drift": given.has_drift,
    });
    let noise = &fit.residuals;
    let correlations = fit.correlations().fold(Answer::default(), |all, (i, j, correlation)| {
        all.with(&[i, j].map(|index| fit.estimates[index].parameter.as_str()).join(","), correlation)
    });
    let head = Answer::to(inputs).item("law", "evolution law", given.law.as_str());
    let answer = fit.estimates.iter().map(parameter).fold(head, Answer::and);
    let answer = answer
        .part("correlations", correlations)
        .with("residual_standard_deviation", noise.standard_deviation)
        .named("noise of the friction", &round_digits(noise.standard_deviation, 3))
        .note("(standard deviation of the residuals)")
        .with("residual_autocorrelation", noise.autocorrelation)
        .with("variance_inflation", noise.inflation)
        .with("points_per_slip_distance", fit.samples_per_slip_distance)
        .named("samples within D_c", &round_digits(fit.samples_per_slip_distance, 3))
        .note("(after the step that has the fewest)")
        .item("rows", "rows", record.rows() as u64)
        .with("runs", fit.runs);
    let sentences = advice(fit, record);
    let lines: String = sentences.iter().map(|sentence| format!("{sentence}\n")).collect();
    answer.and(comparison(fits)).and(modes(fit, point)).with("remarks", sentences).text(&lines)
}

/// A value with its standard error and its interval.
pub fn estimated([key, name, unit]: [&str; 3], [value, error]: [f64; 2], ends: [Option<f64>; 2]) -> Answer {
    let [text, range] = estimate_words(value, error, ends, unit);
    Answer::default()
        .with(key, json!({ "value": value, "error": error, "low": ends[0], "high": ends[1] }))
        .named(name, &text)
        .note(&format!("(95 %: {range})"))
}

fn parameter(estimate: &Estimate) -> Answer {
    let Estimate { parameter: of, value, standard_error, ends, .. } = estimate;
    estimated([of.as_str(), of.symbol(), of.unit()], [*value, *standard_error], *ends)
}

/// How the other law compares.
fn comparison(fits: &Fits) -> Answer {
    let (Some(other), Some(found)) = (&fits.other, fits.comparison()) else { return Answer::default() };
    let part = Answer::default()
        .with("other_law", other.given.law.as_str())
        .with("other_residual_standard_deviation", other.residuals.standard_deviation)
        .with("log_likelihood_ratio", found.log_likelihood_ratio)
        .with("vuong", found.vuong);
    Answer::default().part("law_comparison", part).text(&format!("{}\n", comparison_words(&found)))
}

/// The slip modes that follow, where the mass is known.
fn modes(fit: &Fit, point: &OperatingPoint<Rational>) -> Answer {
    let Some(found) = sampled_modes(fit, point, &InertialThreshold::default()) else {
        return Answer::default();
    };
    let share = |count: u32| f64::from(count) / f64::from(SAMPLES);
    let parts = found
        .iter()
        .map(|(mode, count)| Answer::default().with("mode", mode.as_str()).with("share", share(*count)));
    let [stress, velocity] =
        [&point.normal_stress_pa, &point.loading_velocity_m_per_s].map(|value| shortest(nearest_f64(value)));
    Answer::default()
        .list("slip_modes", parts)
        .with("slip_modes_at", json!({ "normal_stress_pa": nearest_f64(&point.normal_stress_pa), "loading_velocity_m_per_s": nearest_f64(&point.loading_velocity_m_per_s) }))
        .named("slip mode", &shares_of_modes(&found))
        .note(&format!("(at {stress} Pa and {velocity} m/s; sampled, {SAMPLES} sliders with these errors and correlations)"))
}

/// The record with the fitted friction, as CSV.
pub fn rows(record: &StepRecord, fit: &Fit) -> String {
    let names = "time_s,load_point_displacement_m,friction,fitted_friction,residual";
    let samples = record.measured.times_s.iter().zip(&record.displacements_m);
    let rows = samples.zip(record.frictions.iter().zip(fit.fitted(record)));
    csv_of_numbers(names, rows.map(|((t, way), (mu, fitted))| [*t, *way, *mu, fitted, mu - fitted]))
}
