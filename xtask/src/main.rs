//! `cargo xtask`: the tasks of this repository. It depends on the standard library only.
//!
//! It builds in a second without GMP, so it can name missing programs before anything else fails.

mod accept;
mod advisories;
mod bench;
#[cfg(target_os = "linux")]
mod cluster_test;
mod failure;
mod gmp_cache;
mod licences;
mod lines;
mod machine;
mod open_fields;
mod process;
mod prove;
mod repository;
mod test;
mod tidy;
mod validate;
mod verify;
mod wheel;

use std::process::ExitCode;

use failure::Failure;

const USAGE: &str = "\
usage: cargo xtask <command> [arguments]

  verify        build, run every report under reports/, compare it with its published copy
  test          format, clippy, rustdoc, tidy, licences, all tests; ends with a count
  accept        rewrite the published copy of every report
  bench         run the benchmarks, with SciPy next to the simulations (arguments are passed on to `cargo bench`);
                --peers [works]: all installed competitors, results in crates/bench/results/
  timings       copy crates/bench/results/{peers,cost,coverage,machine}.csv into the report on the paper
  tables        count again, and write the tables and curves of speed and textbook methods that this report shows
  cost          measure time and memory against points, digits, tolerance and threads, and fit cost laws
  coverage      count the lines of each module that the tests run, into crates/bench/results/ (needs cargo-llvm-cov)
  sweep-cost    measure memory, scaling and overhead of sweeps, on a machine without other work
  tidy          check the source rules: order of modules, headers, lengths, wording, links
  lines         count lines of code without blank lines, comments and tests, and compare them with their bounds
  advisories    check the locked packages against the RustSec database (skipped without cargo-deny or network)
  licences      check every dependency's licence against the list of allowed licences
  validate      run external validators on every report's page, Markdown, archive and citation
  open-fields   list what only a person can state about the program and its paper: authors, addresses, identifiers
  prove         have Coq check every certified step of every published ledger as a theorem, with the lemmas in proofs/;
                files that are as proofs/checked.csv records are not checked again, but with --all;
                --planted-faults: have it refuse every altered theorem
  tie           list the claims whose hand-written theorems are about something else by now; REPORT [CLAIM...]: show claim,
                result and theorems, and tie them again in proofs/claims.csv
  wheel         build the Python package into target/wheels/; --test: install, test and check it
  cluster-test  run a sweep on a real Slurm and kill one node midway (Linux)
  machine       check for the programs that the build of GMP, MPFR and MPC needs

exit codes: 0 done, 1 a check failed, 2 bad usage or a machine that lacks a program";

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
        "prove" => prove::run(rest),
        "tie" => prove::tie(rest),
        "wheel" => wheel::run(rest),
        _ if !rest.is_empty() => {
            Err(Failure::bad_input(format!("`{command}` takes no arguments\n\n{USAGE}")))
        }
        "verify" => verify::run(),
        "test" => test::run(),
        "accept" => accept::run(),
        "validate" => validate::run(),
        #[cfg(target_os = "linux")]
        "cluster-test" => cluster_test::run(),
        "tidy" => tidy::run(),
        "advisories" => advisories::run(),
        "licences" => licences::run(),
        "lines" => lines::run(),
        "open-fields" => open_fields::run(),
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
