//! `slipmode boundary`: the exact boundary max Im(s) = 0 as CSV, along its arcs or at one velocity or normal stress.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use slipmode::experiments::boundary::END_ERROR;
use slipmode::experiments::boundary::{boundary_columns, boundary_row, vanishes};
use slipmode::scene::{AllowedRange, Limits, Problem, Quantity};
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::boundary::{BoundaryCurve, BoundaryPoint};
use slipmode_plot::table::Table;

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, MaterialOptions, SliderOptions};
use crate::cli::output::{Output, machine_write};
use crate::cli::roots::MOST_DIGITS;

/// Working digits beyond which no input in the allowed range hides a point: its groups span less than 10 000 decades.
const MOST_WORKING_DIGITS: u32 = 100_000;

/// Options of `boundary`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: SliderOptions,
    /// Points on each arc, in addition to the marked ones (cusp and corners)
    #[arg(long, value_name = "N", default_value = "200", allow_hyphen_values = true)]
    points: String,
    /// Significant digits, 1 to 1 000 000; only certain digits are printed, and 0 for an error that is zero to all of them
    #[arg(long, value_name = "D", default_value = "20", allow_hyphen_values = true)]
    digits: String,
    /// Only the points of the boundary at this loading velocity, m/s
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    at_velocity: Option<String>,
    /// Only the points of the boundary at this normal stress, Pa
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    at_normal_stress: Option<String>,
    /// Raises the limit on --points [default: 4 194 304]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    max_points: Option<String>,
    /// Where to write; `-` is standard output
    #[arg(short, long, value_name = "OUT.csv", default_value = "-")]
    output: PathBuf,
}

/// What was requested, valid.
struct Request {
    slider: Slider<Rational>,
    points: usize,
    digits: u32,
    at_velocity: Option<Rational>,
    at_normal_stress: Option<Rational>,
}

/// Runs the command.
///
/// # Errors
/// When the arguments are at fault or the output cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let request = Request::read(options, &mut arguments);
    arguments.finish()?;
    let Some(request) = request else { return Ok(()) };
    let mut output = Output::create(&options.output)?;
    let table = request.table();
    output.write_all(table.to_csv().as_bytes()).map_err(|error| machine_write(&error))?;
    output.commit()?;
    if table.rows.is_empty() {
        eprintln!("the boundary has no point there");
    }
    Ok(())
}

impl Request {
    fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        let slider = slider(&options.slider, arguments);
        let limit = arguments.whole("--max-points", options.max_points.as_deref(), 2..=u64::from(u32::MAX));
        let limit = limit.unwrap_or(Limits::default().max_points);
        let points = arguments.whole("--points", Some(&options.points), 2..=u64::MAX);
        let points = points.filter(|points| *points <= limit).or_else(|| {
            let points = points?.to_string();
            let problem = Problem::TooManyPoints { points, limit };
            arguments.fault("--points", Some(&options.points), problem)
        });
        let digits = arguments.whole("--digits", Some(&options.digits), 1..=MOST_DIGITS);
        let mut coordinate = |option, text: &Option<String>| match text {
            Some(text) => arguments.number(option, text, |text| AllowedRange::PHYSICAL.parse(text)).map(Some),
            None => Some(None),
        };
        let at_velocity = coordinate("--at-velocity", &options.at_velocity);
        let at_normal_stress = coordinate("--at-normal-stress", &options.at_normal_stress);
        Some(Self {
            slider: slider?,
            points: usize::try_from(points?).ok()?,
            digits: u32::try_from(digits?).ok()?,
            at_velocity: at_velocity?,
            at_normal_stress: at_normal_stress?,
        })
    }

    /// The table of the points that were requested.
    fn table(&self) -> Table {
        let mut table = Table::new("boundary", "Boundary", boundary_columns());
        self.points().iter().for_each(|point| table.push(boundary_row(point, self.digits as usize)));
        table
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
        if self.at_velocity.is_none() && self.at_normal_stress.is_none() {
            return curve.sample(self.points, END_ERROR);
        }
        let at_velocity = self.at_velocity.iter().flat_map(|velocity| curve.at_velocity(velocity));
        let at_stress = self.at_normal_stress.iter().flat_map(|stress| curve.at_normal_stress(stress));
        at_velocity.chain(at_stress).collect()
    }

    /// Whether every number of a point has a digit, or is zero to all of them.
    fn is_enclosed(&self, point: &BoundaryPoint) -> bool {
        let numbers = [
            &point.double_root,
            &point.normal_stress_pa,
            &point.loading_velocity_m_per_s,
            &point.asymptote_value,
            &point.relative_error,
            &point.log10_distance,
            &point.condition_number,
        ];
        let has_digits = |ball: &Ball| ball.relative_radius_log2() < -4.0;
        numbers.into_iter().all(|ball| has_digits(ball) || vanishes(ball, self.digits as usize))
    }
}

/// The slider without its operating point: σ and V0 are what is sought, and are checked but not used when given.
fn slider(options: &SliderOptions, arguments: &mut Arguments) -> Option<Slider<Rational>> {
    let [a, b, d, k, m] = MaterialOptions::QUANTITIES.map(|quantity| options.required(quantity, arguments));
    for sought in [Quantity::NormalStress, Quantity::LoadingVelocity] {
        if options.text(sought).is_some() {
            options.required(sought, arguments)?;
        }
    }
    Some(Slider::from([a?, b?, d?, k?, m?]))
}
