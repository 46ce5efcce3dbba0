//! The answer of `simulate` for one point.

use rug::Float;
use rug::float::Round;
use slipmode_core::dynamics::{Behaviour, Options, Simulation};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_core::stability::ParameterBox;

use crate::cli::answer::Answer;
use crate::cli::inputs::region_json;
use crate::cli::simulate::over_box::is_point;
use crate::cli::simulate::run::{COLUMNS, Simulated};

/// The most significant digits in the text for people: those of a 64-bit number.
const MOST_DIGITS: usize = 17;
/// What is said of a value of a limit cycle.
const OF_CYCLE: &str = "(of the cycle)";
/// Significant digits of an error.
const ERROR_DIGITS: usize = 2;

/// States what was requested and found: the columns of `--points` are keys, and so are the errors that have no column.
pub fn answer(simulated: &Simulated, region: &ParameterBox, law: EvolutionLaw, options: Options) -> Answer {
    let middle = if is_point(region) { "" } else { "the middle of the error bars:\n" };
    let answer = Answer::to(region_json(region))
        .text(middle)
        .with("law", law.as_str())
        .with("tolerance", options.tolerance)
        .with("start", options.start.as_str())
        .columns(&COLUMNS, simulated);
    let Ok(found) = &simulated.found else { return answer };
    answer
        .with("stress_drop_relative_error", found.stress_drop_relative_error)
        .with("minimum_velocity_log10_error", found.minimum_velocity_log10_error)
        .and(lines(found, law, options))
}

/// Writes lines of name, value and meaning, with only the digits that the estimated errors support.
fn lines(found: &Simulation, law: EvolutionLaw, options: Options) -> Answer {
    let [mode, extent, stress, stress_extent, oscillation] = match found.behaviour {
        Behaviour::Periodic => ["(a limit cycle)", OF_CYCLE, "stress drop", OF_CYCLE, OF_CYCLE],
        Behaviour::Decaying => [
            "(back to steady sliding)",
            "(of the transient)",
            "stress range",
            "(largest minus least of the whole run, start and steady sliding included)",
            "(of the late oscillation)",
        ],
    };
    let period_error = found.period_relative_error.unwrap_or(0.0);
    let none = || "none".to_string();
    let period = found.period_s.map_or_else(none, |period| relative(period, period_error, "s"));
    let frequency = found.frequency_hz.map_or_else(none, |value| relative(value, period_error, "Hz"));
    let lowest = certain(found.minimum_velocity_log10_ratio, found.minimum_velocity_log10_error);
    let error = |error: f64| round_digits(error, ERROR_DIGITS);
    let oscillation = if found.period_s.is_some() { oscillation } else { "(nothing oscillates)" };
    Answer::default()
        .named("mode", found.behaviour.as_str())
        .note(mode)
        .named("slip mode", found.slip_mode.as_str())
        .note("(from the trajectory alone)")
        .named("peak velocity", &relative(found.peak_velocity_m_per_s, found.peak_relative_error, "m/s"))
        .note(extent)
        .named("log10 of minimum V/V0", &lowest)
        .note(extent)
        .named(stress, &relative(found.stress_drop_pa, found.stress_drop_relative_error, "Pa"))
        .note(stress_extent)
        .named("period", &period)
        .note(oscillation)
        .named("frequency", &frequency)
        .note(oscillation)
        .named("error of the peak", &error(found.peak_relative_error))
        .note("(relative)")
        .named("error of the period", &found.period_relative_error.map_or_else(none, error))
        .note("(relative)")
        .named("law", law.as_str())
        .named("start", options.start.as_str())
        .note("(V = V0/10)")
        .named("steps, evaluations", &format!("{}, {}", found.steps, found.evaluations))
}

fn relative(value: f64, relative_error: f64, unit: &str) -> String {
    format!("{} {unit}", certain(value, relative_error * value.abs()))
}

/// The digits that an absolute error leaves certain.
pub fn certain(value: f64, error: f64) -> String {
    let radius = Float::with_val_round(32, error, Round::Up).0;
    certain_digits(&Ball::new(Float::with_val(64, value), radius), MOST_DIGITS)
}
