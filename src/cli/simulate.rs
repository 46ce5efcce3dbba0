//! `slipmode simulate`: the nonlinear slider at one point for people or programs, or for every row of a CSV file.

mod history;
pub mod range;
pub mod rows;
pub mod run;
pub mod view;

use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::scene::{AllowedRange, Problem};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;

use crate::cli::failure::Failure;
use crate::cli::options::{Arguments, SliderOptions};
use crate::cli::output::Output;
use crate::cli::points::{self, RowsOptions};
use crate::cli::progress::Progress;
use crate::cli::terminal;
use crate::cli::words::{LAWS, law_of_word, start_of_word};
use rows::{Answer, SimulateRows};
use run::{Settings, simulate_point};

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
    /// One JSON object instead of text
    #[arg(long, conflicts_with = "points")]
    json: bool,
    /// Also write the run from its start as CSV: time, velocity, state variable, and shear stress relative to steady sliding
    ///
    /// Time starts at 0 and strictly increases: of samples with the same 64-bit time, only the first is kept.
    #[arg(long, value_name = "OUT.csv", conflicts_with = "points")]
    trajectory: Option<PathBuf>,
    /// Duration of the trajectory, s [default: ten periods; without oscillation, until 1e-13 of the deviation is left]
    #[arg(
        long,
        value_name = "T",
        requires = "trajectory",
        conflicts_with = "points",
        allow_hyphen_values = true
    )]
    duration_s: Option<String>,
    /// Simulate every row of a CSV file; `-` reads standard input
    ///
    /// The header is that of `classify --points`, with an optional column `law`. If the simulation of a row
    /// fails, its column `status` has the reason, and the other rows continue. `outside_tested_range` is `true`
    /// if eta, kappa or beta lies outside the ranges over which simulations were tested.
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
        options.rows.refuse_without_points(&mut arguments);
        return options.single(law, settings, arguments, *progress);
    };
    options.slider.refuse_beside_points(&mut arguments);
    let settings = arguments.finish(settings)?;
    points::run(points, &options.rows, SimulateRows { law, settings }, *progress)
}

impl Options {
    fn settings(&self, arguments: &mut Arguments) -> Option<Settings> {
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = arguments.number("--tolerance", &self.tolerance, |text| range.parse(text));
        let start = arguments.number("--start", &self.start, start_of_word);
        Some(Settings { tolerance: nearest_f64(&tolerance?), start: start? })
    }

    fn single(
        &self,
        law: Option<EvolutionLaw>,
        settings: Option<Settings>,
        mut arguments: Arguments,
        progress: Progress,
    ) -> Result<(), Failure> {
        let parameters = self.slider.parameters(&mut arguments);
        if self.law.is_none() {
            arguments.fault::<()>("--law", None, Problem::Missing { allowed: LAWS.into() });
        }
        let duration_s =
            self.duration_s.as_ref().and_then(|text| arguments.measured("--duration-s", text, "s"));
        if let Some(Some(name)) = self.trajectory.as_deref().filter(|path| is_stream(path)).map(Path::to_str)
        {
            let file = Problem::Needs("a file: standard output has the result".into());
            arguments.fault::<()>("--trajectory", Some(name), file);
        }
        let ((parameters, law), settings) = arguments.finish(parameters.zip(law).zip(settings))?;
        // An output that cannot be written is reported before the work, not after it.
        let output = self.trajectory.as_deref().map(Output::create).transpose()?;
        for warning in range::outside_tested(&parameters) {
            terminal::message(&format!("warning: {warning}"));
        }
        let (found, written) = progress.spinner("simulating", || {
            let found = simulate_point(&parameters, law, settings);
            let history = output.zip(found.as_ref().ok()).map(|(output, simulation)| {
                history::write(output, &parameters, law, settings, simulation, duration_s.as_ref())
            });
            (found, history.transpose())
        });
        let answer = Answer::new(found, &parameters);
        self.print_remarks(&answer, law, settings)?;
        written.map(drop)
    }

    /// Prints what was found; a failure is an object for programs, and a message in any case.
    fn print_remarks(&self, answer: &Answer, law: EvolutionLaw, settings: Settings) -> Result<(), Failure> {
        if self.json {
            terminal::print_json(&view::json(answer))?;
        }
        match &answer.found {
            Ok(_) if self.json => Ok(()),
            Ok(simulation) => terminal::print(&view::text(simulation, law, settings)),
            Err(reason) => Err(Failure::Check(format!("error: the simulation failed: {reason}"))),
        }
    }
}

fn is_stream(path: &Path) -> bool {
    path.as_os_str() == "-"
}
