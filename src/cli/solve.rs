//! `slipmode solve`: the normal stress, loading velocity, stiffness or mass at which the slider does what is stated.

mod over_box;
mod ranges;
mod rows;
mod view;

use std::path::PathBuf;

use clap::Args;
use serde_json::Value;
use slipmode::scene::{AllowedRange, Problem, Quantity, of_word};
use slipmode_core::friction::Parameters;
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::inverse::{Solution, Target, Undecided, Unknown, solve};

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions, option_of};
use crate::cli::points::{self, RowsOptions};
use crate::cli::progress::Progress;
use crate::cli::roots::MOST_DIGITS;
use crate::cli::terminal;
use over_box::StableForBox;
use ranges::RangesView;
use rows::SolveRows;
use view::View;

/// The unit of SI of every target that is a number.
const PER_SECOND: &str = "1/s";
/// Digits computed beyond those printed, so that the last one is certain.
const GUARD_DIGITS: u32 = 12;

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
    /// With error bars: stability at all values within them; for --for stiffness
    ///
    /// A value with an error bar is 0.009±0.001, 0.009+-0.001 or [0.008, 0.010]. The answer is the largest K_c, exactly.
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
    target: Target,
    digits: u32,
}

/// What is asked of a slider, or of every row.
#[derive(Debug, Clone)]
enum Asked {
    /// For the values at which a target is met.
    Target(Question),
    /// For the stiffness above which the slider is stable at all values within the error bars.
    StableForBox { digits: u32 },
}

/// Runs the command.
///
/// # Errors
/// When the arguments or the rows are at fault, or the output cannot be written.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let asked = Asked::read(options, &mut arguments);
    if let Some(points) = &options.points {
        options.slider.refuse_beside_points(&mut arguments);
        let asked = arguments.finish(asked)?;
        return points::run(points, &options.rows, SolveRows { asked }, *progress);
    }
    options.rows.refuse_without_points(false, &mut arguments);
    let task = asked.and_then(|asked| asked.about(&options.slider, &mut arguments));
    let (text, json) = answer(arguments.finish(task)?)?;
    if options.json { terminal::print_json(&json) } else { terminal::print(&text) }
}

/// A question about a point, or about all values within error bars.
enum Task {
    Point(Question, Parameters<Rational>),
    Box(Question, ParameterBox),
    StableForBox(u32, ParameterBox),
}

/// The answer as text and as one object.
fn answer(task: Task) -> Result<(String, Value), Failure> {
    Ok(match task {
        Task::Point(question, parameters) => {
            let view = View::new(&question, &parameters);
            let view = view.map_err(|undecided| Failure::Check(format!("error: {undecided}")))?;
            (view.text(), view.json())
        }
        Task::Box(question, region) => {
            let view = RangesView::new(&question, region);
            (view.text(), view.json())
        }
        Task::StableForBox(digits, region) => {
            let view = StableForBox::new(region, digits);
            (view.text(), view.json())
        }
    })
}

/// The values within the error bars, but for the unknown, which must not be given.
fn region(slider: &SliderOptions, unknown: Quantity, arguments: &mut Arguments) -> Option<ParameterBox> {
    let given = slider.text(unknown);
    arguments.refuse_value(&option_of(unknown), given, "no value: it is what is solved for");
    slider.region(Some(unknown), arguments)
}

impl Asked {
    fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        if !options.target.stable_for_box {
            return Question::read(options, arguments).map(Self::Target);
        }
        if options.unknown != Unknown::Stiffness.as_str() {
            arguments.refuse("--stable-for-box", true, "--for stiffness");
        }
        let digits = arguments.whole("--digits", Some(&options.digits), 1..=MOST_DIGITS);
        Some(Self::StableForBox { digits: u32::try_from(digits?).ok()? })
    }

    /// The input that is solved for.
    fn quantity(&self) -> Quantity {
        match self {
            Self::Target(question) => question.quantity(),
            Self::StableForBox { .. } => Quantity::Stiffness,
        }
    }

    /// The question with the values of a command line.
    fn about(self, slider: &SliderOptions, arguments: &mut Arguments) -> Option<Task> {
        match self {
            Self::StableForBox { digits } => region(slider, Quantity::Stiffness, arguments)
                .map(|region| Task::StableForBox(digits, region)),
            Self::Target(question) if slider.is_uncertain() => {
                region(slider, question.quantity(), arguments).map(|region| Task::Box(question, region))
            }
            Self::Target(question) => {
                let parameters = question.parameters(slider, arguments)?;
                Some(Task::Point(question, parameters))
            }
        }
    }
}

impl Question {
    fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        let word = |text: &str| of_word(text, &Unknown::ALL, Unknown::as_str);
        let unknown = arguments.number("--for", &options.unknown, word);
        let target = options.target.read(arguments);
        let digits = arguments.whole("--digits", Some(&options.digits), 1..=MOST_DIGITS);
        Some(Self { unknown: unknown?, target: target?, digits: u32::try_from(digits?).ok()? })
    }

    /// The six values that are given, and 1 for the unknown.
    fn parameters(&self, slider: &SliderOptions, arguments: &mut Arguments) -> Option<Parameters<Rational>> {
        let unknown = self.quantity();
        let needs = format!("another --for: {} is what is solved for", self.unknown.as_str());
        arguments.refuse_value(&option_of(unknown), slider.text(unknown), &needs);
        let read = Quantity::ALL
            .map(|quantity| (quantity != unknown).then(|| slider.required(quantity, arguments)).flatten());
        arguments.check_units(&read);
        let is_complete =
            Quantity::ALL.iter().zip(&read).all(|(quantity, value)| *quantity == unknown || value.is_some());
        let values = read.map(|value| value.unwrap_or_else(|| Rational::from(1)));
        is_complete.then(|| Parameters::from(values))
    }

    /// The input that is solved for.
    fn quantity(&self) -> Quantity {
        match self.unknown {
            Unknown::NormalStress => Quantity::NormalStress,
            Unknown::LoadingVelocity => Quantity::LoadingVelocity,
            Unknown::Stiffness => Quantity::Stiffness,
            Unknown::MassPerArea => Quantity::MassPerArea,
        }
    }

    /// The solutions, with digits to spare.
    fn solve(&self, parameters: &Parameters<Rational>) -> Result<Vec<Solution>, Undecided> {
        solve(parameters, self.unknown, &self.target, self.digits + GUARD_DIGITS)
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
        if let Some(text) = &self.growth_rate {
            return arguments.number("--growth-rate", text, growth_rate).map(Target::GrowthRate);
        }
        Some(if self.boundary { Target::Boundary } else { Target::GrowthRate(Rational::new()) })
    }
}

/// A rate of either sign, or zero.
fn growth_rate(text: &str) -> Result<Rational, Problem> {
    let (is_negative, magnitude) = match text.strip_prefix('-') {
        Some(magnitude) => (true, magnitude),
        None => (false, text),
    };
    match AllowedRange::PHYSICAL.parse_measured(magnitude, PER_SECOND) {
        Err(Problem::NotPositive { .. }) if !magnitude.starts_with('-') => Ok(Rational::new()),
        read => read.map(|rate| if is_negative { -rate } else { rate }),
    }
}
