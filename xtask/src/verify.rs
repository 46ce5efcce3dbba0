//! `cargo xtask verify`: every report run again and compared with its published copy.

use std::env;
use std::path::PathBuf;
use std::process::Command;

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
        let mut code = process::status(&mut slipmode(&["verify", &format!("reports/{name}")]))?;
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
    let mut build = process::cargo(&["build", "--release", "--locked", "--bin", "slipmode"]);
    if env::var_os("CARGO_INCREMENTAL").is_none() {
        // The first build is a tenth shorter without what makes later ones short.
        build.env("CARGO_INCREMENTAL", "0");
    }
    if machine::is_continuous_integration() {
        // The features of shared dependencies are then those of the wheel, which is built from the same parts.
        build.args(["--package", "slipmode", "--package", "slipmode-python"]);
    }
    process::check(&mut build)
}

/// A command of the release binary, in the repository's root.
pub fn slipmode(arguments: &[&str]) -> Command {
    let mut command = Command::new(release_binary());
    command.args(arguments).current_dir(repository::root());
    command
}

/// Where cargo puts the release binary: in the target folder that this program lies in too.
pub fn release_binary() -> PathBuf {
    let own = env::current_exe().unwrap_or_default();
    let target = own.ancestors().nth(2).unwrap_or(&own);
    target.join("release").join(format!("slipmode{}", env::consts::EXE_SUFFIX))
}
