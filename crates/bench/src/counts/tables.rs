//! Tables of work against error by counts: roots, classes, a point of the boundary, a sweep.

use super::SpeedCounts;
use crate::digit_columns::DigitColumns;
use slipmode_plot::table::{Cell, Table};

/// The four tables.
#[must_use]
pub fn tables(counts: &SpeedCounts) -> Vec<Table> {
    vec![roots(counts), classes(counts), boundary(counts), sweep(counts)]
}

/// Whole digits, rounded down: no digit is claimed that is not there.
fn whole_digits(digits: f64) -> Cell {
    Cell::number(format!("{:.0}", digits.floor()))
}

fn roots(counts: &SpeedCounts) -> Table {
    let title = "Three roots: correct digits by precision of the arithmetic";
    Table::of("speed-roots", title, &counts.roots)
        .text("set", "Cubics", |row| row.set)
        .text("method", "Method", |row| row.method)
        .number("digits_asked", "Requested digits", "", |row| row.digits)
        .number("cubics", "Cubics", "", |row| row.cubics)
        .number("open", "Undecided", "", |row| row.open)
        .number("bits", "Bits of the arithmetic", "", |row| row.bits)
        .number("digits_right", "Correct digits, worst root", "", |row| row.digits_right.map(whole_digits))
        .table()
}

fn classes(counts: &SpeedCounts) -> Table {
    let title = "Signs of random points, by precision level and by method";
    Table::of("speed-classes", title, &counts.classes)
        .text("method", "Method", |row| row.method)
        .number("points", "Points", "", |row| row.points)
        .number("decided", "Decided", "", |row| row.decided)
        .number("wrong", "Wrong signs", "", |row| row.wrong)
        .number("failed", "Without a finite answer", "", |row| row.failed)
        .table()
}

fn boundary(counts: &SpeedCounts) -> Table {
    Table::of("speed-boundary", "One point of the boundary by each route", &counts.boundary)
        .text("route", "Route", |row| row.route)
        .number("digits_asked", "Requested digits", "", |row| row.digits)
        .text("counted", "Counted", |row| row.counted)
        .number("count", "Count", "", |row| row.count)
        .number("digits_right", "Correct digits", "", |row| whole_digits(row.digits_right))
        .text("agrees", "Overlaps the reference", |row| if row.agrees { "yes" } else { "no" })
        .table()
}

fn sweep(counts: &SpeedCounts) -> Table {
    Table::of("speed-sweep", "A sweep of both laws, tolerance by tolerance", &counts.sweep)
        .digits("tolerance", "Tolerance", "", 2, |row| row.tolerance)
        .number("runs", "Runs", "", |row| row.runs)
        .number("failed", "Failed", "", |row| row.failed)
        .number("wrong", "Wrong behaviour", "", |row| row.wrong)
        .number("beyond", "Error above the tolerance", "", |row| row.beyond)
        .number("steps", "Steps", "", |row| row.steps)
        .number("evaluations", "Right-hand sides", "", |row| row.evaluations)
        .digits("worst_error", "Largest relative error", "", 1, |row| row.worst_error)
        .table()
}
