//! `slipmode tolerance`: which formula may be used where, for given relative errors.

mod over_box;

use clap::Args;
use serde_json::json;
use slipmode::experiments::tolerance::run::tolerance_limits;
use slipmode::experiments::tolerance::{ToleranceRow, ToleranceSection, place_of_limit};
use slipmode::scene::AllowedRange;
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{certain_digits, rational_to_decimal};
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::tolerance::enclosed;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::inputs::slider_json;
use crate::cli::options::{Arguments, MaterialOptions};

/// Options of `tolerance`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    material: MaterialOptions,
    /// An acceptable relative error, 0 < E < 1; may be given several times
    #[arg(short = 'e', long, value_name = "E", allow_hyphen_values = true, default_values = ["0.1", "0.01", "0.001"])]
    relative_error: Vec<String>,
    /// One JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// Digits of a value or a limit: enough to use, few enough to read.
const DIGITS: usize = 6;

/// Characters of a formula.
const WIDTH: usize = 28;

/// Digits of each enclosure: more than are printed.
const CERTAIN_DIGITS: u32 = 20;

/// Prints a line for each formula and each error.
///
/// # Errors
/// When the arguments are at fault.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let read = |text: &str| AllowedRange::OPEN_UNIT.parse(text);
    let error = |text: &String| arguments.number("--relative-error", text, read);
    let relative: Vec<Rational> = options.relative_error.iter().filter_map(error).collect();
    let answer = if options.material.is_uncertain() {
        let region = options.material.region(None, &mut arguments);
        over_box::answer(&arguments.finish(region)?, &relative)
    } else {
        let slider = options.material.slider(&mut arguments);
        answer(&arguments.finish(slider)?, relative)
    };
    answer.print(options.json)
}

/// Computes the limit of every formula for each error.
fn answer(slider: &Slider<Rational>, relative: Vec<Rational>) -> Answer {
    let enclosed = enclosed(slider, CERTAIN_DIGITS);
    let row = |row: &ToleranceRow| {
        let asymptote = row.limit.asymptote;
        // σ of eqs 15 and 16, and V0 of eqs 18 and 20 at 1 Pa.
        let value = asymptote.value(&enclosed, &Ball::from(1));
        let place = place_of_limit(asymptote, row.limit.whole_branch);
        let [value_key, limit_key, unit] = keys(asymptote);
        let limit = format!("{} {unit}", certain_digits(&row.in_si, DIGITS));
        let formula = formula(asymptote, &certain_digits(&value, DIGITS));
        part(asymptote, &row.tolerance, WIDTH, [&formula, place, &limit])
            .with(value_key, value.to_f64())
            .with("limit", json!({ limit_key: row.in_si.to_f64() }))
    };
    let outcome = tolerance_limits(slider, &ToleranceSection { relative });
    Answer::to(slider_json(slider))
        .text(&columns(WIDTH, ["formula", "", "good to", "where", "limit"]))
        .list("formulas", outcome.rows.iter().map(row))
}

/// States a formula with a relative error, in a line.
fn part(
    asymptote: Asymptote,
    relative_error: &Rational,
    width: usize,
    [formula, place, limit]: [&str; 3],
) -> Answer {
    // It is below 1, which its first digits may not show.
    let error = (DIGITS..).map(|digits| rational_to_decimal(relative_error, digits)).find(|text| text != "1");
    Answer::default()
        .text(&columns(width, [asymptote.as_str(), formula, &error.unwrap_or_default(), place, limit]))
        .with("formula", asymptote.as_str())
        .with("relative_error", nearest_f64(relative_error))
        .with("where", place)
}

/// The names of the formula's value and of its limit, and the unit of the limit.
fn keys(asymptote: Asymptote) -> [&'static str; 3] {
    if asymptote.is_quasi_static() {
        ["normal_stress_pa", "loading_velocity_m_per_s", "m/s"]
    } else {
        ["loading_velocity_over_normal_stress_m_per_s_per_pa", "normal_stress_pa", "Pa"]
    }
}

/// The formula with the slider's numbers: eqs 15 and 16 are values of σ, eqs 18 and 20 are V0 in proportion to σ.
fn formula(asymptote: Asymptote, value: &str) -> String {
    if asymptote.is_quasi_static() {
        format!("σ = {value} Pa")
    } else {
        format!("V0 = {value} m/s · σ/Pa")
    }
}

/// A line, with so many characters for the formula.
fn columns(width: usize, [name, formula, tolerance, place, limit]: [&str; 5]) -> String {
    format!("{name:<8} {formula:<width$} {tolerance:<8} {place:<18} {limit}\n")
}
