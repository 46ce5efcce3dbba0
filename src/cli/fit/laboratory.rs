//! `fit --into`: the folder of a report on the fitted slider, with its record.

use std::fmt::Write;
use std::path::Path;

use slipmode::fitting::{Estimate, Fits, Load, Parameter, Response, StepRecord};
use slipmode::scene::{Fault, MAX_FILE_BYTES, Problem};
use slipmode_core::friction::{EvolutionLaw, OperatingPoint};
use slipmode_core::number::Rational;
use slipmode_core::number::format::{Side, exact_text, rounded, shortest};

use crate::cli::answer::csv_of_numbers;
use crate::cli::failure::Failure;
use crate::cli::new::{Fitted, write_fitted};
use crate::cli::options::SliderOptions;
use crate::cli::progress::Progress;

/// Digits of the ends of an interval, which are rounded outward.
const DIGITS: usize = 4;

/// Writes the folder.
///
/// # Errors
/// When the record does not bound a value or is too long for a report, or the folder cannot be written.
pub fn write(
    place: &Path,
    record: &StepRecord,
    fits: &Fits,
    laws: &[EvolutionLaw],
    point: &OperatingPoint<Rational>,
    progress: Progress,
) -> Result<(), Failure> {
    let slider = slider(fits, point)?;
    let text = record_text(record);
    if text.len() as u64 > MAX_FILE_BYTES {
        let allowed = format!(
            "a shorter record: {} bytes as CSV exceed {MAX_FILE_BYTES}; take means of neighbouring rows",
            text.len()
        );
        return Err(refused(allowed));
    }
    let fitted = Fitted { section: section(fits, laws), record: text };
    write_fitted(place, &slider, fitted, progress)
}

fn refused(needs: String) -> Failure {
    Fault::of("command line", "--into", Problem::Needs(needs)).into()
}

/// The values of the slider: 95 % intervals of those that were fitted.
fn slider(fits: &Fits, point: &OperatingPoint<Rational>) -> Result<SliderOptions, Failure> {
    let interval = |estimate: &Estimate| match estimate.ends {
        [Some(low), Some(high)] => {
            Ok(format!("[{}, {}]", rounded(low, DIGITS, Side::Below), rounded(high, DIGITS, Side::Above)))
        }
        _ => Err(refused(format!("a record that bounds {} on both sides", estimate.parameter.symbol()))),
    };
    let fitted = |parameter: Parameter| fits.best.estimate(parameter).map(interval).transpose();
    let given = &fits.best.given;
    let known = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let [a, b, d, k] = [
        Parameter::DirectEffect,
        Parameter::EvolutionEffect,
        Parameter::CriticalSlipDistance,
        Parameter::Stiffness,
    ]
    .map(fitted);
    let (a, b, d) = (a?.unwrap_or_default(), b?.unwrap_or_default(), d?.unwrap_or_default());
    let k = k?.unwrap_or_else(|| known(given.stiffness_pa_per_m));
    let m = known(given.mass_per_area_kg_per_m2);
    let [s, v] = [&point.normal_stress_pa, &point.loading_velocity_m_per_s].map(exact_text);
    Ok(SliderOptions::of([&a, &b, &d, &k, &m, &s, &v].map(String::as_str)))
}

/// The text of `[fit]`.
fn section(fits: &Fits, laws: &[EvolutionLaw]) -> String {
    let given = &fits.best.given;
    let laws: Vec<String> = laws.iter().map(|law| format!("\"{}\"", law.as_str())).collect();
    let mut text = format!(
        "\n# The values above are fitted to vectors/record.csv: 95 % intervals. Without a stiffness here, it is fitted, too.\n\
         [fit]\nrecord = \"record\"\nlaws = [{}]\n",
        laws.join(", ")
    );
    let known = [
        ("stiffness_pa_per_m", given.stiffness_pa_per_m),
        ("mass_per_area_kg_per_m2", given.mass_per_area_kg_per_m2),
    ];
    for (key, value) in known {
        if let Some(value) = value {
            let _ = writeln!(text, "{key} = {}", shortest(value));
        }
    }
    if given.has_drift {
        text += "drift = true\n";
    }
    text
}

/// The record as CSV, in SI.
fn record_text(record: &StepRecord) -> String {
    let measured = &record.measured;
    let (name, load) = match &measured.load {
        Load::Displacement(values, _) => ("load_point_displacement_m", values),
        Load::Velocity(values) => ("load_point_velocity_m_per_s", values),
    };
    let (response, values) = match &measured.response {
        Response::ShearStress(values) => ("shear_stress_pa", values),
        Response::Friction(values) => ("friction", values),
    };
    let samples = measured.times_s.iter().zip(load).zip(values.iter().zip(&measured.normal_stresses_pa));
    let rows = samples.map(|((time, load), (value, normal))| [*time, *load, *value, *normal]);
    csv_of_numbers(&format!("time_s,{name},{response},normal_stress_pa"), rows)
}
