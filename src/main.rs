//! The command line: parse, run, exit with 0 (done), 1 (a check failed) or 2 (bad input).

// These macros panic where standard output or standard error cannot be written.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
