//! The benchmarks' commands, which `cargo xtask` calls by the same names: timings, costs and test coverage of slipmode.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use slipmode_bench::{certified, copied, cost, coverage, peers, sweep_cost, tables};

/// Measures slipmode and other programs on the same inputs.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask")]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run the benchmarks; with --peers, every other program that is found, into crates/bench/results
    Bench {
        /// Run other programs on the same inputs; words name works by their beginning, none means all
        #[arg(long)]
        peers: bool,
        /// Measure certified runs beside plain ones, and draw docs/certified-cost.svg
        #[arg(long, conflicts_with_all = ["peers", "words"])]
        certified: bool,
        /// One round instead of three
        #[arg(long, requires = "peers")]
        once: bool,
        /// Works, or arguments for `cargo bench`
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        words: Vec<String>,
    },
    /// Measure how time and memory grow with points, digits, tolerance and threads; fail where neighbours differ too much
    Cost {
        /// Only the sweeps whose neighbours are compared
        #[arg(long)]
        sweeps: bool,
    },
    /// Count the lines of each module that the tests run
    Coverage,
    /// Measure memory, scaling and overhead of sweeps
    SweepCost,
    /// Count again, and write what the report on the paper shows of counts and times
    Tables {
        /// The report's folder
        #[arg(default_value = "reports/im-avouac")]
        report: PathBuf,
    },
    /// Copy what was measured into the report on the paper; `tables` tabulates it
    Timings,
}

fn main() -> ExitCode {
    let done = match CommandLine::parse().command {
        Command::Bench { certified: true, .. } => certified::run(),
        Command::Bench { peers: true, once, words, .. } => peers::compare(&words, once),
        Command::Bench { words, .. } => peers::bench(&words),
        Command::Cost { sweeps } => cost::run(!sweeps),
        Command::Coverage => coverage::run(),
        Command::SweepCost => sweep_cost::run(),
        Command::Tables { report } => tables::run(&report),
        Command::Timings => copied::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
