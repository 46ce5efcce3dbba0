//! `cargo xtask`: the tasks of this repository. It depends on the standard library only.
//!
//! It builds in a second without GMP, so it can name missing programs before anything else fails.

mod accept;
#[cfg(target_os = "linux")]
mod cluster_test;
mod dependencies;
mod failure;
mod gated;
mod interface;
mod lines;
mod machine;
mod prelude;
mod process;
mod prove;
mod repository;
mod sources;
mod test;
mod tidy;
mod validate;
mod verify;
mod wheel;
mod wheels;

use std::process::ExitCode;

use prelude::*;

const USAGE: &str = include_str!("../usage.txt");

/// A task: its name, the options of which it takes at most one, and what it does with it; without one, with an empty text.
type Task = (&'static str, &'static [&'static str], fn(&str) -> Result);

const TASKS: &[Task] = &[
    ("verify", &[], |_| verify::run()),
    ("test", &["--slow"], test::run),
    ("accept", &[], |_| accept::run()),
    ("tidy", &[], |_| tidy::run()),
    ("lines", &["--lower"], lines::run),
    ("advisories", &[], |_| dependencies::advisories()),
    ("licences", &[], |_| dependencies::licences()),
    ("validate", &[], |_| validate::run()),
    ("open-fields", &[], |_| open_fields()),
    ("prove", &["--all", "--planted-faults"], prove::run),
    ("wheel", &["--test", "--pages"], wheel::run),
    ("wheels", &[], |_| wheels::run()),
    ("sources", &[], |_| sources::run()),
    ("semver", &[], |_| interface::semver()),
    #[cfg(target_os = "linux")]
    ("cluster-test", &[], |_| cluster_test::run()),
    ("machine", &[], |_| machine::run()),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let Err(failure) = run(&arguments) else { return ExitCode::SUCCESS };
    eprintln!("xtask: {}", failure.message);
    ExitCode::from(failure.code)
}

fn run(arguments: &[String]) -> Result {
    let (name, rest) = arguments.split_first().ok_or_else(|| Failure::bad_input(USAGE))?;
    let wrong = |what: String| Err(Failure::bad_input(what));
    match name.as_str() {
        "bench" | "cost" | "coverage" | "sweep-cost" | "tables" | "timings" => return bench(name, rest),
        "gated" => return gated::run(rest),
        "tie" => return prove::tie(rest),
        "help" | "--help" | "-h" if rest.is_empty() => {
            print!("{USAGE}");
            return Ok(());
        }
        _ => {}
    }
    match (TASKS.iter().find(|(task, ..)| task == name), rest) {
        (Some((.., task)), []) => task(""),
        (Some((_, options, task)), [option]) if options.contains(&option.as_str()) => task(option),
        (Some((_, options @ [_, ..], _)), _) => {
            wrong(format!("`{name}` takes `{}` or nothing", options.join("`, `")))
        }
        (None, []) => wrong(format!("unknown command `{name}`\n\n{USAGE}")),
        _ => wrong(format!("`{name}` takes no arguments\n\n{USAGE}")),
    }
}

/// Runs a command of slipmode-bench; what is measured is built with the profile `dist`.
fn bench(command: &str, arguments: &[String]) -> Result {
    machine::run()?;
    // Some commands measure nothing: the quick build is enough for them.
    let profile = if matches!(command, "tables" | "timings") { "release" } else { "dist" };
    let run = format!("run --profile {profile} --locked --quiet --package slipmode-bench -- {command}");
    Failure::of_exit(cargo(&run).args(arguments).code()?, command)
}

/// Lists, with file and line, what only a person can state about the program and its paper, and has not stated yet.
fn open_fields() -> Result {
    let files = ["--", "metadata.toml", "paper.md", "paper.bib"];
    git(&root(), "grep --line-number").arg("OPEN FIELD: ").args(files).check()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code_of(arguments: &[&str]) -> u8 {
        let owned: Vec<String> = arguments.iter().map(ToString::to_string).collect();
        run(&owned).map_or_else(|failure| failure.code, |()| 0)
    }

    #[test]
    fn bad_usage_exits_with_2() {
        assert_eq!(code_of(&[]), 2);
        assert_eq!(code_of(&["verfiy"]), 2);
        assert_eq!(code_of(&["tidy", "--fix"]), 2);
        assert_eq!(code_of(&["help"]), 0);
    }
}
