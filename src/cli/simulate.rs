//! `slipmode simulate`: the nonlinear slider at one point for people or programs, or for every row of a CSV file.

mod certified;
mod history;
mod kicks;
pub mod over_box;
pub mod range;
pub mod rows;
pub mod run;
pub mod view;

use std::path::PathBuf;

use clap::Args;
use slipmode::scene::{AllowedRange, Problem};
use slipmode_core::dynamics;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions};
use crate::cli::output::Output;
use crate::cli::points::{self, RowsOptions};
use crate::cli::progress::Progress;
use crate::cli::terminal;
use crate::cli::words::{LAWS, law_of_word, start_of_word};
use certified::Certified;
use history::{Extent, History};
use kicks::Kicks;
use over_box::{BoxOptions, BoxRuns, is_point};
use rows::SimulateRows;
use run::{Simulated, simulate_point};

/// The most samples of a trajectory: 500 MB of text.
const MOST_SAMPLES: u64 = 10_000_000;

/// Options of `simulate`.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    slider: SliderOptions,
    /// The evolution law, `slip` (eq 3) or `aging` (eq 2); not needed if the file of --points has a column `law`
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    law: Option<String>,
    /// Permitted relative error of peak velocity and period, 1e-15 to 1e-2; a run that cannot reach it fails
    #[arg(long, value_name = "T", default_value = "1e-8", allow_hyphen_values = true)]
    tolerance: String,
    /// State and spring at the start at V = V0/10
    ///
    /// steady-at-velocity: state and spring as in steady sliding at V; steady-state-spring-at-loading: state steady at V,
    /// spring as in steady sliding at V0; velocity-step-in-equilibrium: state steady at V0, spring in equilibrium with
    /// friction at V; velocity-kick: state and spring as in steady sliding at V0.
    #[arg(long, value_name = "WORD", default_value = "steady-at-velocity", allow_hyphen_values = true)]
    start: String,
    #[command(flatten)]
    within_error_bars: BoxOptions,
    /// One JSON object instead of text
    ///
    /// A value with an error bar is 0.009±0.001, 0.009+-0.001, 0.009(1), 0.009±5% or [0.008, 0.010]. The run is then that of the middle
    /// values, and `within_error_bars` has the sampled ranges, the modes that occur, and what the linear theory decides exactly.
    /// `stress_drop_pa` is the largest minus the least stress of the spring: on a limit cycle the stress drop, in a decay the range over the
    /// whole run, start and steady sliding included, where the stress may only rise.
    #[arg(long, conflicts_with = "points")]
    json: bool,
    /// Also prove the limit cycle or the decay, and enclose peak velocity, period and stress drop (seconds a point)
    ///
    /// `certificate` is `cycle`, `decay`, or `none` with the reason: docs/certified.md says what is proved. With small error bars
    /// (100000±1), the proof and its bounds hold for all values within them. Rows of --points then have the run of the middle values.
    #[arg(long)]
    certify: bool,
    /// Also find the smallest sudden change of velocity and of stress by which the slider leaves steady sliding (up to a minute near K_c)
    ///
    /// Below K_c every disturbance does (exact). Above K_c, kicks of rising size are tried, and the smallest that ends on a limit cycle is
    /// bisected (sampled). A velocity kick changes V alone, by up to a factor of 1e6; a stress kick changes the stress of the spring alone, by up
    /// to 10 a sigma. Kicks that follow each other before the first has decayed add up.
    #[arg(long, conflicts_with = "points")]
    smallest_kick: bool,
    /// Also write the run from its start as CSV: time, velocity, state variable, shear stress relative to steady sliding, and slip
    ///
    /// `-` writes it to standard output, and the result to standard error. Time starts at 0 and strictly increases: of samples with
    /// the same 64-bit time, only the first is kept.
    #[arg(long, value_name = "OUT.csv", conflicts_with = "points")]
    trajectory: Option<PathBuf>,
    /// Also draw velocity, shear stress and slip against time
    #[arg(long, value_name = "OUT.svg", conflicts_with = "points")]
    svg: Option<PathBuf>,
    /// Duration of the trajectory, s [default: ten periods; without oscillation, until 1e-13 of the deviation is left]
    #[arg(long, value_name = "T", conflicts_with = "points", allow_hyphen_values = true)]
    duration_s: Option<String>,
    /// Samples of the trajectory at equal steps of time, both ends included, 2 to 10 000 000 [default: eight in each step of the integrator]
    #[arg(long, value_name = "N", conflicts_with = "points", allow_hyphen_values = true)]
    samples: Option<String>,
    /// Simulate every row of a CSV file; `-` reads standard input
    ///
    /// The header is that of `classify --points`, with an optional column `law`. In a row with error bars, values are sampled ranges
    /// ([low, high]), modes are all that occur, and `status` has the number of runs. If the simulation of a row
    /// fails, its column `status` has the reason, and the other rows continue. `outside_tested_range` is `true`
    /// if a group lies outside the ranges over which simulations were tested: eta = M V0^2/(sigma a D_c) from 5e-10 to 8e5,
    /// kappa = K D_c/(a sigma) from 0.0005 to 80, beta = b/a from 0.66 to 5. `stress_drop_pa` of a decay is a range, as in --json.
    #[arg(long, value_name = "FILE.csv")]
    points: Option<PathBuf>,
    #[command(flatten)]
    rows: RowsOptions,
}

