//! `cargo xtask verify`: every report run again and compared with its published copy.

use crate::failure::Failure;
use crate::{machine, process, repository};

/// Checks the machine, builds the release binary and verifies every report; the worst exit code wins.
///
/// # Errors
/// With the code of `slipmode verify`: 1 on drift, 2 on bad input; also when the machine lacks a tool or the build fails.
pub fn run() -> Result<(), Failure> {
    machine::run()?;
    build_release()?;
    let mut worst = 0;
    let mut unverified = Vec::new();
    for name in repository::reports()? {
        let mut code = slipmode(&["verify"], &name)?;
        if !repository::root().join("reports").join(&name).join("published").is_dir() {
            eprintln!("verify: reports/{name} has no published copy; `cargo xtask accept` makes it");
            code = code.max(1);
        }
        if code != 0 {
            unverified.push(name);
        }
        worst = worst.max(code);
    }
    Failure::of_exit(worst, &format!("verify of {}", unverified.join(", ")))
}

/// Builds the release binary as the lock file says.
///
/// # Errors
/// When the build fails.
pub fn build_release() -> Result<(), Failure> {
    process::check(&mut process::cargo(&["build", "--release", "--locked", "--bin", "slipmode"]))
}

/// Runs one subcommand of the release binary on one report folder and returns its exit code.
///
/// # Errors
/// When cargo cannot be started.
pub fn slipmode(subcommand: &[&str], report: &str) -> Result<u8, Failure> {
    // `cargo run` finds the binary wherever the target folder is configured to be, and passes the exit code on.
    let folder = format!("reports/{report}");
    let run = ["run", "--release", "--locked", "--quiet", "--bin", "slipmode", "--"];
    process::status(process::cargo(&run).args(subcommand).arg(&folder))
}
