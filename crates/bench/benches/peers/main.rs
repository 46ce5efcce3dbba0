//! slipmode's own part among its peers, and the inputs that all of them get: run by `cargo xtask bench --peers`.
//!
//! `prepare FOLDER` writes inputs with references; `play WORK FOLDER` does one piece of work and prints a row for each way of
//! doing it. Rows are `row key=value …` with the work, the method, how many items, CPU seconds for all of them, the worst
//! error and the number of wrong answers; the players in other languages print the same.

mod boundary;
mod classes;
mod columns;
mod cubics;
mod cycles;
mod elsewhere;
mod hard;
mod random;
mod row;
mod smooth;
mod suite;
mod sweep;
mod throughput;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str =
    "peers: inputs and slipmode's part for `cargo xtask bench --peers`; alone it measures nothing";

fn play(work: &str, folder: &Path) -> bool {
    match work.split_once('-').unwrap_or((work, "")) {
        ("signs", family) => classes::play_signs(family, folder),
        ("extremes", family) => classes::play_extremes(family, folder),
        ("cubic", family) => classes::play_cubic(family, folder),
        ("roots", which) => cubics::play(which, folder),
        ("boundary", digits) => boundary::play(digits, folder),
        ("cycles", "") => cycles::play(folder),
        ("cycles", "differential-equations") => elsewhere::play(folder),
        ("smooth", _) => smooth::play(folder),
        ("throughput", _) => throughput::play(folder),
        ("sweep", _) => sweep::play(folder),
        ("hard", _) => suite::play(folder),
        _ => return false,
    }
    true
}

fn prepare(folder: &Path) {
    std::fs::create_dir_all(folder).unwrap();
    classes::prepare(folder);
    cubics::prepare(folder);
    boundary::prepare(folder);
    cycles::prepare(folder);
    smooth::prepare(folder);
    throughput::prepare(folder);
    sweep::prepare(folder);
}

fn main() -> ExitCode {
    // Cargo starts a benchmark in its package's folder; paths count from the repository's root, as for the other programs.
    if let Err(error) = std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")) {
        eprintln!("peers: the repository's root: {error}");
        return ExitCode::FAILURE;
    }
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["prepare", folder] => prepare(Path::new(folder)),
        ["play", work, folder] if play(work, Path::new(folder)) => {}
        [] => println!("{USAGE}"),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
