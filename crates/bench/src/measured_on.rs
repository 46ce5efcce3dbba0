//! `crates/bench/results/machine.csv`: on which machine, on which day and with which versions the files beside it were measured.
//!
//! One row a fact, under the name of the file that it is about, so that each command rewrites its own rows only.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use crate::{process, repository};

/// Facts by name, in the order in which they are written.
pub type Facts = Vec<(String, String)>;

const HEADER: &str = "file,key,value";

/// The folder of what was measured.
pub fn folder() -> PathBuf {
    repository::root().join("crates/bench/results")
}

/// The date, the processor and how many of its cores are ours, and the compiler; no host's name.
pub fn facts() -> Facts {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|p| p.1));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let fact = |key: &str, value: &str| (key.to_string(), value.to_string());
    vec![
        fact("date", &today()),
        fact("processor", model.unwrap_or(std::env::consts::ARCH)),
        fact("cores", &cores.to_string()),
        fact("compiler", &process::rustc_version()),
    ]
}

/// Writes the facts about one file, and keeps those about the others.
///
/// # Errors
/// When the file cannot be written.
pub fn write(file: &str, facts: &Facts) -> Result<(), String> {
    let path = folder().join("machine.csv");
    let text = merged(&fs::read_to_string(&path).unwrap_or_default(), file, facts);
    fs::write(path, text).map_err(|error| format!("crates/bench/results/machine.csv: {error}"))
}

fn merged(known: &str, file: &str, facts: &Facts) -> String {
    let mut text = format!("{HEADER}\n");
    let own = format!("{file},");
    for line in known.lines().skip(1).filter(|line| !line.starts_with(&own)) {
        let _ = writeln!(text, "{line}");
    }
    for (key, value) in facts {
        // A cell of this file has no comma and no quote.
        let _ = writeln!(text, "{file},{},{}", key.replace(',', ";"), value.replace(',', ";"));
    }
    text
}

/// Today's date in UTC.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |elapsed| elapsed.as_secs());
    let (year, month, day) = civil(seconds / 86_400);
    format!("{year}-{month:02}-{day:02}")
}

/// The Gregorian date of a number of days after 1970-01-01.
fn civil(mut days: u64) -> (u64, u64, u64) {
    let is_leap =
        |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let mut year = 1970;
    while days >= 365 + u64::from(is_leap(year)) {
        days -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let lengths = [31, 28 + u64::from(is_leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 1;
    for length in lengths {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    (year, month, days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_become_dates() {
        assert_eq!(civil(0), (1970, 1, 1));
        assert_eq!(civil(11_016), (2000, 2, 29));
        assert_eq!(civil(19_722), (2023, 12, 31));
        assert_eq!(civil(19_723), (2024, 1, 1));
    }

    #[test]
    fn facts_about_another_file_stay() {
        let fact = |value: &str| vec![("date".to_string(), value.to_string())];
        let first = merged("", "peers.csv", &fact("2026-01-02"));
        let both = merged(&first, "cost.csv", &fact("a, b"));
        let again = merged(&both, "peers.csv", &fact("2026-03-04"));
        assert_eq!(again, "file,key,value\ncost.csv,date,a; b\npeers.csv,date,2026-03-04\n");
    }
}
