//! `cargo xtask bench`, `cost`, `coverage`, `sweep-cost`, `tables` and `timings`: built and run by the package slipmode-bench.

use crate::failure::Failure;
use crate::{machine, process};

/// Commands that measure nothing: the quick build is enough for them.
const NOT_MEASURING: [&str; 2] = ["tables", "timings"];

/// Runs a command of slipmode-bench; what is measured is built with the profile `dist`.
///
/// # Errors
/// When the machine lacks a tool, the build fails, or the command does.
pub fn run(command: &str, arguments: &[String]) -> Result<(), Failure> {
    machine::run()?;
    let profile = if NOT_MEASURING.contains(&command) { "release" } else { "dist" };
    let run =
        ["run", "--profile", profile, "--locked", "--quiet", "--package", "slipmode-bench", "--", command];
    match process::status(process::cargo(&run).args(arguments))? {
        0 => Ok(()),
        code => Err(Failure { code, message: format!("{command} exited with {code}") }),
    }
}
