//! The table of coverage: how many lines of each module the tests ran, and where most are left.

use super::{COVERAGE_FILE, CoverageRow, Timings};
use slipmode_plot::table::{Cell, Table};

/// One row a module, and one for all.
pub(super) fn coverage(timings: &Timings) -> Table {
    let all = sum(&timings.coverage);
    let rows = timings.coverage.iter().chain([&all]);
    Table::of("coverage", "Lines of the program that the tests run", rows)
        .note(&measured(timings))
        .text("module", "Module", |row| &row.module)
        .number("lines", "Lines", "", |row| row.lines)
        .number("by_tests", "Run by tests", "", |row| row.by_tests)
        .number("by_tests_percent", "Share", "%", |row| share(row, row.by_tests))
        .number("with_verify", "Run by tests or verify", "", |row| row.with_verify)
        .number("with_verify_percent", "Share", "%", |row| share(row, row.with_verify))
        .text("most_left_in", "Most lines not run in", |row| &row.most_left_in)
        .table()
}

fn sum(rows: &[CoverageRow]) -> CoverageRow {
    let sum = |count: fn(&CoverageRow) -> u64| rows.iter().map(count).fold(0, u64::saturating_add);
    CoverageRow {
        module: "all".into(),
        lines: sum(|row| row.lines),
        by_tests: sum(|row| row.by_tests),
        with_verify: sum(|row| row.with_verify),
        most_left_in: String::new(),
    }
}

/// What was counted, and what the machine's file says of when and with what.
fn measured(timings: &Timings) -> String {
    let facts = timings.machine.iter().filter(|row| row.file == COVERAGE_FILE);
    let facts: String = facts.map(|row| format!(", {} {}", row.key, row.value)).collect();
    format!(
        "Shares are rounded down. Lines of unit tests are not counted. The last column names files with their number of lines that nothing ran. Source: `timings/{COVERAGE_FILE}`{facts}."
    )
}

fn share(row: &CoverageRow, run: u64) -> Option<Cell> {
    let share = row.per_mille(run)?;
    Some(Cell::number(format!("{}.{}", share / 10, share % 10)))
}
