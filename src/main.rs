//! The command line: parse, run, exit with 0 (done), 1 (a check failed) or 2 (bad input).

/// Exact numbers are many small pieces of memory: this allocator serves them in less time, those of GMP among them.
#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    slipmode::cli::main()
}
