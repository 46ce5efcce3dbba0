//! Writes what `bench --peers` measured: every row as CSV, the ratios as Markdown, with date, machine and versions.
//!
//! Times differ from machine to machine and from day to day, so these files lie apart from everything that `verify` compares.

use std::fmt::Write as _;
use std::fs;

use super::players::AvailablePlayers;
use super::ratios::{over, ratios};
use super::row::Row;
use crate::measured_on::{self, Facts};
use crate::times::{aims, read_peers};
use slipmode_core::number::format::round_digits;

/// Writes `crates/bench/results/peers.csv`, `crates/bench/results/peers.md` and the rows of `crates/bench/results/machine.csv` about them.
///
/// # Errors
/// When they cannot be written.
pub fn results(found: &AvailablePlayers, rows: &[Row]) -> Result<(), String> {
    let folder = measured_on::folder();
    let mut facts = measured_on::facts();
    let result = |program: &str| rows.iter().any(|row| row.program == program);
    facts.extend(found.players.iter().map(|player| {
        let failed = if result(&player.program_and_version()) { "" } else { ": no result" };
        (player.name.to_string(), format!("{}{failed}", player.version))
    }));
    facts.extend(found.skipped.iter().map(|(name, reason)| (name.to_string(), format!("skipped: {reason}"))));
    let csv = csv(rows);
    let page = markdown(&(head(&facts) + &summary(&csv)?), rows);
    let written = fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join("peers.csv"), csv))
        .and_then(|()| fs::write(folder.join("peers.md"), page));
    written.map_err(|error| format!("crates/bench/results: {error}"))?;
    measured_on::write("peers.csv", &facts)?;
    println!(
        "written: crates/bench/results/peers.csv, crates/bench/results/peers.md, crates/bench/results/machine.csv"
    );
    Ok(())
}

fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "work,method,tolerance,items,cpu_s,error,wrong,steps,evaluations,program,options,command\n",
    );
    for row in rows {
        let Row { work, method, items, seconds, wrong, program, command, .. } = row;
        let cells = [&row.tolerance, &row.error, &row.steps, &row.evaluations, &row.options];
        let [tolerance, error, steps, evaluations, options] =
            cells.map(|cell| if cell == "-" { "" } else { cell.as_str() });
        // Programs, options and commands hold no comma and no quote.
        let _ = writeln!(
            text,
            "{work},{method},{tolerance},{items},{seconds:.6e},{error},{wrong},{steps},{evaluations},{program},{options},{command}"
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

/// Every target with what was measured, and with the range over its works, cases and errors.
fn summary(csv: &str) -> Result<String, String> {
    let rows = read_peers("peers.csv", csv).map_err(|faults| format!("{faults:?}"))?;
    let mut text =
        String::from("\n| work | quantity | measured | smallest and largest |\n|---|---|--:|---|\n");
    for aim in aims(&rows) {
        let found = aim.measured.as_ref();
        let measured =
            found.map_or_else(|missing| format!("not measured: {missing}"), |found| short(found.value));
        let range = found.ok().and_then(|found| found.range);
        let range = range.map(|(least, most)| format!("{} to {}", short(least), short(most)));
        let _ = writeln!(
            text,
            "| {} | {} | {measured} | {} |",
            aim.work,
            aim.quantity,
            range.unwrap_or_default()
        );
    }
    Ok(text)
}

/// Two digits.
fn short(value: f64) -> String {
    round_digits(value, 2)
}

fn markdown(head: &str, rows: &[Row]) -> String {
    let mut text = String::from("# slipmode and its peers\n\n");
    text.push_str("Written by `cargo xtask bench --peers`. ");
    text.push_str(
        "Times are CPU time on one thread, the best of several interleaved runs on the same inputs; ",
    );
    text.push_str("read the ratios. Errors are the worst over all items, wrong answers left out.\n");
    text.push_str("A method that asks for a tolerance is listed at the cheapest one that met the error.\n");
    text.push_str("The first table names the programs, the second has every comparison with its range.\n\n");
    text.push_str(head);
    text.push_str(
        "\n| work | method | µs an item | over our fastest | worst error | wrong or failed | program | options | command |\n",
    );
    text.push_str("|---|---|--:|--:|--:|--:|---|---|---|\n");
    for ratio in ratios(rows) {
        let line = match ratio.row {
            None => format!("| {} | {} | | | not reached | | | | |", ratio.work, ratio.method),
            Some(row) => format!(
                "| {} | {} | {} | {} | {} | {} of {} | {} | {} | `{}` |",
                ratio.work,
                row.method,
                micro(row.seconds_per_item()),
                over(ratio.over_ours),
                row.error,
                row.wrong,
                row.items,
                row.program,
                row.options,
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
        let line = "row work=w method=m options=o tolerance=- items=2 seconds=1 error=1e-3 wrong=0 steps=- evaluations=-";
        let text = csv(&[Row::parse(line, "p 1", "cargo bench").unwrap()]);
        let cells: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(cells, [12, 12]);
    }

    #[test]
    fn the_summary_has_a_range_over_a_set_and_names_what_was_not_measured() {
        let row = |work: &str, method: &str, seconds: f64| {
            let rest = "tolerance=- items=1 error=- wrong=0 steps=- evaluations=-";
            let line = format!("row work={work} method={method} options=- seconds={seconds} {rest}");
            Row::parse(&line, "p 1", "c").unwrap()
        };
        let rows = [
            row("roots-50-random", "slipmode-certified", 1.0),
            row("roots-50-random", "flint-complex_roots", 8.0),
            row("roots-50-hard", "slipmode-certified", 1.0),
            row("roots-50-hard", "flint-complex_roots", 16.0),
        ];
        let text = summary(&csv(&rows)).unwrap();
        assert!(text.contains("| roots, 50 digits | FLINT's time / ours | 8 | 8 to 16 |"), "{text}");
        assert!(text.contains("not measured: no row `sweep, slipmode-simulate`"), "{text}");
    }
}
