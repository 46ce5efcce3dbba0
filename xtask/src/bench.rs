//! `cargo xtask bench`: the benchmarks, which print ratios beside times.

use crate::failure::Failure;
use crate::{machine, process};

/// Runs `cargo bench` for the package and passes all further arguments on.
///
/// # Errors
/// When the machine lacks a tool or a benchmark fails.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    machine::run()?;
    let mut command = process::cargo(&["bench", "--locked", "--package", "slipmode", "--benches"]);
    process::check(command.args(arguments))
}
