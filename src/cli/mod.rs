//! The subcommands: the only floor that opens files, reads the clock and sets exit codes.

// These macros panic where standard output or standard error cannot be written.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod answer;
mod archive;
mod boundary;
mod certificates;
mod check;
mod claim;
mod classify;
mod compare;
mod dialect;
mod diff;
mod environment;
mod explore;
mod failure;
mod fit;
mod folder;
mod input;
mod inputs;
mod merge;
mod new;
mod options;
mod output;
mod path_text;
mod planted_faults;
mod points;
mod progress;
mod replay;
mod report;
mod roots;
mod shell;
mod simulate;
mod solve;
mod streams;
mod sweep;
mod table;
mod terminal;
mod theorems;
mod tolerance;
mod tree;
mod unit_warnings;
mod words;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use failure::Failure;
use options::Arguments;
use progress::Progress;
use slipmode::scene::{LONGEST_MESSAGE, Quantity, Uncertain, with_short_quotations};

pub use classify::call::{capture_grid, capture_point};
pub use classify::grid_files::GridPicture;
pub use classify::rows::RESULT_COLUMNS;
pub use classify::view::{ClassifiedPoint, Derived};
pub use options::inertial_threshold;
pub use roots::capture_roots;
pub use streams::Captured;
pub use table::{TableColumns, capture_columns, capture_rows};
pub use unit_warnings::unit_warnings;

/// What the exit codes mean.
const EXIT_CODES: &str = "Exit codes:
  0  the command did what it was asked
  1  a check failed: a verdict or a published byte moved, runs disagree, an archive is not what it states, blocks are missing
  2  the input is at fault or an output cannot be written; nothing was written";

/// Decides, proves and reports when a slider with rate-and-state friction sticks, creeps, oscillates or vibrates.
#[derive(Debug, Parser)]
#[command(version, long_version = environment::long_version(), after_help = EXIT_CODES, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Number of threads; results do not depend on it [default: one per core]
    #[arg(long, global = true, value_name = "N", allow_hyphen_values = true)]
    threads: Option<String>,
    /// No progress bar
    #[arg(long, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Computes stability, slip mode, growth rate and frequency of one point or of every row of a CSV file, or counts them on a grid
    #[command(after_help = example("classify SLIDER -s 5MPa -v 10um/s"))]
    Classify(classify::Options),
    /// Computes the three roots of eq 8 with certified digits
    #[command(after_help = example("roots SLIDER -s 5MPa -v 10um/s"))]
    Roots(roots::Options),
    /// Writes the exact boundary max Im(s) = 0 as CSV, complete or at one velocity or normal stress
    #[command(after_help = example("boundary SLIDER --at-velocity 10um/s"))]
    Boundary(boundary::Options),
    /// Solves for the normal stress, loading velocity, stiffness or mass with a stated frequency, growth rate, or place on the transition or boundary
    #[command(after_help = example("solve SLIDER -v 10um/s --for normal-stress --transition"))]
    Solve(solve::Options),
    /// Simulates the nonlinear slider: mode, peak velocity, period and stress drop with their errors
    #[command(after_help = example("simulate SLIDER -s 5MPa -v 10um/s --law aging"))]
    Simulate(simulate::Options),
    /// Fits a, b, D_c and more to a record of velocity steps, with 95 % intervals
    #[command(after_help = example("fit record.csv -s 5MPa -k 2e9"))]
    Fit(fit::Options),
    /// Computes one shard of a scene's sweep, block by block, into a folder; also plans the sweep and writes scripts for Slurm
    #[command(after_help = example("sweep sweep.toml --out blocks"))]
    Sweep(sweep::Options),
    /// Joins the blocks of a sweep; if blocks are missing, names the shards to run
    #[command(after_help = example("merge blocks --output all.csv"))]
    Merge(merge::Options),
    /// Compares runs of other programs with the theory and with our simulation; exits with 1 unless all agree
    #[command(after_help = example("compare --runs runs.csv"))]
    Compare(compare::Options),
    /// Proves all certificates of a scene again, or certifies the points of its grid anew; exits with 1 if one is not proved
    #[command(after_help = example("certificates scene.toml"))]
    Certificates(certificates::Options),
    /// Prints where each formula may be used, for given relative errors
    #[command(after_help = example("tolerance SLIDER -e 0.01"))]
    Tolerance(tolerance::Options),
    /// Writes a page on which all seven values of a scene can be changed; it needs no server
    #[command(after_help = example("explore scene.toml --output scene.html"))]
    Explore(explore::Options),
    /// Writes a folder for a report on your own slider
    #[command(after_help = example("new lab SLIDER -s 5MPa -v 10um/s"))]
    New(new::Options),
    /// Computes one scene: its tables and figures
    #[command(after_help = example("run scene.toml"))]
    Run(report::RunOptions),
    /// Computes a report: its page, tables, figures and ledger
    #[command(after_help = example("report lab"))]
    Report(report::ReportOptions),
    /// Computes a report and compares it with its recorded verdicts and its published copy; exits with 1 if anything differs
    #[command(after_help = example("verify lab"))]
    Verify(report::VerifyOptions),
    /// Decides the claims of one file with its equations; exits with 1 if a verdict is not the expected one
    #[command(after_help = example("check statements.toml"))]
    Check(check::Options),
    /// Packs a report and all its inputs into one zip file, with the same bytes everywhere
    #[command(after_help = example("archive lab --output lab.zip"))]
    Archive(archive::Options),
    /// Checks an archive and computes it again; exits with 1 if anything differs
    Replay(replay::Options),
    /// Compares two ledgers or archives, verdict by verdict; exits with 1 if they differ
    #[command(after_help = example("diff lab.zip revised.zip"))]
    Diff(diff::Options),
    /// Prints a script that completes commands and options in a shell
    #[command(after_help = example("completions bash"))]
    Completions(shell::CompletionsOptions),
    /// Prints the manual page of slipmode or of a command, for `man -l -`
    #[command(after_help = example("man classify"))]
    Man(shell::ManOptions),
    /// Writes the certified steps of ledgers as theorems for Coq
    #[command(hide = true)]
    Theorems(theorems::Options),
}

