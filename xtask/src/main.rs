//! `cargo xtask`: every chore of this repository by name, with nothing but the standard library.
//!
//! It builds in a second without touching GMP, so that it can say what a machine lacks before anything else fails.

mod bench;
mod bless;
#[cfg(target_os = "linux")]
mod cluster_test;
mod cost;
mod coverage;
mod failure;
mod gmp_cache;
mod judge;
mod licences;
mod machine;
mod measured_on;
mod process;
mod repository;
mod spdx;
mod sweep_cost;
mod test;
mod tidy;
mod timings;
mod verify;

use std::process::ExitCode;

use failure::Failure;

const USAGE: &str = "\
usage: cargo xtask <command> [arguments]

  verify        build, run every report under reports/, compare with its published copy
  test          format, clippy, rustdoc, tidy, licences, all tests; ends with a count
  bless         rewrite the published copy of every report, deliberately
  bench         run the benchmarks, SciPy beside the simulations (arguments are passed on to `cargo bench`);
                --peers [works]: every other program that is found, into bench-results/
  timings       copy bench-results/{peers,cost,coverage,machine}.csv into the report on the paper
  cost          how time and memory grow with points, digits, tolerance and threads, with fitted laws
  coverage      how many lines of each module the tests run, into bench-results/ (wants cargo-llvm-cov)
  sweep-cost    memory, scaling and overhead of sweeps; wants a machine without other work
  tidy          the rules of the house: floors, headers, lengths, left-overs, links
  licences      every dependency's licence against the allow list
  judge         let outside programs judge every report's page, Markdown, archive and citation
  cluster-test  a sweep on a real Slurm, one of whose nodes is killed midway (Linux)
  machine       look for the tools that the one-time build of GMP, MPFR and MPC needs

exit codes: 0 done, 1 a check failed, 2 bad usage or a machine that lacks something";

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
        "bench" => bench::run(rest),
        _ if !rest.is_empty() => {
            Err(Failure::bad_input(format!("`{command}` takes no arguments\n\n{USAGE}")))
        }
        "verify" => verify::run(),
        "test" => test::run(),
        "bless" => bless::run(),
        "judge" => judge::run(),
        #[cfg(target_os = "linux")]
        "cluster-test" => cluster_test::run(),
        "cost" => cost::run(),
        "coverage" => coverage::run(),
        "sweep-cost" => sweep_cost::run(),
        "tidy" => tidy::run(),
        "timings" => timings::run(),
        "licences" => licences::run(),
        "machine" => machine::run(),
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
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
