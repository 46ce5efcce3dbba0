//! `cargo xtask test`: every check of the repository in one command, and a count of the tests at the end.

use std::thread;

use crate::prelude::*;
use crate::{dependencies, interface, lines, machine, tidy, verify};

/// A step's name and what it does.
pub type Step = (&'static str, fn() -> Result);

const STEPS: [Step; 7] = [
    ("fmt", || cargo("fmt --all --check").check()),
    ("tidy", tidy::run),
    ("lines", || lines::run("")),
    ("licences", dependencies::licences),
    ("clippy", || profiled("clippy --workspace --all-targets --locked --quiet -- --deny warnings").check()),
    ("bare core", || profiled("check -p slipmode-core --no-default-features --locked --quiet").check()),
    ("rustdoc", || {
        let mut doc = profiled("doc --workspace --no-deps --locked --quiet");
        doc.env("RUSTDOCFLAGS", "--deny warnings").check()?;
        interface::count(&verify::target())
    }),
];

/// Runs all steps, even after one has failed, then all tests; ends with `N passed, N failed`. With `--slow`, slow tests have all repetitions.
///
/// # Errors
/// When any step or any test fails.
pub fn run(option: &str) -> Result {
    machine::run()?;
    machine::require(&["fmt", "clippy"])?;
    let mut failed = Vec::new();
    for (name, step) in STEPS {
        if let Err(failure) = timed(name, step) {
            eprintln!("{}", failure.message);
            failed.push(name);
        }
    }
    let mut count = [0, 0];
    let passed = timed("tests", || tests(&mut count, option == "--slow"));
    failed.extend(passed.is_err().then_some("tests"));
    println!();
    let failed = failed.join(", ");
    if !failed.is_empty() {
        println!("failed: {failed}");
    }
    println!("{} passed, {} failed", count[0], count[1]);
    ensure(failed.is_empty(), || Failure::check(format!("failed: {failed}")))
}

fn timed(name: &str, step: impl FnOnce() -> Result) -> Result {
    println!("== {name}");
    let start = Instant::now();
    let result = step();
    let word = if result.is_ok() { "ok" } else { "FAILED" };
    println!("== {name} {word} ({:.1} s)", start.elapsed().as_secs_f64());
    result
}

/// A command of cargo. Where continuous integration runs, the profile is the one that all its steps share; elsewhere it is the one
/// that is compiled soonest after an edit.
fn profiled(words: &str) -> Command {
    let (command, rest) = words.split_once(' ').unwrap_or((words, ""));
    let is_shared = machine::is_continuous_integration();
    let profile = if is_shared { format!("--profile {}", verify::profile()) } else { String::new() };
    cargo(&format!("{command} {profile} {rest}"))
}

fn tests(count: &mut Count, is_slow: bool) -> Result {
    // Some tests wait for a prepared state that another one makes.
    let threads = thread::available_parallelism().map_or(1, usize::from) + 1;
    let code = profiled("test --workspace --locked --no-fail-fast")
        .env("RUST_TEST_THREADS", threads.to_string())
        .envs(is_slow.then_some(("SLIPMODE_SLOW", "1")))
        .listen(|line| hear(count, line))?;
    let is_passed = code == 0 && count[0] > 0 && count[1] == 0;
    // A test program that was not built, or that died, prints no count: it is a failure all the same.
    count[1] = count[1].max(u64::from(!is_passed));
    ensure(is_passed, || Failure::check(format!("cargo test exited with {code}")))
}

/// Tests passed and failed, summed over all test programs.
type Count = [u64; 2];

/// Adds a line such as `test result: ok. 12 passed; 0 failed; …`; any other line changes nothing.
fn hear([passed, failed]: &mut Count, line: &str) {
    let words: Vec<&str> = line.split(' ').collect();
    if let ["test", "result:", _, good, "passed;", bad, "failed;", ..] = words[..] {
        *passed += good.parse::<u64>().unwrap_or(0);
        *failed += bad.parse::<u64>().unwrap_or(0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn result_lines_are_summed_and_all_others_ignored() {
        let mut count = [0, 0];
        for line in [
            "running 3 tests",
            "test a ... ok",
            "test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s",
            "test result: FAILED. 10 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.00s",
            "note: test result: ok. 100 passed; 100 failed",
        ] {
            hear(&mut count, line);
        }
        assert_eq!(count, [13, 2]);
    }
}