/// An example for the help of a command.
fn example(command: &str) -> String {
    let command = command.replace("SLIDER", "-a 0.009 -b 0.0126 -d 8um -k 2e9 -m 2400");
    format!("Example:\n  slipmode {command}")
}

/// Runs the command line of this process and gives its exit code; errors go to standard error.
#[must_use]
pub fn main() -> ExitCode {
    ExitCode::from(main_with(std::env::args_os()))
}

/// Runs the command line with these arguments, the program's name first, and gives its exit code.
///
/// It starts threads and catches signals: a process calls it once.
pub fn main_with(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let as_json = asks_for_json(&arguments);
    let cli = match Cli::try_parse_from(&arguments) {
        Ok(cli) => cli,
        Err(error) => {
            let error = without_usage_of_conflict(error);
            let own = unit_apart(&arguments).or_else(|| shortened_usage(&error));
            match &own {
                Some(text) => terminal::message(text),
                // Help and version are no errors. Where they cannot be written, the exit code is the same.
                None => _ = error.print(),
            }
            if as_json && error.use_stderr() {
                terminal::print_json_usage(&own.unwrap_or_else(|| error.render().to_string()));
            }
            return exit_code_of_usage(&error);
        }
    };
    ended(run(cli), as_json).1
}

/// Runs a command as a function: what it would write to the standard streams is returned.
///
/// The first argument is the name of the program. No signal is caught and no thread pool is started. The command must not read
/// standard input.
///
/// ```
/// let slider = "-a 0.004 -b 0.006 -d 10um -k 1e7 -m 1000 -s 1MPa -v 10um/s";
/// let arguments = format!("slipmode classify {slider} --json");
/// let found = slipmode::cli::capture(arguments.split(' ').map(Into::into));
/// assert_eq!(found.exit_code, 0);
/// assert!(String::from_utf8(found.output).unwrap().contains("\"slip_mode\": \"stick-slip\""));
/// ```
pub fn capture(arguments: impl IntoIterator<Item = OsString>) -> Captured {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let cli = match Cli::try_parse_from(&arguments) {
        Ok(cli) => cli,
        Err(error) => {
            let error = without_usage_of_conflict(error);
            let text = shortened_usage(&error).unwrap_or_else(|| error.render().to_string());
            let is_fault = error.use_stderr();
            let as_json = is_fault && asks_for_json(&arguments);
            let ((), json) = streams::written_by(|| {
                if as_json {
                    terminal::print_json_usage(&text);
                }
            });
            let text = text.into_bytes();
            let (output, messages) = if is_fault { (json.output, text) } else { (text, Vec::new()) };
            return Captured { exit_code: exit_code_of_usage(&error), output, messages };
        }
    };
    captured(asks_for_json(&arguments), || dispatch(cli.command, Progress::new(true))).1
}

/// Does a part of a command as a function: returns its result unless it fails, and what it would write to the standard streams.
fn captured<T>(as_json: bool, work: impl FnOnce() -> Result<T, Failure>) -> (Option<T>, Captured) {
    let ((done, exit_code), written) = streams::written_by(|| ended(work(), as_json));
    (done, Captured { exit_code, ..written })
}

