//! `slipmode boundary`: the exact boundary max Im(s) = 0, or the line of a given ω/ω_n or damping ratio, as CSV: along the line, or at one velocity or
//! normal stress.

mod over_box;

use std::path::PathBuf;

use clap::Args;
use serde_json::Value;
use slipmode::experiments::boundary::{END_ERROR, LinePoint, Stated, vanishes};
use slipmode::experiments::pictures::boundary_picture;
use slipmode::scene::{Limits, Problem, Quantity, unit_of};
use slipmode_core::friction::Slider;
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Ball, Rational, parse_quotient};
use slipmode_core::stability::boundary::{BoundaryCurve, BoundaryPoint, Section};
use slipmode_core::stability::inverse::Undecided;
use slipmode_core::stability::{
    DampingRatio, InertialThreshold, PairLine, PairLinePoint, PairRatio, ParameterBox,
};
use slipmode_plot::table::Table;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::inputs::slider_json;
use crate::cli::new::Ranges;
use crate::cli::options::{Arguments, MaterialOptions, inertial_threshold};
use crate::cli::output::Output;
use crate::cli::roots::MOST_DIGITS;
use crate::cli::terminal;

/// Points on each arc unless the command line says otherwise.
const DEFAULT_POINTS: u64 = 200;
/// Digits unless the command line says otherwise.
const DEFAULT_DIGITS: u64 = 20;
/// The arcs of the boundary.
const ARCS: u64 = 2;
/// What a point and its row take, in bytes, and each digit of them: measured, and rounded up.
const POINT_BYTES: u64 = 4_000;
const DIGIT_BYTES: u64 = 25;
/// Points on each arc, and their digits, that draw the boundary.
const DRAWN_POINTS: usize = 200;
const DRAWN_DIGITS: u32 = 20;
/// What is said where the line of a given ω/ω_n or damping ratio has no point.
const NO_POINT_OF_LINE: &str = "oscillations have this ratio nowhere there";
/// Digits beyond those printed, so that the last one is certain.
const GUARD_DIGITS: u32 = 2;

/// Working digits beyond which no input in the allowed range hides a point: its groups span less than 10 000 decades.
const MOST_WORKING_DIGITS: u32 = 100_000;

/// Options of `boundary`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: MaterialOptions,
    /// The line on which oscillations have this share of the natural angular frequency, ω/ω_n, 0 < R < 1, in place of the boundary
    ///
    /// R is a decimal, a fraction or a square root such as sqrt(1/2), the default of --inertial-threshold. With error bars R² is at least 1/5. Asymptotes are eqs 18 and 20 times 1/√(1 − R²).
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    frequency_ratio: Option<String>,
    /// The line on which oscillations have this damping ratio, −Re(s)/|s|, −1 < Z < 1, in place of the boundary
    ///
    /// Z is a decimal or a fraction other than 0; oscillations grow where it is negative. Asymptotes are eqs 18 and 20 times 1/|Z|, and the limits of σ as V0 → 0, called eq15 and eq16 because they are these for Z = -1 and 1.
    #[arg(long, value_name = "Z", allow_hyphen_values = true, conflicts_with = "frequency_ratio")]
    damping_ratio: Option<String>,
    /// Points on each arc, in addition to the marked ones (cusp and corners); with error bars, loading velocities; not with
    /// --at-velocity or --at-normal-stress [default: 200]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    points: Option<String>,
    /// Significant digits, 1 to 1 000 000; only certain digits are printed, and 0 for an error that is zero to all of them;
    /// not with --json or error bars [default: 20]
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    digits: Option<String>,
    /// Only the points of the boundary at this loading velocity, m/s
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    at_velocity: Option<String>,
    /// Only the points of the boundary at this normal stress, Pa
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    at_normal_stress: Option<String>,
    /// Raises the limit on --points [default: 4 194 304]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    max_points: Option<String>,
    /// One JSON object instead of CSV, with 64-bit numbers
    #[arg(long)]
    json: bool,
    /// Also draw the boundary with its asymptotes and the transition, with error bars as bands
    #[arg(long, value_name = "OUT.svg")]
    svg: Option<PathBuf>,
    /// Where to write; `-` is standard output
    #[arg(short, long, value_name = "OUT.csv", default_value = "-")]
    output: PathBuf,
}

