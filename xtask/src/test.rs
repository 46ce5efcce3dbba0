//! `cargo xtask test`: every check of the repository in one command, and a count of the tests at the end.

use std::process::Command;
use std::time::Instant;

use crate::failure::Failure;
use crate::{interface, licences, lines, machine, process, tidy, verify};

/// A step's name and what it does.
pub type Step = (&'static str, fn() -> Result<(), Failure>);

const STEPS: [Step; 7] = [
    ("fmt", format),
    ("tidy", tidy::run),
    ("lines", || lines::run(&[])),
    ("licences", licences::run),
    ("clippy", clippy),
    ("core without features", core_without_features),
    ("rustdoc", rustdoc),
];

/// Runs all steps, even after one has failed, then all tests; ends with `N passed, N failed`.
///
/// # Errors
/// When any step or any test fails.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let is_slow = arguments == ["--slow"];
    if !is_slow && !arguments.is_empty() {
        return Err(Failure::bad_input("`test` takes `--slow` or nothing"));
    }
    machine::run()?;
    machine::require(&["fmt", "clippy"])?;
    let mut failed = Vec::new();
    for (name, step) in STEPS {
        if let Err(failure) = timed(name, step) {
            eprintln!("{}", failure.message);
            failed.push(name);
        }
    }
    let mut count = Count::default();
    if timed("tests", || tests(&mut count, is_slow)).is_err() {
        failed.push("tests");
    }
    println!();
    if !failed.is_empty() {
        println!("failed: {}", failed.join(", "));
    }
    println!("{} passed, {} failed", count.passed, count.failed);
    if failed.is_empty() { Ok(()) } else { Err(Failure::check(format!("failed: {}", failed.join(", ")))) }
}

fn timed(name: &str, step: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    println!("== {name}");
    let start = Instant::now();
    let result = step();
    let word = if result.is_ok() { "ok" } else { "FAILED" };
    println!("== {name} {word} ({:.1} s)", start.elapsed().as_secs_f64());
    result
}

fn format() -> Result<(), Failure> {
    process::check(&mut process::cargo(&["fmt", "--all", "--check"]))
}

/// A command of cargo. Where continuous integration runs, the profile is the one that all its steps share; elsewhere it is the one
/// that is compiled soonest after an edit.
fn cargo(command: &str, arguments: &[&str]) -> Command {
    let mut command = process::cargo(&[command]);
    if machine::is_continuous_integration() {
        command.args(["--profile", verify::profile()]);
    }
    command.args(arguments);
    command
}

fn clippy() -> Result<(), Failure> {
    let arguments = ["--workspace", "--all-targets", "--locked", "--quiet", "--", "--deny", "warnings"];
    process::check(&mut cargo("clippy", &arguments))
}

fn core_without_features() -> Result<(), Failure> {
    let arguments = ["--package", "slipmode-core", "--no-default-features", "--locked", "--quiet"];
    process::check(&mut cargo("check", &arguments))
}

fn rustdoc() -> Result<(), Failure> {
    let mut command = cargo("doc", &["--workspace", "--no-deps", "--locked", "--quiet"]);
    process::check(command.env("RUSTDOCFLAGS", "--deny warnings"))?;
    interface::count(&verify::target())
}

fn tests(count: &mut Count, is_slow: bool) -> Result<(), Failure> {
    let mut command = cargo("test", &["--workspace", "--locked", "--no-fail-fast"]);
    if is_slow {
        command.env("SLIPMODE_SLOW", "1");
    }
    let code = process::listen(&mut command, |line| count.hear(line))?;
    if code == 0 && count.failed == 0 && count.passed > 0 {
        return Ok(());
    }
    // A test program that was not built, or that died, prints no count: it is a failure all the same.
    count.failed = count.failed.max(1);
    Err(Failure::check(format!("cargo test exited with {code}")))
}

/// Tests passed and failed, summed over all test programs.
#[derive(Debug, Default, PartialEq, Eq)]
struct Count {
    passed: u64,
    failed: u64,
}

impl Count {
    /// Adds a line such as `test result: ok. 12 passed; 0 failed; …`; any other line changes nothing.
    fn hear(&mut self, line: &str) {
        let Some(result) = line.strip_prefix("test result: ") else { return };
        let (_, counts) = result.split_once(". ").unwrap_or_default();
        for part in counts.split("; ") {
            match part.split_once(' ') {
                Some((number, "passed")) => self.passed += number.parse::<u64>().unwrap_or(0),
                Some((number, "failed")) => self.failed += number.parse::<u64>().unwrap_or(0),
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn result_lines_are_summed_and_all_others_ignored() {
        let mut count = Count::default();
        for line in [
            "running 3 tests",
            "test a ... ok",
            "test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s",
            "test result: FAILED. 10 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.00s",
            "note: test result: ok. 100 passed; 100 failed",
        ] {
            count.hear(line);
        }
        assert_eq!(count, Count { passed: 13, failed: 2 });
    }
}
