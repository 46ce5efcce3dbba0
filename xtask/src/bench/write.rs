//! Writes what `bench --peers` measured: every row as CSV, the ratios as Markdown, with date, machine and versions.
//!
//! Times differ from machine to machine and from day to day, so these files lie apart from everything that `verify` compares.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use super::players::Player;
use super::ratios::{over, ratios};
use super::row::Row;
use crate::failure::Failure;
use crate::{process, repository};

/// Writes `bench-results/peers.csv` and `bench-results/peers.md`.
///
/// # Errors
/// When they cannot be written.
pub fn results(players: &[Player], rows: &[Row]) -> Result<(), Failure> {
    let folder = repository::root().join("bench-results");
    let head = head(players);
    let written = fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join("peers.csv"), csv(rows)))
        .and_then(|()| fs::write(folder.join("peers.md"), markdown(&head, rows)));
    written.map_err(|error| Failure::bad_input(format!("bench-results: {error}")))?;
    println!("written: bench-results/peers.csv, bench-results/peers.md");
    Ok(())
}

fn csv(rows: &[Row]) -> String {
    let mut text = String::from("work,method,tolerance,items,cpu_s,error,wrong,steps,evaluations,command\n");
    for row in rows {
        let Row { work, method, tolerance, items, seconds, error, wrong, steps, evaluations, command } = row;
        let line =
            [tolerance, error, steps, evaluations].map(|cell| if cell == "-" { "" } else { cell.as_str() });
        let [tolerance, error, steps, evaluations] = line;
        // Commands hold no comma and no quote.
        let _ = writeln!(
            text,
            "{work},{method},{tolerance},{items},{seconds:.6e},{error},{wrong},{steps},{evaluations},{command}"
        );
    }
    text
}

fn head(players: &[Player]) -> String {
    let mut text = format!("Measured on {}, {}.\n\n", today(), machine());
    text.push_str("| player | version |\n|---|---|\n");
    for player in players {
        let _ = writeln!(text, "| {} | {} |", player.name, player.version);
    }
    text
}

fn markdown(head: &str, rows: &[Row]) -> String {
    let mut text = String::from("# slipmode and its peers\n\n");
    text.push_str("Written by `cargo xtask bench --peers`. ");
    text.push_str(
        "Times are CPU time on one thread, the best of several interleaved runs on the same inputs; ",
    );
    text.push_str("read the ratios. Errors are the worst over all items, wrong answers left out.\n");
    text.push_str("A method that asks for a tolerance is listed at the cheapest one that met the error.\n\n");
    text.push_str(head);
    text.push_str(
        "\n| work | method | µs an item | over our fastest | worst error | wrong or failed | command |\n",
    );
    text.push_str("|---|---|--:|--:|--:|--:|---|\n");
    for ratio in ratios(rows) {
        let line = match ratio.row {
            None => format!("| {} | {} | | | not reached | | |", ratio.work, ratio.method),
            Some(row) => format!(
                "| {} | {} | {} | {} | {} | {} of {} | `{}` |",
                ratio.work,
                row.method,
                micro(row.seconds_per_item()),
                over(ratio.over_ours),
                row.error,
                row.wrong,
                row.items,
                row.command
            ),
        };
        text.push_str(&line);
        text.push('\n');
    }
    text
}

/// Microseconds in four digits.
fn micro(seconds: f64) -> String {
    let value = 1e6 * seconds;
    if value >= 100.0 { format!("{value:.0}") } else { format!("{value:.4}") }
}

/// The processor and how many of its cores are ours; no host's name.
fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|p| p.1));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let compiler = process::output(Command::new("rustc").arg("--version")).unwrap_or_default();
    format!("{}, {cores} cores, {}", model.unwrap_or(std::env::consts::ARCH), compiler.trim())
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
    fn every_row_of_the_csv_has_as_many_cells_as_its_header() {
        let line =
            "row work=w method=m tolerance=- items=2 seconds=1 error=1e-3 wrong=0 steps=- evaluations=-";
        let text = csv(&[Row::parse(line, "cargo bench").unwrap()]);
        let cells: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(cells, [10, 10]);
    }
}
