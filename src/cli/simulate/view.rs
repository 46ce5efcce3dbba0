//! What `simulate` says of one point: as text for people, as one JSON object for programs.

use rug::Float;
use rug::float::Round;
use serde_json::{Map, Value, json};
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_core::stability::ParameterBox;

use crate::cli::inputs::{SCHEMA, inputs_json, ranges_json};
use crate::cli::simulate::rows::{Answer, COLUMNS};
use crate::cli::simulate::run::Settings;
use crate::cli::terminal;

/// The most significant digits in the text for people: those of a 64-bit number.
const MOST_DIGITS: usize = 17;
/// Significant digits of an error.
const ERROR_DIGITS: usize = 2;

/// One object with the names of the CSV columns; null where there is no value.
pub fn json(answer: &Answer) -> Map<String, Value> {
    COLUMNS.iter().map(|(name, cell)| (name.to_string(), cell(answer).json())).collect()
}

/// The same with the inputs, and with the errors that have no column.
pub fn json_with_inputs(
    answer: &Answer,
    region: &ParameterBox,
    law: EvolutionLaw,
    settings: Settings,
) -> Map<String, Value> {
    let is_point = region.lower() == region.upper();
    let inputs = if is_point { inputs_json(&region.lower()) } else { ranges_json(region, &[]) };
    let asked = [
        ("schema", json!(SCHEMA)),
        ("inputs", inputs),
        ("law", json!(law.as_str())),
        ("tolerance", json!(settings.tolerance)),
        ("start", json!(settings.start.as_str())),
    ];
    let errors = answer.found.as_ref().ok().into_iter().flat_map(|found| {
        [
            ("stress_drop_relative_error", json!(found.stress_drop_relative_error)),
            ("minimum_velocity_log10_error", json!(found.minimum_velocity_log10_error)),
        ]
    });
    let named = asked.into_iter().chain(errors).map(|(name, value)| (name.to_string(), value));
    named.chain(json(answer)).collect()
}

/// Lines of name, value and meaning, with only the digits that the estimated errors support.
pub fn text(found: &Simulation, law: EvolutionLaw, settings: Settings) -> String {
    let (mode, extent, oscillation) = match found.behaviour {
        Behaviour::Periodic => ("(a limit cycle)", "(of the cycle)", "(of the cycle)"),
        Behaviour::Decaying => {
            ("(back to steady sliding)", "(of the transient)", "(of the late oscillation)")
        }
    };
    let period_error = found.period_relative_error.unwrap_or(0.0);
    let period = found.period_s.map_or_else(|| "none".into(), |period| relative(period, period_error, "s"));
    let frequency =
        found.frequency_hz.map_or_else(|| "none".into(), |frequency| relative(frequency, period_error, "Hz"));
    let lowest = certain(found.minimum_velocity_log10_ratio, found.minimum_velocity_log10_error);
    let error =
        |error: Option<f64>| error.map_or_else(|| "none".into(), |error| round_digits(error, ERROR_DIGITS));
    let oscillation = if found.period_s.is_some() { oscillation } else { "(nothing oscillates)" };
    terminal::named_values(&[
        ("mode", found.behaviour.as_str().into(), mode),
        ("slip mode", found.slip_mode.as_str().into(), "(from the trajectory alone)"),
        ("peak velocity", relative(found.peak_velocity_m_per_s, found.peak_relative_error, "m/s"), extent),
        ("log10 of minimum V/V0", lowest, extent),
        ("stress drop", relative(found.stress_drop_pa, found.stress_drop_relative_error, "Pa"), extent),
        ("period", period, oscillation),
        ("frequency", frequency, oscillation),
        ("error of the peak", error(Some(found.peak_relative_error)), "(relative)"),
        ("error of the period", error(found.period_relative_error), "(relative)"),
        ("law", law.as_str().into(), ""),
        ("start", settings.start.as_str().into(), "(V = V0/10)"),
        ("steps, evaluations", format!("{}, {}", found.steps, found.evaluations), ""),
    ])
}

fn relative(value: f64, relative_error: f64, unit: &str) -> String {
    format!("{} {unit}", certain(value, relative_error * value.abs()))
}

/// The digits that an absolute error leaves certain.
fn certain(value: f64, error: f64) -> String {
    let radius = Float::with_val_round(32, error, Round::Up).0;
    certain_digits(&Ball::new(Float::with_val(64, value), radius), MOST_DIGITS)
}