/// What was requested, valid.
struct Request {
    slider: Slider<Rational>,
    /// The line of this ratio; none for the boundary.
    pair_ratio: Option<PairRatio>,
    points: usize,
    digits: u32,
    at: [Option<Rational>; 2],
}

/// Holds what the command writes.
struct BoundaryOutput<'r> {
    answer: Answer,
    table: Table,
    /// Draws the picture, when one is wanted.
    picture: Box<dyn FnOnce() -> Result<String, Failure> + 'r>,
}

/// Runs the command.
///
/// # Errors
/// When the arguments are at fault or the output cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    if options.slider.is_uncertain() {
        let request = over_box::Request::read(options, &mut arguments);
        let request = arguments.finish(request)?;
        return options.write(|| request.compute(), request.nothing());
    }
    let request = Request::read(options, &mut arguments);
    let request = arguments.finish(request)?;
    options.write(|| request.compute(), request.nothing())
}

/// An answer to these inputs, with the line where it is not the boundary.
fn answer_to(inputs: Value, ratio: Option<&PairRatio>) -> Answer {
    let answer = Answer::to(inputs);
    match ratio {
        None => answer,
        Some(PairRatio::Frequency(ratio)) => {
            answer.with("frequency_over_natural_squared", exact_text(ratio.squared_ratio()))
        }
        Some(PairRatio::Damping(ratio)) => answer.with("damping_ratio", exact_text(ratio.value())),
    }
}

impl Options {
    fn has_single_points(&self) -> bool {
        self.at_velocity.is_some() || self.at_normal_stress.is_some()
    }

    /// Opens the outputs, computes, and writes; says so where nothing was found.
    fn write<'r>(
        &self,
        compute: impl FnOnce() -> Result<BoundaryOutput<'r>, Failure>,
        nothing: &str,
    ) -> Result<(), Failure> {
        let output = Output::create(&self.output)?;
        let svg = self.svg.as_deref().map(Output::create).transpose()?;
        let BoundaryOutput { answer, table, picture } = compute()?;
        output.finish(if self.json { format!("{:#}\n", answer.json()) } else { table.to_csv() })?;
        svg.map_or(Ok(()), |svg| svg.finish(picture()?))?;
        if table.rows.is_empty() {
            terminal::message(nothing);
        }
        Ok(())
    }
}

/// The limit on the number of points.
fn limit_on_points(options: &Options, arguments: &mut Arguments) -> u64 {
    let limit = arguments.whole("--max-points", options.max_points.as_deref(), 2..=u64::from(u32::MAX));
    limit.unwrap_or(Limits::default().max_points)
}

/// The velocity and the normal stress of single points, where they are given.
fn coordinates(options: &Options, arguments: &mut Arguments) -> [Option<Rational>; 2] {
    let given = [
        ("--at-velocity", Quantity::LoadingVelocity, &options.at_velocity),
        ("--at-normal-stress", Quantity::NormalStress, &options.at_normal_stress),
    ];
    given.map(|(option, quantity, text)| arguments.measured(option, text.as_ref()?, unit_of(quantity)))
}

/// The share of ω_n whose line is wanted, where one is given.
fn frequency_ratio(options: &Options, arguments: &mut Arguments) -> Option<InertialThreshold> {
    arguments.number("--frequency-ratio", options.frequency_ratio.as_ref()?, inertial_threshold)
}

/// The same of either ratio.
fn pair_ratio(options: &Options, arguments: &mut Arguments) -> Option<PairRatio> {
    match &options.damping_ratio {
        None => frequency_ratio(options, arguments).map(PairRatio::Frequency),
        Some(text) => arguments.number("--damping-ratio", text, damping_ratio),
    }
}

