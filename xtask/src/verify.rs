//! `cargo xtask verify`: every report run again and compared with its published copy.

use crate::prelude::*;
use crate::{machine, repository};

/// Builds the release binary and verifies every report; the worst exit code wins.
///
/// # Errors
/// With the code of `slipmode verify`: 1 on drift, 2 on bad input; also when the machine lacks a tool or the build fails.
pub fn run() -> Result {
    build()?;
    let (mut worst, mut unverified) = (0, Vec::new());
    for name in repository::reports()? {
        let mut code = slipmode("verify").arg(format!("reports/{name}")).code()?;
        if !root().join("reports").join(&name).join("published").is_dir() {
            eprintln!("verify: reports/{name} has no published copy; `cargo xtask accept` makes it");
            code = code.max(1);
        }
        unverified.extend((code != 0).then_some(name));
        worst = worst.max(code);
    }
    Failure::of_exit(worst, &format!("verify of {}", unverified.join(", ")))
}

/// The profile of the program that the tasks run: in continuous integration that of the tests, so that all is compiled once.
pub fn profile() -> &'static str {
    if machine::is_continuous_integration() { "ci" } else { "release" }
}

/// Checks the machine, and builds the binary that the tasks run, as the lock file says.
///
/// # Errors
/// When the machine lacks a tool or the build fails.
pub fn build() -> Result {
    machine::run()?;
    let mut command = cargo(&format!("build --profile {} --locked --bin slipmode", profile()));
    // The first build is a tenth shorter without what makes later ones short.
    command.env("CARGO_INCREMENTAL", env::var_os("CARGO_INCREMENTAL").unwrap_or_else(|| "0".into()));
    if machine::is_continuous_integration() {
        // The features of shared dependencies are then those of the wheel and of the tests, which are built from the same parts.
        command.args(["--package", "slipmode", "--package", "slipmode-python"]);
    }
    command.check()
}

/// A command of this binary, in the repository's root.
pub fn slipmode(words: &str) -> Command {
    program(binary(), words)
}

/// The folder of what cargo builds, in which this program lies, too.
pub fn target() -> PathBuf {
    let own = env::current_exe().unwrap_or_default();
    own.ancestors().nth(2).unwrap_or(&own).to_path_buf()
}

/// Where cargo puts this binary: in the target folder that this program lies in too.
pub fn binary() -> PathBuf {
    target().join(profile()).join(format!("slipmode{}", env::consts::EXE_SUFFIX))
}
