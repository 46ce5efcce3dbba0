//! `slipmode boundary`: the exact boundary max Im(s) = 0 as CSV, along its arcs or at one velocity or normal stress.

mod over_box;

use std::path::PathBuf;

use clap::Args;
use slipmode::experiments::boundary::{END_ERROR, boundary_columns, boundary_row, vanishes};
use slipmode::experiments::pictures::boundary_picture;
use slipmode::scene::{Limits, Problem, Quantity};
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::boundary::{BoundaryCurve, BoundaryPoint};
use slipmode_plot::table::Table;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::inputs::slider_json;
use crate::cli::new::Ranges;
use crate::cli::options::{Arguments, MaterialOptions};
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
/// Digits beyond those printed, so that the last one is certain.
const GUARD_DIGITS: u32 = 2;

/// Working digits beyond which no input in the allowed range hides a point: its groups span less than 10 000 decades.
const MOST_WORKING_DIGITS: u32 = 100_000;

/// Options of `boundary`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: MaterialOptions,
    /// Points on each arc, in addition to the marked ones (cusp and corners); with error bars, loading velocities [default: 200]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    points: Option<String>,
    /// Significant digits, 1 to 1 000 000; only certain digits are printed, and 0 for an error that is zero to all of them
    /// [default: 20]
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
    points: usize,
    digits: u32,
    at: [Option<Rational>; 2],
}

/// Holds what the command writes.
struct Found<'r> {
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
        return options.write(|| request.compute(), "the boundary and the transition have no point there");
    }
    let request = Request::read(options, &mut arguments);
    let request = arguments.finish(request)?;
    options.write(|| Ok(request.compute()), "the boundary has no point there")
}

impl Options {
    fn has_single_points(&self) -> bool {
        self.at_velocity.is_some() || self.at_normal_stress.is_some()
    }

    /// Opens the outputs, computes, and writes; says so where nothing was found.
    fn write<'r>(
        &self,
        compute: impl FnOnce() -> Result<Found<'r>, Failure>,
        nothing: &str,
    ) -> Result<(), Failure> {
        let output = Output::create(&self.output)?;
        let svg = self.svg.as_deref().map(Output::create).transpose()?;
        let Found { answer, table, picture } = compute()?;
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

/// The velocity and the normal stress of single points, where they are given; none when one is at fault.
fn coordinates(options: &Options, arguments: &mut Arguments) -> Option<[Option<Rational>; 2]> {
    let given = [
        ("--at-velocity", Quantity::LoadingVelocity, &options.at_velocity),
        ("--at-normal-stress", Quantity::NormalStress, &options.at_normal_stress),
    ];
    let [velocity, stress] = given.map(|(option, quantity, text)| match text {
        Some(text) => arguments.measured(option, text, quantity.unit()).map(Some),
        None => Some(None),
    });
    Some([velocity?, stress?])
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
        let digits = match &options.digits {
            None => Some(DEFAULT_DIGITS),
            Some(text) => arguments.whole("--digits", Some(text), 1..=MOST_DIGITS),
        };
        let needs = "CSV: the numbers of --json have 64 bits";
        arguments.refuse_value("--digits", options.digits.as_deref().filter(|_| options.json), needs);
        let at = coordinates(options, arguments);
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
            at: at?,
        })
    }

    /// Computes the points: a table, and an object with the inputs and the points under the names of the columns.
    fn compute(&self) -> Found<'_> {
        let points = self.points();
        let mut table = Table::new("boundary", "Boundary", boundary_columns());
        points.iter().for_each(|point| table.push(boundary_row(point, self.digits as usize)));
        let answer = Answer::to(slider_json(&self.slider)).list("points", points.iter().map(part));
        Found { answer, table, picture: Box::new(move || picture(&self.slider, &points, None)) }
    }

    /// The points, computed with more digits than requested where inputs hundreds of decades apart take them.
    fn points(&self) -> Vec<BoundaryPoint> {
        let mut working_digits = self.digits;
        loop {
            let points = self.points_to(working_digits);
            if working_digits >= MOST_WORKING_DIGITS || points.iter().all(|point| self.is_enclosed(point)) {
                return points;
            }
            working_digits = working_digits.saturating_mul(4).max(100);
        }
    }

    fn points_to(&self, digits: u32) -> Vec<BoundaryPoint> {
        let curve = BoundaryCurve::new(&self.slider, digits);
        let [velocity, stress] = &self.at;
        if velocity.is_none() && stress.is_none() {
            return curve.sample(self.points, END_ERROR);
        }
        let at_velocity = velocity.iter().flat_map(|velocity| curve.at_velocity(velocity));
        let at_stress = stress.iter().flat_map(|stress| curve.at_normal_stress(stress));
        at_velocity.chain(at_stress).collect()
    }

    /// Whether every number of a point has all digits, or is zero to all of them.
    fn is_enclosed(&self, point: &BoundaryPoint) -> bool {
        let wanted = -f64::from(self.digits + GUARD_DIGITS) * std::f64::consts::LOG2_10;
        let has_digits = |ball: &Ball| ball.relative_radius_log2() < wanted;
        numbers(point).iter().all(|(_, ball)| has_digits(ball) || vanishes(ball, self.digits as usize))
    }
}

/// Draws the boundary over the axes that `new` would choose.
fn picture(
    slider: &Slider<Rational>,
    points: &[BoundaryPoint],
    error_bars: Option<&ParameterBox>,
) -> Result<String, Failure> {
    let ranges = Ranges::around(slider).map_err(Failure::Refused)?;
    Ok(boundary_picture(slider, points, error_bars, ranges.velocity.ends(), ranges.stress.ends()))
}

/// Lists the numbers of a point, under the names of their columns.
fn numbers(point: &BoundaryPoint) -> [(&'static str, &Ball); 7] {
    [
        ("double_root", &point.double_root),
        ("normal_stress_pa", &point.normal_stress_pa),
        ("loading_velocity_m_per_s", &point.loading_velocity_m_per_s),
        ("asymptote_value", &point.asymptote_value),
        ("relative_error", &point.relative_error),
        ("log10_distance", &point.log10_distance),
        ("condition_number", &point.condition_number),
    ]
}

/// States a point, with 64-bit numbers.
fn part(point: &BoundaryPoint) -> Answer {
    let words = Answer::default()
        .with("arc", point.arc.as_str())
        .with("asymptote", point.asymptote.as_str())
        .with("mark", point.mark.map(|mark| mark.as_str()));
    numbers(point).iter().fold(words, |part, (name, ball)| part.with(name, ball.to_f64()))
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
        Problem::Needs(format!(
            "about {} of memory; {} are available",
            gigabytes(needed),
            gigabytes(available)
        ))
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
