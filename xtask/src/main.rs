//! `cargo xtask`: the tasks of this repository. It depends on the standard library only.
//!
//! It builds in a second without GMP, so it can name missing programs before anything else fails.

mod accept;
mod advisories;
mod bench;
#[cfg(target_os = "linux")]
mod cluster_test;
mod failure;
mod gated;
mod interface;
mod licences;
mod lines;
mod machine;
mod open_fields;
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

use failure::Failure;

const USAGE: &str = include_str!("../usage.txt");

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("xtask: {}", failure.message);
            ExitCode::from(failure.code)
        }
    }
}

fn run(arguments: &[String]) -> Result<(), Failure> {
    let (command, rest) = arguments.split_first().ok_or_else(|| Failure::bad_input(USAGE))?;
    match command.as_str() {
        "bench" | "cost" | "coverage" | "sweep-cost" | "tables" | "timings" => bench::run(command, rest),
        "gated" => gated::run(rest),
        "lines" => lines::run(rest),
        "prove" => prove::run(rest),
        "test" => test::run(rest),
        "tie" => prove::tie(rest),
        "wheel" => wheel::run(rest),
        _ if !rest.is_empty() => {
            Err(Failure::bad_input(format!("`{command}` takes no arguments\n\n{USAGE}")))
        }
        "verify" => verify::run(),
        "accept" => accept::run(),
        "validate" => validate::run(),
        #[cfg(target_os = "linux")]
        "cluster-test" => cluster_test::run(),
        "tidy" => tidy::run(),
        "advisories" => advisories::run(),
        "licences" => licences::run(),
        "semver" => interface::semver(),
        "sources" => sources::run(),
        "wheels" => wheels::run(),
        "open-fields" => open_fields::run(),
        "machine" => machine::run(),
        "help" | "--help" | "-h" => {
            print!("{USAGE}");
            Ok(())
        }
        unknown => Err(Failure::bad_input(format!("unknown command `{unknown}`\n\n{USAGE}"))),
    }
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
