//! Wall time, CPU time and peak memory of one run of a program.
//!
//! Memory and CPU time are read from `/proc` every half millisecond while the program runs, the latter once more, to a hundredth of
//! a second, when it has ended but has not been waited for. Where there is no `/proc` both are 0.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Runs of a command; the fastest counts, as everything that disturbs a run makes it slower.
const RUNS: usize = 3;

/// A run that takes longer is not repeated.
const LONG_S: f64 = 5.0;

/// The unit of times in `/proc`, which Linux fixes at a hundredth of a second.
const TICKS_PER_S: f64 = 100.0;

/// What one command costs.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    pub wall_s: f64,
    pub cpu_s: f64,
    pub peak_kib: u64,
}

/// Runs the program in a folder; its standard output is thrown away.
///
/// # Errors
/// When it cannot be started or does not exit with 0.
pub fn run(program: &Path, arguments: &[String], folder: &Path) -> Result<Measured, String> {
    let mut best = once(program, arguments, folder)?;
    for _ in 1..RUNS {
        if best.wall_s > LONG_S {
            break;
        }
        let next = once(program, arguments, folder)?;
        best = Measured {
            wall_s: best.wall_s.min(next.wall_s),
            cpu_s: best.cpu_s.min(next.cpu_s),
            peak_kib: best.peak_kib.max(next.peak_kib),
        };
    }
    Ok(best)
}

/// One run, for commands that leave something behind which would spare a second one its work.
///
/// # Errors
/// When it cannot be started or does not exit with 0.
pub fn once(program: &Path, arguments: &[String], folder: &Path) -> Result<Measured, String> {
    let failed = |why: String| format!("`slipmode {}`: {why}", arguments.join(" "));
    let start = Instant::now();
    let mut child = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .spawn()
        .map_err(|error| failed(error.to_string()))?;
    let (mut peak_kib, mut cpu_s) = (0, 0.0_f64);
    loop {
        peak_kib = peak_kib.max(peak_memory_kib(child.id()).unwrap_or(0));
        let (ticks_s, has_ended) = cpu_time(child.id()).unwrap_or((0.0, true));
        cpu_s = f64::max(cpu_s, threads_cpu_time(child.id()).unwrap_or(0.0).max(ticks_s));
        if has_ended {
            break;
        }
        sleep(Duration::from_micros(500));
    }
    let status = child.wait().map_err(|error| failed(error.to_string()))?;
    let wall_s = start.elapsed().as_secs_f64();
    if status.success() { Ok(Measured { wall_s, cpu_s, peak_kib }) } else { Err(failed(status.to_string())) }
}

fn peak_memory_kib(process: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches("kB").trim().parse().ok()
}

/// CPU time of all threads in seconds, to a nanosecond.
fn threads_cpu_time(process: u32) -> Option<f64> {
    let nanoseconds = |thread: fs::DirEntry| {
        let text = fs::read_to_string(thread.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    };
    let threads = fs::read_dir(format!("/proc/{process}/task")).ok()?;
    Some(threads.flatten().filter_map(nanoseconds).sum::<u64>() as f64 / 1e9)
}

/// CPU time in seconds, to a hundredth, and whether the process has ended.
fn cpu_time(process: u32) -> Option<(f64, bool)> {
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    parse_stat(&stat)
}

/// Reads the state and the times of user and system, which stand behind the name in parentheses.
fn parse_stat(stat: &str) -> Option<(f64, bool)> {
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |index: usize| fields.get(index)?.parse::<u64>().ok();
    Some(((ticks(11)? + ticks(12)?) as f64 / TICKS_PER_S, *fields.first()? == "Z"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn state_and_times_are_found_behind_a_name_with_spaces() {
        let stat = "12 (a b) c) S 1 2 3 4 5 6 7 8 9 10 150 50 0 0";
        assert_eq!(parse_stat(stat), Some((2.0, false)));
        assert_eq!(parse_stat(&stat.replace(") S", ") Z")), Some((2.0, true)));
        assert_eq!(parse_stat("nothing"), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_program_that_ends_is_measured_and_one_that_fails_is_a_failed_check() {
        let folder = Path::new("/");
        let slept = run(Path::new("sleep"), &["0.02".into()], folder).unwrap();
        assert!(slept.wall_s >= 0.02 && slept.wall_s < 5.0 && slept.peak_kib > 0);
        assert!(run(Path::new("false"), &[], folder).unwrap_err().starts_with("`slipmode `: "));
    }
}
