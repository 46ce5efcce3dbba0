//! `slipmode tolerance`: which formula may be used where, for given relative errors.

use clap::Args;
use slipmode::experiments::tolerance::{ToleranceRow, ToleranceSection, place_of_limit, tolerance_limits};
use slipmode::scene::AllowedRange;
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{certain_digits, rational_to_decimal};
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::Asymptote;

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, MaterialOptions};
use crate::cli::terminal;

/// Options of `tolerance`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    material: MaterialOptions,
    /// An acceptable relative error, 0 < E < 1; may be given several times
    #[arg(short = 'e', long, value_name = "E", allow_hyphen_values = true, default_values = ["0.1", "0.01", "0.001"])]
    relative_error: Vec<String>,
}

/// Digits of a value or a limit: enough to use, few enough to read.
const DIGITS: usize = 6;

/// Working precision of the values, in bits: far more than the digits that are printed.
const WORKING_BITS: u32 = 96;

/// Prints a line for each formula and each error.
///
/// # Errors
/// When the arguments are at fault.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let parameters = options.material.slider(&mut arguments);
    let relative: Vec<Rational> = options
        .relative_error
        .iter()
        .filter_map(|text| {
            arguments.number("--relative-error", text, |text| AllowedRange::OPEN_UNIT.parse(text))
        })
        .collect();
    let parameters = arguments.finish(parameters)?;
    let outcome = tolerance_limits(&parameters, &ToleranceSection { relative });
    let lines = outcome.rows.iter().map(|row| line(&parameters, row));
    let head = columns(["formula", "", "good to", "where", "limit"]);
    terminal::print(&std::iter::once(head).chain(lines).collect::<String>())
}

fn line(parameters: &Slider<Rational>, row: &ToleranceRow) -> String {
    let asymptote = row.limit.asymptote;
    let unit = if asymptote.is_quasi_static() { "m/s" } else { "Pa" };
    columns([
        asymptote.as_str(),
        &formula(parameters, asymptote),
        &rational_to_decimal(&row.tolerance, DIGITS),
        place_of_limit(&row.limit),
        &format!("{} {unit}", certain_digits(&row.in_si, DIGITS)),
    ])
}

/// The formula with the slider's numbers: eqs 15 and 16 are values of σ, eqs 18 and 20 are V0 in proportion to σ.
fn formula(slider: &Slider<Rational>, asymptote: Asymptote) -> String {
    let slider = slider.map(|value| Ball::from_rational(value, WORKING_BITS));
    let one_pascal = Ball::from(1);
    let value = certain_digits(&asymptote.value(&slider, &one_pascal), DIGITS);
    if asymptote.is_quasi_static() {
        format!("σ = {value} Pa")
    } else {
        format!("V0 = {value} m/s · σ/Pa")
    }
}

fn columns([name, formula, tolerance, place, limit]: [&str; 5]) -> String {
    format!("{name:<8} {formula:<28} {tolerance:<8} {place:<18} {limit}\n")
}