fn damping_ratio(text: &str) -> Result<PairRatio, Problem> {
    let allowed = "-1 < value < 1, and not 0".to_string();
    match parse_quotient(text) {
        Ok(ratio) => DampingRatio::new(ratio).map(PairRatio::Damping).ok_or(Problem::OutOfRange { allowed }),
        Err(reason) => Err(Problem::NotANumber { reason, allowed: Some(allowed) }),
    }
}

/// Notes options that single points have no use for, and a picture without a file.
fn refuse_beside_single_points(options: &Options, arguments: &mut Arguments) {
    if options.has_single_points() {
        let needs = "neither --at-velocity nor --at-normal-stress, which ask for single points";
        arguments.refuse("--points", options.points.is_some(), needs);
        arguments.refuse("--max-points", options.max_points.is_some(), needs);
        arguments.refuse("--svg", options.svg.is_some(), needs);
    }
    arguments.refuse_stream("--svg", options.svg.as_deref(), "the points");
}

impl Request {
    fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        let slider = options.slider.slider(arguments);
        let limit = limit_on_points(options, arguments);
        let given = arguments.whole("--points", options.points.as_deref(), 2..=u64::MAX);
        let whole = |text: &String| arguments.whole("--digits", Some(text), 1..=MOST_DIGITS);
        let digits = options.digits.as_ref().map_or(Some(DEFAULT_DIGITS), whole);
        let needs = "CSV: the numbers of --json have 64 bits";
        arguments.refuse_value("--digits", options.digits.as_deref().filter(|_| options.json), needs);
        let at = coordinates(options, arguments);
        let pair_ratio = pair_ratio(options, arguments);
        refuse_beside_single_points(options, arguments);
        let points = given.unwrap_or(DEFAULT_POINTS);
        if let Some(problem) =
            digits.filter(|_| !options.has_single_points()).and_then(|digits| too_many(points, limit, digits))
        {
            arguments.fault::<()>("--points", Some(&points.to_string()), problem);
        }
        Some(Self {
            slider: slider?,
            points: usize::try_from(points).ok()?,
            digits: u32::try_from(digits?).ok()?,
            at,
            pair_ratio,
        })
    }

    /// What is said where the line has no point.
    fn nothing(&self) -> &'static str {
        if self.pair_ratio.is_some() { NO_POINT_OF_LINE } else { "the boundary has no point there" }
    }

    /// Computes the points: a table, and an object with the inputs and the points under the names of the columns.
    fn compute(&self) -> Result<BoundaryOutput<'_>, Failure> {
        let (answer, table) = match &self.pair_ratio {
            None => self.points(|digits| Ok(self.of_boundary(digits))).map(|points| self.stated(&points)),
            Some(ratio) => {
                self.points(|digits| self.of_ratio(ratio, digits)).map(|points| self.stated(&points))
            }
        }
        .map_err(|undecided| Failure::Check(format!("error: {undecided}")))?;
        let picture = move || picture(&self.slider, (None, self.pair_ratio.as_ref()));
        Ok(BoundaryOutput { answer, table, picture: Box::new(picture) })
    }

    fn stated<P: LinePoint>(&self, points: &[P]) -> (Answer, Table) {
        let mut table = Table::new("boundary", "Boundary", P::columns());
        points.iter().for_each(|point| table.push(point.row(self.digits as usize)));
        let answer = answer_to(slider_json(&self.slider), self.pair_ratio.as_ref());
        (answer.list("points", points.iter().map(part)), table)
    }

    /// The points, computed with more digits than requested where inputs hundreds of decades apart take them.
    fn points<P: LinePoint>(
        &self,
        points_to: impl Fn(u32) -> Result<Vec<P>, Undecided>,
    ) -> Result<Vec<P>, Undecided> {
        let mut working_digits = self.digits;
        loop {
            let points = points_to(working_digits)?;
            if working_digits >= MOST_WORKING_DIGITS || points.iter().all(|point| self.is_enclosed(point)) {
                return Ok(points);
            }
            working_digits = working_digits.saturating_mul(4).max(100);
        }
    }

    fn of_boundary(&self, digits: u32) -> Vec<BoundaryPoint> {
        let curve = BoundaryCurve::new(&self.slider, digits);
        match self.sections() {
            sections if sections.is_empty() => curve.sample(self.points, END_ERROR),
            sections => sections.iter().flat_map(|section| curve.on_section(section)).collect(),
        }
    }

    fn of_ratio(&self, ratio: &PairRatio, digits: u32) -> Result<Vec<PairLinePoint>, Undecided> {
        let line = PairLine::new(&self.slider, ratio, digits);
        let sections = self.sections();
        if sections.is_empty() {
            return Ok(line.sample(self.points, END_ERROR));
        }
        let found: Result<Vec<_>, _> = sections.iter().map(|section| line.on_section(section)).collect();
        Ok(found?.into_iter().flatten().collect())
    }

    /// The sections on which single points are requested.
    fn sections(&self) -> Vec<Section> {
        let [velocity, stress] = self.at.clone();
        velocity.map(Section::AtVelocity).into_iter().chain(stress.map(Section::AtNormalStress)).collect()
    }

    /// Whether every number of a point has all digits, or is zero to all of them.
    fn is_enclosed(&self, point: &impl LinePoint) -> bool {
        let wanted = -f64::from(self.digits + GUARD_DIGITS) * std::f64::consts::LOG2_10;
        let has_digits = |ball: &Ball| ball.relative_radius_log2() < wanted;
        point.numbers().iter().all(|(_, ball)| has_digits(ball) || vanishes(ball, self.digits as usize))
    }
}

