//! The table of coverage: how many lines of each module the tests ran, and where most are left.

use super::{COVERAGE_FILE, CoverageRow, Timings};
use slipmode_plot::table::{Cell, Column, Table};

/// One row a module, and one for all.
pub(super) fn coverage(timings: &Timings) -> Table {
    let columns = vec![
        Column::text("module", "Module"),
        Column::number("lines", "Lines", ""),
        Column::number("by_tests", "Run by tests", ""),
        Column::number("by_tests_percent", "Share", "%"),
        Column::number("with_verify", "Run by tests or verify", ""),
        Column::number("with_verify_percent", "Share", "%"),
        Column::text("most_left_in", "Most lines not run in"),
    ];
    let mut table = Table::new("coverage", "Lines of the program that the tests run", columns)
        .with_note(&measured(timings));
    timings.coverage.iter().for_each(|one| table.push(row(one)));
    table.push(row(&sum(&timings.coverage)));
    table
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

fn row(row: &CoverageRow) -> Vec<Cell> {
    let count = |count: u64| Cell::number(count.to_string());
    let share = |run: u64| {
        let share = row.per_mille(run);
        Cell::number(share.map_or(String::new(), |share| format!("{}.{}", share / 10, share % 10)))
    };
    vec![
        Cell::text(&row.module),
        count(row.lines),
        count(row.by_tests),
        share(row.by_tests),
        count(row.with_verify),
        share(row.with_verify),
        Cell::text(&row.most_left_in),
    ]
}
