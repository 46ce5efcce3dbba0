//! `slipmode roots`: the three roots s of eq 8, to any number of certified digits.

use std::cmp::Ordering;

use clap::Args;
use rug::Float;
use rug::float::Round;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::{nearest_digits, round_float};
use slipmode_core::number::{Ball, Rational};
use slipmode_core::roots::{CertifiedRoot, certified_roots};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions};
use crate::cli::terminal;
use crate::cli::{Captured, captured};

/// The most digits that can be requested.
pub const MOST_DIGITS: u64 = 1_000_000;
/// Digits computed beyond those printed, so that the last one is certain: a closer call than 1e-12 of a digit is
/// printed with one digit fewer.
const GUARD_DIGITS: u32 = 12;
/// Significant digits of a printed radius.
const RADIUS_DIGITS: usize = 3;

/// Options of `roots`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: SliderOptions,
    /// Significant digits of every real and imaginary part, 1 to 1 000 000
    #[arg(long, value_name = "N", default_value = "17", allow_hyphen_values = true)]
    digits: String,
    /// A JSON list instead of text
    #[arg(long)]
    json: bool,
}

/// Runs the command.
///
/// # Errors
/// When the arguments are at fault or the output cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let answer = answer(&options.slider, &options.digits)?;
    if options.json { terminal::print_json(answer.value("roots")) } else { answer.print(false) }
}

/// The list that `roots --json` prints for these values, in the order of the options, as a function without a command line.
///
/// ```
/// let values = ["0.004", "0.006", "10um", "1e7", "1000", "1MPa", "10um/s"];
/// let (roots, messages) = slipmode::cli::capture_roots(values, "20");
/// assert!(roots.unwrap().contains("\"re\":") && messages.exit_code == 0);
/// ```
pub fn capture_roots(values: [&str; 7], digits: &str) -> (Option<String>, Captured) {
    captured(false, || Ok(answer(&SliderOptions::of(values), digits)?.value("roots").to_string()))
}

fn answer(slider: &SliderOptions, digits: &str) -> Result<Answer, Failure> {
    let mut arguments = Arguments::default();
    let parameters = slider.parameters(&mut arguments);
    let digits = arguments.whole("--digits", Some(digits), 1..=MOST_DIGITS);
    let digits = digits.and_then(|digits| u32::try_from(digits).ok());
    let (parameters, digits) = arguments.finish(parameters.zip(digits))?;
    let roots = print_roots(&parameters, digits);
    Ok(Answer::default()
        .list("roots", roots.iter().map(|root| root.answer().text(&format!("{}\n", root.text())))))
}

/// A root in 1/s as decimals: the true one lies within `radius` of re + i·im as printed.
#[derive(Debug)]
pub struct PrintedRoot {
    re: String,
    im: String,
    radius: String,
    multiplicity: u32,
}

/// The roots of eq 8 for these parameters, 1/s, each part with this many certain digits.
pub fn print_roots(parameters: &Parameters<Rational>, digits: u32) -> Vec<PrintedRoot> {
    let certified = certified_roots(&parameters.characteristic_cubic_per_s(), digits + GUARD_DIGITS);
    certified.roots.iter().map(|root| PrintedRoot::new(root, digits)).collect()
}

impl PrintedRoot {
    fn new(root: &CertifiedRoot, digits: u32) -> Self {
        let (re, im) = (root.re_ball(), root.im_ball());
        let [re_text, im_text] = [&re, &im].map(|part| nearest_digits(part, digits as usize));
        let radius = distance(&re, &re_text) + distance(&im, &im_text);
        let radius = Float::with_val_round(32, radius.upper(), Round::Up).0;
        Self { re: re_text, im: im_text, radius: rounded_up(&radius), multiplicity: root.multiplicity }
    }

    /// The object of the JSON list.
    pub fn answer(&self) -> Answer {
        Answer::default()
            .with("re", &self.re)
            .with("im", &self.im)
            .with("radius", &self.radius)
            .with("multiplicity", self.multiplicity)
    }

    /// One line for people.
    pub fn text(&self) -> String {
        let imaginary = match self.im.strip_prefix('-') {
            Some(magnitude) => format!(" - {magnitude} i"),
            None if self.im == "0" => String::new(),
            None => format!(" + {} i", self.im),
        };
        let times = match self.multiplicity {
            1 => String::new(),
            times => format!(", multiplicity {times}"),
        };
        format!("{}{imaginary} 1/s  (within {}{times})", self.re, self.radius)
    }
}

/// A ball around |part − printed|, printing's rounding included.
fn distance(part: &Ball, printed: &str) -> Ball {
    let bits = part.precision_bits() + 64;
    let Ok(parsed) = Float::parse(printed) else { return part.clone() };
    let (nearest, rounding) = Float::with_val_round(bits, parsed, Round::Nearest);
    // Reading a decimal is exact, or off by half a unit in the last place.
    let reading = match rounding {
        Ordering::Equal => Float::new(32),
        _ => Float::with_val_round(32, nearest.abs_ref(), Round::Up).0 >> bits,
    };
    let difference = part.clone() - Ball::new(nearest, reading);
    if difference.centre().is_sign_negative() { -difference } else { difference }
}

/// A non-negative number as a short decimal that is not smaller.
fn rounded_up(value: &Float) -> String {
    let short = value.to_string_radix_round(10, Some(RADIUS_DIGITS), Round::Up);
    Float::parse(&short).map_or(short, |parsed| round_float(&Float::with_val(64, parsed), RADIUS_DIGITS))
}
