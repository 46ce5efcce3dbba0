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

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str =
    "peers: inputs and slipmode's part for `cargo xtask bench --peers`; alone it measures nothing";

fn play(work: &str, folder: &Path) -> bool {
    match work.split_once('-').unwrap_or((work, "")) {
        ("classes", family) => classes::play(family, folder),
        ("roots", which) => cubics::play(which, folder),
        ("boundary", _) => boundary::play(folder),
        ("cycles", _) => {
            cycles::play(folder);
            elsewhere::play(folder);
        }
        ("smooth", _) => smooth::play(folder),
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
    sweep::prepare(folder);
}

fn main() -> ExitCode {
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
