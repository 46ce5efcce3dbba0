//! `cargo xtask bench`: the benchmarks, which print ratios beside times; `--peers` runs other programs beside them.

mod players;
mod ratios;
mod row;
mod schedule;
mod write;

use crate::process;
use players::Player;

/// Everything that `--peers` does, in the order of the table.
const WORKS: [&str; 29] = [
    "signs-random",
    "signs-grid",
    "signs-disc",
    "signs-hopf",
    "signs-cusp",
    "extremes-random",
    "extremes-disc",
    "extremes-hopf",
    "extremes-cusp",
    "cubic-random",
    "cubic-disc",
    "cubic-hopf",
    "cubic-cusp",
    "hard-cases",
    "roots-50-random",
    "roots-50-hard",
    "roots-100-random",
    "roots-100-hard",
    "roots-1000-random",
    "roots-1000-hard",
    "roots-10000-random",
    "roots-10000-hard",
    "boundary-20",
    "boundary-50",
    "boundary-200",
    "cycles",
    "smooth",
    "throughput",
    "sweep",
];

/// How often every player is asked for every piece of work, in turn.
const ROUNDS: usize = 3;

/// Runs `cargo bench` with these arguments; without any, SciPy on the same simulations too.
///
/// # Errors
/// When a benchmark fails.
pub fn bench(arguments: &[String]) -> Result<(), String> {
    let bench = "bench --locked --package slipmode-bench --benches";
    process::check(process::cargo(bench).args(arguments))?;
    if arguments.is_empty() { beside_scipy() } else { Ok(()) }
}

/// Cycles by SciPy's Radau, LSODA and BDF, and by us, in one run.
fn beside_scipy() -> Result<(), String> {
    let found = players::find(|player: &Player| matches!(player.name, "slipmode" | "SciPy"))?;
    schedule::prepare()?;
    let measured = schedule::run(&found.players, &["cycles"], 1)?;
    for line in ratios::lines(&measured) {
        println!("{line}");
    }
    Ok(())
}

/// Runs every program that is found on the works that the words name by their beginning; none means all.
///
/// # Errors
/// When no work has such a name or slipmode's own part fails; a program that is missing is skipped by name.
pub fn compare(words: &[String], once: bool) -> Result<(), String> {
    let rounds = if once { 1 } else { ROUNDS };
    let wanted = |work: &&str| words.is_empty() || words.iter().any(|word| work.starts_with(word.as_str()));
    let works: Vec<&str> = WORKS.into_iter().filter(wanted).collect();
    if works.is_empty() {
        return Err(format!("--peers takes the beginnings of: {}", WORKS.join(", ")));
    }
    let found = players::find(|_| true)?;
    schedule::prepare()?;
    let measured = schedule::run(&found.players, &works, rounds)?;
    for line in ratios::lines(&measured) {
        println!("{line}");
    }
    if words.is_empty() { write::results(&found, &measured) } else { Ok(()) }
}
