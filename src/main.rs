//! The command line: parse, run, exit with 0 (done), 1 (a check failed) or 2 (bad input).

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
