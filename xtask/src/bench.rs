//! `cargo xtask bench`, `cost`, `coverage`, `sweep-cost`, `tables` and `timings`: built and run by the package slipmode-bench.

use crate::failure::Failure;
use crate::{machine, process};

/// Runs a command of slipmode-bench in the release build.
///
/// # Errors
/// When the machine lacks a tool, the build fails, or the command does.
pub fn run(command: &str, arguments: &[String]) -> Result<(), Failure> {
    machine::run()?;
    let run = ["run", "--release", "--locked", "--quiet", "--package", "slipmode-bench", "--", command];
    match process::status(process::cargo(&run).args(arguments))? {
        0 => Ok(()),
        code => Err(Failure { code, message: format!("{command} exited with {code}") }),
    }
}