/// The result of a command and its exit code; a failure is printed.
fn ended<T>(result: Result<T, Failure>, as_json: bool) -> (Option<T>, u8) {
    match result {
        Ok(done) => (Some(done), 0),
        Err(failure) => {
            failure.print(as_json);
            (None, failure.exit_code())
        }
    }
}

/// Whether a program reads what the command prints.
fn asks_for_json(arguments: &[OsString]) -> bool {
    arguments.iter().any(|argument| argument == "--json")
}

/// The usage line would combine the very options that exclude each other.
fn without_usage_of_conflict(mut error: clap::Error) -> clap::Error {
    if error.kind() == clap::error::ErrorKind::ArgumentConflict {
        error.remove(clap::error::ContextKind::Usage);
    }
    error
}

/// A message about a unit that is an argument of its own, as in `-d 8 um`; none without one.
fn unit_apart(arguments: &[OsString]) -> Option<String> {
    let words: Vec<&str> = arguments.iter().map(|argument| argument.to_str().unwrap_or_default()).collect();
    words.windows(3).find_map(|three| {
        let [option, number, unit] = *three else { return None };
        let value = format!("{number}{unit}");
        let is_number = |quantity: Quantity, text: &str| Uncertain::of(quantity, text).is_ok();
        let is_apart = option.starts_with('-')
            && unit.starts_with(char::is_alphabetic)
            && is_number(Quantity::DirectEffect, number)
            && Quantity::ALL.into_iter().any(|quantity| is_number(quantity, &value));
        is_apart.then(|| {
            format!(
                "error: {option} {number} {unit}: a unit belongs to its value: write {option} {value}, or {option} \"{number} {unit}\""
            )
        })
    })
}

/// A message about wrong arguments that repeats long ones, shortened; none for other messages.
fn shortened_usage(error: &clap::Error) -> Option<String> {
    let text = error.render().to_string();
    let is_long = error.use_stderr() && text.chars().count() > LONGEST_MESSAGE;
    is_long.then(|| with_short_quotations(text.trim_end(), LONGEST_MESSAGE))
}

fn exit_code_of_usage(error: &clap::Error) -> u8 {
    if error.use_stderr() { failure::BAD_INPUT } else { 0 }
}

fn run(cli: Cli) -> Result<(), Failure> {
    if cli.threads.is_some() || !cli.command.is_of_one_thread() {
        start_threads(cli.threads.as_deref())?;
    }
    dispatch(cli.command, Progress::new(cli.quiet))
}

fn dispatch(command: Command, progress: Progress) -> Result<(), Failure> {
    match command {
        Command::Classify(options) => classify::run(&options, &progress),
        Command::Roots(options) => roots::run(&options),
        Command::Boundary(options) => boundary::run(&options),
        Command::Solve(options) => solve::run(&options, &progress),
        Command::Simulate(options) => simulate::run(&options, &progress),
        Command::Fit(options) => fit::run(&options, &progress),
        Command::Sweep(options) => sweep::run(&options, &progress),
        Command::Merge(options) => merge::run(&options),
        Command::Compare(options) => compare::run(&options, progress),
        Command::Certificates(options) => certificates::run(&options, &progress),
        Command::Tolerance(options) => tolerance::run(&options),
        Command::Explore(options) => explore::run(&options),
        Command::New(options) => new::run(&options, &progress),
        Command::Run(options) => report::run(&options, &progress),
        Command::Report(options) => report::report(&options, &progress),
        Command::Verify(options) => report::verify(&options, &progress),
        Command::Check(options) => check::run(&options),
        Command::Archive(options) => archive::run(&options, &progress),
        Command::Replay(options) => replay::run(&options, &progress),
        Command::Diff(options) => diff::run(&options),
        Command::Completions(options) => shell::completions(&options, Cli::command()),
        Command::Man(options) => shell::man(&options, Cli::command()),
        Command::Theorems(options) => theorems::run(&options),
    }
}

impl Command {
    /// Whether the command needs no threads beside its own: starting them is a tenth of the time of a short command.
    fn is_of_one_thread(&self) -> bool {
        match self {
            Self::Classify(options) => options.is_of_one_point(),
            Self::Roots(_) | Self::Tolerance(_) | Self::Diff(_) | Self::Completions(_) | Self::Man(_) => true,
            _ => false,
        }
    }
}

/// The most threads that can be requested.
const MOST_THREADS: u64 = 1024;

fn start_threads(threads: Option<&str>) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let threads = arguments.whole("--threads", threads, 1..=MOST_THREADS);
    let threads = arguments.finish(Some(threads))?;
    // Zero is rayon's word for its default: one per core.
    let threads = threads.map_or(0, |threads| usize::try_from(threads).unwrap_or(1));
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build_global().map_err(|error| Failure::machine("threads cannot be started", &error))
}
