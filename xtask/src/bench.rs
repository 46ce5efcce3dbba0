//! `cargo xtask bench`, `cost`, `coverage`, `sweep-cost`, `tables` and `timings`: built and run by the package slipmode-bench.

use crate::failure::Failure;
use crate::{machine, process};

/// Runs a command of slipmode-bench; what is measured is built with the profile `dist`.
///
/// # Errors
/// When the machine lacks a tool, the build fails, or the command does.
pub fn run(command: &str, arguments: &[String]) -> Result<(), Failure> {
    machine::run()?;
    // Some commands measure nothing: the quick build is enough for them.
    let profile = if matches!(command, "tables" | "timings") { "release" } else { "dist" };
    let run =
        ["run", "--profile", profile, "--locked", "--quiet", "--package", "slipmode-bench", "--", command];
    Failure::of_exit(process::status(process::cargo(&run).args(arguments))?, command)
}