/// Runs the command.
///
/// # Errors
/// When the arguments or the rows are at fault, the output cannot be written, or the simulation of a single point fails.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let law = options.law.as_ref().and_then(|word| arguments.number("--law", word, law_of_word));
    let settings = options.settings(&mut arguments);
    let Some(points) = &options.points else {
        options.rows.refuse_without_points(false, &mut arguments);
        return options.single(law, settings, arguments, *progress);
    };
    options.slider.refuse_beside_points(&mut arguments);
    if options.certify {
        options
            .within_error_bars
            .refuse("no --certify: rows then have the run of the middle values", &mut arguments);
    }
    let box_runs = options.within_error_bars.read(&mut arguments);
    let (rows, certify, progress) = (&options.rows, options.certify, *progress);
    let options = arguments.finish(settings)?;
    if certify {
        return points::run(points, rows, SimulateRows::<true> { law, options, box_runs }, progress);
    }
    points::run(points, rows, SimulateRows::<false> { law, options, box_runs }, progress)
}

impl Options {
    fn settings(&self, arguments: &mut Arguments) -> Option<dynamics::Options> {
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = arguments.number("--tolerance", &self.tolerance, |text| range.parse(text));
        let start = arguments.number("--start", &self.start, start_of_word);
        Some(dynamics::Options { start: start?, ..dynamics::Options::at(nearest_f64(&tolerance?)) })
    }

    fn single(
        &self,
        law: Option<EvolutionLaw>,
        settings: Option<dynamics::Options>,
        mut arguments: Arguments,
        progress: Progress,
    ) -> Result<(), Failure> {
        let region = self.slider.region(None, &mut arguments);
        if region.as_ref().is_some_and(is_point) {
            self.within_error_bars.refuse("values with error bars, such as 0.009±0.001", &mut arguments);
        } else {
            let is_refused = self.smallest_kick && region.is_some();
            arguments.refuse("--smallest-kick", is_refused, "values without error bars");
        }
        let box_runs = self.within_error_bars.read(&mut arguments);
        if self.law.is_none() {
            arguments.fault::<()>("--law", None, Problem::Missing { allowed: LAWS.into() });
        }
        let extent = self.extent(&mut arguments);
        let ((region, law), settings) = arguments.finish(region.zip(law).zip(settings))?;
        let parameters = region.middle();
        // An output that cannot be written is reported before the work, not after it.
        let outputs = Output::create_both([self.trajectory.as_deref(), self.svg.as_deref()])?;
        for warning in range::outside_tested(&parameters) {
            terminal::message(&format!("warning: {warning}"));
        }
        let (found, written) = progress.spinner("simulating", || {
            let found = simulate_point(&parameters, law, settings);
            let follow = |simulation| {
                write_history(outputs, &extent, |extent| {
                    History::of(&parameters, law, settings, simulation, extent)
                })
            };
            let written = found.as_ref().ok().map(follow);
            (found, written.unwrap_or(Ok(())))
        });
        let simulated = Simulated::new(found, &parameters);
        let mut answer = view::answer(&simulated, &region, law, settings);
        if !is_point(&region) {
            let middle = simulated.found.clone();
            let runs = progress.spinner("simulating within the error bars", || {
                BoxRuns::new(middle, &region, law, settings, box_runs)
            });
            answer = answer.part("within_error_bars", runs.answer(&region));
        }
        if self.certify {
            let certified = progress.spinner("certifying", || Certified::new(&region, law, settings.start));
            answer = answer.and(certified.answer());
        }
        let mut failure = simulated.found.err();
        if self.smallest_kick {
            let kicks = progress.spinner("kicking", || Kicks::new(&parameters, law));
            let unknown = kicks.as_ref().err().map(|reason| format!("smallest kick: {reason}"));
            failure = failure.or(unknown);
            answer = answer.and(kicks.map_or_else(|_| Kicks::unknown(), |kicks| kicks.answer()));
        }
        self.print_remarks(&answer, failure)?;
        written
    }

    /// What a trajectory shall show; faults are collected in `arguments`.
    fn extent(&self, arguments: &mut Arguments) -> Extent {
        let (is_written, is_drawn) = (self.trajectory.is_some(), self.svg.is_some());
        let duration = self.duration_s.as_deref().filter(|_| !is_written && !is_drawn);
        arguments.refuse_value("--duration-s", duration, "--trajectory or --svg");
        let samples = self.samples.as_deref().filter(|_| !is_written);
        arguments.refuse_value("--samples", samples, "--trajectory: a picture has all steps");
        arguments.refuse_stream("--svg", self.svg.as_deref(), "something else");
        let trajectory = self.trajectory.as_deref().filter(|_| self.json);
        arguments.refuse_stream("--trajectory", trajectory, "something else");
        let duration_s =
            self.duration_s.as_ref().and_then(|text| arguments.measured("--duration-s", text, "s"));
        let samples = arguments.whole("--samples", self.samples.as_deref(), 2..=MOST_SAMPLES);
        Extent { duration_s, samples }
    }

    /// Prints what was found; a failure is an object for programs, and a message in any case.
    fn print_remarks(&self, answer: &Answer, failure: Option<String>) -> Result<(), Failure> {
        if self.json || failure.is_none() {
            answer.print_beside(self.json, self.trajectory.as_deref())?;
        }
        let failed = |reason| Err(Failure::Check(format!("error: the simulation failed: {reason}")));
        failure.map_or(Ok(()), failed)
    }
}

/// Writes the trajectory and its picture, as far as they are wanted; the picture always has all steps.
fn write_history(
    [csv, svg]: [Option<Output>; 2],
    extent: &Extent,
    follow: impl Fn(&Extent) -> Result<History, Failure>,
) -> Result<(), Failure> {
    csv.map_or(Ok(()), |output| output.finish(follow(extent)?.csv()))?;
    let steps = Extent { samples: None, ..extent.clone() };
    svg.map_or(Ok(()), |output| output.finish(follow(&steps)?.svg()?))
}
