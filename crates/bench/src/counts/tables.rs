//! Tables of work against error by counts: roots, classes, a point of the boundary, a sweep.

use super::{ClassCounts, SpeedCounts};
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

/// The four tables.
#[must_use]
pub fn tables(counts: &SpeedCounts) -> Vec<Table> {
    vec![roots(counts), classes(counts), boundary(counts), sweep(counts)]
}

fn count(value: impl ToString) -> Cell {
    Cell::number(value.to_string())
}

/// Whole digits, rounded down: no digit is claimed that is not there.
fn whole_digits(digits: f64) -> Cell {
    Cell::number(format!("{:.0}", digits.floor()))
}

fn roots(counts: &SpeedCounts) -> Table {
    let columns = vec![
        Column::text("set", "Cubics"),
        Column::text("method", "Method"),
        Column::number("digits_asked", "Requested digits", ""),
        Column::number("cubics", "Cubics", ""),
        Column::number("open", "Undecided", ""),
        Column::number("bits", "Bits of the arithmetic", ""),
        Column::number("digits_right", "Correct digits, worst root", ""),
    ];
    let mut table =
        Table::new("speed-roots", "Three roots: correct digits by precision of the arithmetic", columns);
    for row in &counts.roots {
        table.push(vec![
            Cell::text(row.set),
            Cell::text(row.method),
            row.digits.map_or_else(Cell::empty, count),
            count(row.cubics),
            count(row.open),
            count(row.bits),
            row.digits_right.map_or_else(Cell::empty, whole_digits),
        ]);
    }
    table
}

fn classes(counts: &SpeedCounts) -> Table {
    let columns = vec![
        Column::text("method", "Method"),
        Column::number("points", "Points", ""),
        Column::number("decided", "Decided", ""),
        Column::number("wrong", "Wrong signs", ""),
        Column::number("failed", "Without a finite answer", ""),
    ];
    let mut table =
        Table::new("speed-classes", "Signs of random points, by precision level and by method", columns);
    let ClassCounts { points, decided_by, methods } = &counts.classes;
    for (precision_level, decided) in [
        ("ours: 64-bit filter", decided_by.f64),
        ("ours: double-double", decided_by.double_double),
        ("ours: rationals", decided_by.exact),
    ] {
        table.push(vec![
            Cell::text(precision_level),
            count(points),
            count(decided),
            Cell::number("0"),
            Cell::number("0"),
        ]);
    }
    for method in methods {
        table.push(vec![
            Cell::text(method.method),
            count(method.points),
            count(method.points - method.failed),
            count(method.wrong),
            count(method.failed),
        ]);
    }
    table
}

fn boundary(counts: &SpeedCounts) -> Table {
    let columns = vec![
        Column::text("route", "Route"),
        Column::number("digits_asked", "Requested digits", ""),
        Column::text("counted", "Counted"),
        Column::number("count", "Count", ""),
        Column::number("digits_right", "Correct digits", ""),
        Column::text("agrees", "Overlaps the reference"),
    ];
    let mut table = Table::new("speed-boundary", "One point of the boundary by each route", columns);
    for row in &counts.boundary {
        table.push(vec![
            Cell::text(row.route),
            count(row.digits),
            Cell::text(row.counted),
            row.count.map_or_else(Cell::empty, count),
            whole_digits(row.digits_right),
            Cell::text(if row.agrees { "yes" } else { "no" }),
        ]);
    }
    table
}

fn sweep(counts: &SpeedCounts) -> Table {
    let columns = vec![
        Column::number("tolerance", "Tolerance", ""),
        Column::number("runs", "Runs", ""),
        Column::number("failed", "Failed", ""),
        Column::number("wrong", "Wrong behaviour", ""),
        Column::number("beyond", "Error above the tolerance", ""),
        Column::number("steps", "Steps", ""),
        Column::number("evaluations", "Right-hand sides", ""),
        Column::number("worst_error", "Largest relative error", ""),
    ];
    let mut table = Table::new("speed-sweep", "A sweep of both laws, tolerance by tolerance", columns);
    for row in &counts.sweep {
        table.push(vec![
            Cell::number(round_digits(row.tolerance, 2)),
            count(row.runs),
            count(row.failed),
            count(row.wrong),
            count(row.beyond),
            count(row.steps),
            count(row.evaluations),
            Cell::number(round_digits(row.worst_error, 1)),
        ]);
    }
    table
}
