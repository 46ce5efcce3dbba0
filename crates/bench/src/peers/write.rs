//! Writes what `bench --peers` measured: every row as CSV, the ratios as Markdown, with date, machine and versions.
//!
//! Times differ from machine to machine and from day to day, so these files lie apart from everything that `verify` compares.

use std::fmt::Write as _;
use std::fs;

use super::players::Player;
use super::ratios::{over, ratios};
use super::row::Row;
use crate::measured_on::{self, Facts};

/// Writes `crates/bench/results/peers.csv`, `crates/bench/results/peers.md` and the rows of `crates/bench/results/machine.csv` about them.
///
/// # Errors
/// When they cannot be written.
pub fn results(players: &[Player], rows: &[Row]) -> Result<(), String> {
    let folder = measured_on::folder();
    let mut facts = measured_on::facts();
    facts.extend(players.iter().map(|player| (player.name.to_string(), player.version.clone())));
    let head = head(&facts);
    let written = fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join("peers.csv"), csv(rows)))
        .and_then(|()| fs::write(folder.join("peers.md"), markdown(&head, rows)));
    written.map_err(|error| format!("crates/bench/results: {error}"))?;
    measured_on::write("peers.csv", &facts)?;
    println!(
        "written: crates/bench/results/peers.csv, crates/bench/results/peers.md, crates/bench/results/machine.csv"
    );
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

fn head(facts: &Facts) -> String {
    let mut text = String::from("| measured with | |\n|---|---|\n");
    for (key, value) in facts {
        let _ = writeln!(text, "| {key} | {value} |");
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_csv_has_as_many_cells_as_its_header() {
        let line =
            "row work=w method=m tolerance=- items=2 seconds=1 error=1e-3 wrong=0 steps=- evaluations=-";
        let text = csv(&[Row::parse(line, "cargo bench").unwrap()]);
        let cells: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(cells, [10, 10]);
    }
}
