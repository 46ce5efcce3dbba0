//! The measured limits of a replay: memory and time, checked while it computes.

use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use slipmode::archive::{Budget, Request};

use crate::cli::asks_for_json;
use crate::cli::failure::Failure;

/// How often the limits are checked.
const INTERVAL: Duration = Duration::from_millis(20);

/// Ends the process when a limit is passed; a replay writes no files, so nothing is left behind.
pub struct Watch {
    largest: Arc<Mutex<String>>,
    /// The watching thread ends with this.
    _running: Sender<()>,
}

impl Watch {
    /// Starts to watch.
    pub fn start(archive: &Path, budget: Budget) -> Self {
        let (running, stopped) = channel();
        let largest = Arc::new(Mutex::new(String::new()));
        let (name, asked, started) = (archive.display().to_string(), Arc::clone(&largest), Instant::now());
        std::thread::spawn(move || {
            while stopped.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
                if let Some(fault) = passed(&budget, started.elapsed().as_secs_f64(), resident_mib()) {
                    let asked = asked.lock().unwrap_or_else(PoisonError::into_inner);
                    let failure = Failure::Refused(format!(
                        "{name}: stopped after {fault}{asked}; --budget FACTOR lifts it"
                    ));
                    failure.print(asks_for_json(&std::env::args_os().collect::<Vec<_>>()));
                    std::process::exit(i32::from(failure.exit_code()));
                }
            }
        });
        Self { largest, _running: running }
    }

    /// Notes what is computed, for the message.
    pub fn name_requests(&self, requests: &[Request]) {
        let most =
            requests.iter().max_by(|one, other| one.work.core_seconds.total_cmp(&other.work.core_seconds));
        if let Some(Request { place, work }) = most {
            let text = format!("; the largest request is {place}: {}", work.what);
            *self.largest.lock().unwrap_or_else(PoisonError::into_inner) = text;
        }
    }
}

/// The limit that is passed, if any.
fn passed(budget: &Budget, seconds: f64, memory_mib: f64) -> Option<String> {
    if seconds > budget.seconds {
        return Some(format!("{} s (budget)", budget.seconds));
    }
    (memory_mib > budget.memory_mib).then(|| format!("{} MiB of memory (budget)", budget.memory_mib))
}

/// The memory of this process in MiB; 0 where the system does not report it.
fn resident_mib() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let resident = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kib = resident.and_then(|text| text.split_whitespace().next()?.parse::<u32>().ok());
    kib.map_or(0.0, |kib| f64::from(kib) / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_and_memory_are_limited() {
        let budget = Budget::default();
        assert_eq!(passed(&budget, 3599.0, 2047.0), None);
        assert_eq!(passed(&budget, 3601.0, 0.0).unwrap(), "3600 s (budget)");
        assert_eq!(passed(&budget, 0.0, 2049.0).unwrap(), "2048 MiB of memory (budget)");
        if cfg!(target_os = "linux") {
            assert!(resident_mib() > 1.0);
        }
    }
}
