//! The subcommands: the only floor that opens files, reads the clock and sets exit codes.

mod archive;
mod boundary;
mod claim;
mod classify;
mod compare;
#[cfg(test)]
mod csv_promises;
mod diff;
mod environment;
mod explore;
mod failure;
mod folder;
mod input;
mod merge;
mod new;
mod options;
mod output;
mod points;
mod progress;
mod replay;
mod report;
mod roots;
mod simulate;
mod sweep;
mod terminal;
mod tolerance;
mod tree;
mod unit_warnings;
mod words;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Failure;
use options::Arguments;
use progress::Progress;

/// Decides, proves and reports when a slider with rate-and-state friction sticks, creeps, oscillates or vibrates.
#[derive(Debug, Parser)]
#[command(version, max_term_width = 110)]
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
    /// Stability, boundary, slip mode, growth rate and frequency of one point or of every row of a CSV file; the counts of a grid
    Classify(classify::Options),
    /// The three roots of eq 8 with certified digits
    Roots(roots::Options),
    /// The exact boundary max Im(s) = 0 as CSV, whole or at one velocity or normal stress
    Boundary(boundary::Options),
    /// The nonlinear slider, simulated: mode, peak velocity, period, stress drop, each with its error
    Simulate(simulate::Options),
    /// One shard of a scene's sweep, block by block into a folder; also its plan, and scripts for Slurm
    Sweep(sweep::Options),
    /// The blocks of a sweep put together; refuses, and names the shards to run, unless every block is there once
    Merge(merge::Options),
    /// Runs of other programs, compared with the theory and with our simulation; exits with 1 unless all agree
    Compare(compare::Options),
    /// Which formula may be used where, for given relative errors
    Tolerance(tolerance::Options),
    /// One page on which b, K and M of a scene's slider can be changed: stored curves, no server
    Explore(explore::Options),
    /// A folder for a report on one's own slider, ready to be made
    New(new::Options),
    /// One scene: its tables and figures
    Run(report::RunOptions),
    /// A report folder: its page, tables, figures and ledger
    Report(report::ReportOptions),
    /// A report compared with its recorded verdicts and its published copy; exits with 1 when anything moved
    Verify(report::VerifyOptions),
    /// A report with everything it rests on in one zip file that has the same bytes everywhere
    Archive(archive::Options),
    /// An archive checked and computed anew; exits with 1 when anything differs
    Replay(replay::Options),
    /// Two ledgers or archives compared, verdict by verdict; exits with 1 when they differ
    Diff(diff::Options),
}

/// Runs the command line and gives its exit code; errors go to standard error.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version are no errors; a closed pipe is nobody's loss.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { failure::BAD_INPUT } else { 0 });
        }
    };
    match run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print();
            ExitCode::from(failure.exit_code())
        }
    }
}

fn run(cli: Cli) -> Result<(), Failure> {
    let progress = Progress::new(cli.quiet);
    start_threads(cli.threads.as_deref())?;
    match cli.command {
        Command::Classify(options) => classify::run(&options, &progress),
        Command::Roots(options) => roots::run(&options),
        Command::Boundary(options) => boundary::run(&options),
        Command::Simulate(options) => simulate::run(&options, &progress),
        Command::Sweep(options) => sweep::run(&options, &progress),
        Command::Merge(options) => merge::run(&options),
        Command::Compare(options) => compare::run(&options, progress),
        Command::Tolerance(options) => tolerance::run(&options),
        Command::Explore(options) => explore::run(&options),
        Command::New(options) => new::run(&options, &progress),
        Command::Run(options) => report::run(&options, &progress),
        Command::Report(options) => report::report(&options, &progress),
        Command::Verify(options) => report::verify(&options, &progress),
        Command::Archive(options) => archive::run(&options, &progress),
        Command::Replay(options) => replay::run(&options, &progress),
        Command::Diff(options) => diff::run(&options),
    }
}

/// The most threads that can be requested.
const MOST_THREADS: u64 = 1024;

fn start_threads(threads: Option<&str>) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let threads = arguments.whole("--threads", threads, 1..=MOST_THREADS);
    arguments.finish()?;
    let builder = rayon::ThreadPoolBuilder::new();
    let builder = match threads {
        Some(threads) => builder.num_threads(usize::try_from(threads).unwrap_or(1)),
        None => builder,
    };
    builder.build_global().map_err(|error| Failure::machine("threads cannot be started", &error))
}