/// States a point: its words, and its numbers in 64 bits.
fn part<P: LinePoint>(point: &P) -> Answer {
    let words = P::STATES.iter().fold(Answer::default(), |answer, (name, .., state)| match state(point) {
        Stated::Word(word) => answer.with(name, word),
        Stated::Sign(sign) => answer.with(name, sign),
        Stated::Number(_) | Stated::OfOrderOne(_) => answer,
    });
    point.numbers().iter().fold(words, |part, (name, ball)| part.with(name, ball.to_f64()))
}

/// Draws the boundary over the axes that `new` would choose, from enough points, however many are printed.
fn picture(
    slider: &Slider<Rational>,
    more: (Option<&ParameterBox>, Option<&PairRatio>),
) -> Result<String, Failure> {
    let ranges = Ranges::around(slider).map_err(Failure::Refused)?;
    let points = BoundaryCurve::new(slider, DRAWN_DIGITS).sample(DRAWN_POINTS, END_ERROR);
    Ok(boundary_picture(slider, &points, more, ranges.velocity.ends(), ranges.stress.ends()))
}

/// Why so many points are not computed, if they are not.
fn too_many(points: u64, limit: u64, digits: u64) -> Option<Problem> {
    if points > limit {
        return Some(Problem::TooManyPoints { points: points.to_string(), limit });
    }
    let needed = points.saturating_mul(ARCS * (POINT_BYTES + DIGIT_BYTES * digits));
    let available = available_memory();
    let gigabytes = |bytes: u64| format!("{:.1} GB", bytes as f64 / 1e9);
    (needed > available).then(|| {
        let [needed, available] = [needed, available].map(gigabytes);
        Problem::Needs(format!("about {needed} of memory; {available} are available"))
    })
}

/// The memory that the system can give, in bytes; where it does not say, that of a small machine.
fn available_memory() -> u64 {
    const SMALL_MACHINE: u64 = 8_000_000_000;
    let stated = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
    let kibibytes = stated.lines().find_map(|line| {
        line.strip_prefix("MemAvailable:")?.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok()
    });
    kibibytes.map_or(SMALL_MACHINE, |kibibytes| kibibytes.saturating_mul(1024))
}
