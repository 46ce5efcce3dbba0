//! `slipmode solve`: the normal stress, loading velocity, stiffness or mass at which the slider does what is stated.

mod answers;
mod rows;

use std::path::PathBuf;

use clap::Args;
use slipmode::scene::{AllowedRange, Problem, Quantity, of_word};
use slipmode_core::number::Rational;
use slipmode_core::stability::inverse::{Target, Unknown};

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions, inertial_threshold, option_of};
use crate::cli::points::{self, RowsOptions};
use crate::cli::progress::Progress;
use crate::cli::roots::MOST_DIGITS;
use rows::SolveRows;

/// The unit of SI of every target that is a number.
const PER_SECOND: &str = "1/s";

/// Options of `solve`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: SliderOptions,
    /// What is solved for: normal-stress, loading-velocity, stiffness or mass; its own option is not given
    #[arg(long = "for", value_name = "WORD", allow_hyphen_values = true)]
    unknown: String,
    /// Significant digits of every solution, 1 to 1 000 000; only certain digits are printed
    #[arg(long, value_name = "N", default_value = "17", allow_hyphen_values = true)]
    digits: String,
    /// One JSON object instead of text
    #[arg(long, conflicts_with = "points")]
    json: bool,
    /// Solve for every row of a CSV file; `-` reads standard input
    ///
    /// The header is that of `classify --points`. The column of what is solved for may be missing, and is not used. Every row
    /// gets the number of solutions, and up to four solutions in SI, ascending. Where a row has error bars, a solution is a range
    /// such as [1.2, 1.3], which holds the solutions for all values within them.
    #[arg(long, value_name = "FILE.csv")]
    points: Option<PathBuf>,
    #[command(flatten)]
    rows: RowsOptions,
    #[command(flatten)]
    target: TargetOptions,
}

/// What the slider shall do; one of these is given.
#[derive(Debug, Args)]
#[command(next_help_heading = "Target (one of these)")]
#[group(required = true, multiple = false)]
struct TargetOptions {
    /// The transition K = K_c (eq 9)
    #[arg(long)]
    transition: bool,
    /// The boundary max Im(s) = 0, where the discriminant of eq 8 is zero
    #[arg(long)]
    boundary: bool,
    /// Oscillations of this frequency, Hz: max Im(s) = 2π·F
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    frequency: Option<String>,
    /// Oscillations of this angular frequency, 1/s: max Im(s) = W
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    angular_frequency: Option<String>,
    /// Oscillations at this share of the natural angular frequency, 0 < R < 1: max Im(s) = R·√(K/M)
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    frequency_ratio: Option<String>,
    /// With error bars: stability at all values within them; for --for stiffness
    ///
    /// A value with an error bar is 0.009±0.001, 0.009+-0.001, 0.009(1), 0.009±5% or [0.008, 0.010]. The answer is the largest K_c, exactly.
    #[arg(long)]
    stable_for_box: bool,
    /// A growth rate max Re(s), 1/s; negative where disturbances decay, and 0 is the transition
    #[arg(long, value_name = "G", allow_hyphen_values = true)]
    growth_rate: Option<String>,
}

/// A question, valid but for the slider.
#[derive(Debug, Clone)]
struct Question {
    unknown: Unknown,
    /// What is met at a solution; none for the stiffness above which the slider is stable at all values within the error bars.
    target: Option<Target>,
    digits: u32,
}

/// Runs the command.
///
/// # Errors
/// When the arguments or the rows are at fault, or the output cannot be written.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let question = Question::read(options, &mut arguments);
    let slider = &options.slider;
    if let Some(points) = &options.points {
        slider.refuse_beside_points(&mut arguments);
        let question = arguments.finish(question)?;
        return points::run(points, &options.rows, SolveRows { question }, *progress);
    }
    options.rows.refuse_without_points(false, &mut arguments);
    let region = question.as_ref().and_then(|question| {
        let unknown = question.quantity();
        let needs = match question.is_of_point(slider) {
            true => format!("another --for: {} is what is solved for", question.unknown.as_str()),
            false => "no value: it is what is solved for".into(),
        };
        arguments.refuse_value(&option_of(unknown), slider.text(unknown), &needs);
        slider.region(Some(unknown), &mut arguments)
    });
    let (question, region) = arguments.finish(question.zip(region))?;
    let answer = question.answer(&region, question.is_of_point(slider));
    answer.map_err(|undecided| Failure::Check(format!("error: {undecided}")))?.print(options.json)
}

impl Question {
    fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        let word = |text: &str| of_word(text, &Unknown::ALL, Unknown::as_str);
        let (unknown, target) = if options.target.stable_for_box {
            let is_other = options.unknown != Unknown::Stiffness.as_str();
            arguments.refuse("--stable-for-box", is_other, "--for stiffness");
            (Some(Unknown::Stiffness), Some(None))
        } else {
            let unknown = arguments.number("--for", &options.unknown, word);
            (unknown, options.target.read(arguments).map(Some))
        };
        let digits = arguments.whole("--digits", Some(&options.digits), 1..=MOST_DIGITS);
        Some(Self { unknown: unknown?, target: target?, digits: u32::try_from(digits?).ok()? })
    }

    /// Whether the question is about one point, not about values within error bars.
    fn is_of_point(&self, slider: &SliderOptions) -> bool {
        self.target.is_some() && !slider.is_uncertain()
    }

    /// The input that is solved for.
    fn quantity(&self) -> Quantity {
        Quantity::from(self.unknown)
    }
}

impl TargetOptions {
    fn read(&self, arguments: &mut Arguments) -> Option<Target> {
        if let Some(text) = &self.frequency {
            return arguments.measured("--frequency", text, PER_SECOND).map(Target::Frequency);
        }
        if let Some(text) = &self.angular_frequency {
            return arguments.measured("--angular-frequency", text, PER_SECOND).map(Target::AngularFrequency);
        }
        if let Some(text) = &self.frequency_ratio {
            let ratio = arguments.number("--frequency-ratio", text, inertial_threshold);
            return ratio.map(Target::FrequencyRatio);
        }
        if let Some(text) = &self.growth_rate {
            return arguments.number("--growth-rate", text, growth_rate).map(Target::GrowthRate);
        }
        Some(if self.boundary { Target::Boundary } else { Target::GrowthRate(Rational::new()) })
    }
}

/// A rate of either sign, or zero.
fn growth_rate(text: &str) -> Result<Rational, Problem> {
    let magnitude = text.strip_prefix('-').unwrap_or(text);
    match AllowedRange::PHYSICAL.parse_measured(magnitude, PER_SECOND) {
        Err(Problem::NotPositive { .. }) if !magnitude.starts_with('-') => Ok(Rational::new()),
        read => read.map(|rate| if magnitude == text { rate } else { -rate }),
    }
}
