//! The command line: parse, run, exit with 0 (done), 1 (a check failed) or 2 (bad input).

fn main() -> std::process::ExitCode {
    slipmode::cli::main()
}
