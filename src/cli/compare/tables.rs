//! The tables of a comparison: one row a run, and one row a finding.

use slipmode::comparison::Value;
use slipmode::comparison::recording::Measured;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Table};

use crate::cli::compare::rows::{ComparedRow, reason};

/// Significant digits of values, and of differences and errors.
pub const VALUE_DIGITS: usize = 8;
pub const ERROR_DIGITS: usize = 2;

/// Both tables.
pub fn tables(rows: &[ComparedRow]) -> Vec<Table> {
    vec![runs(rows), findings(rows)]
}

fn runs(rows: &[ComparedRow]) -> Table {
    Table::of("runs", "The runs and their verdicts", rows)
        .number("row", "Row", "", |row| row.read.number)
        .text("verdict", "Verdict", |row| row.comparison.verdict.as_str())
        .text("law", "Law", |row| row.read.run.law.as_str())
        .number("stiffness_over_critical", "K/K_c", "", |row| {
            number(row.comparison.theory.stiffness_ratio, ERROR_DIGITS + 2)
        })
        .text("theory_slip_mode", "Linear theory", |row| row.comparison.theory.slip_mode.as_str())
        .text("simulated_slip_mode", "Our simulation", |row| {
            row.comparison.simulation.as_ref().map_or("failed", |found| found.slip_mode.as_str())
        })
        .number("tolerance", "Tolerance", "", |row| number(Some(row.read.run.tolerance), ERROR_DIGITS + 1))
        .text("reason", "Reason", |row| reason(&row.comparison))
        .text("warning", "Warning", |row| row.warnings.join("; "))
        .table()
}

fn findings(rows: &[ComparedRow]) -> Table {
    let note = "Errors and differences are relative. The error of a stated number is its tolerance. The error of a number from a trajectory comes from its sampling and from the change between its last cycles.";
    let all = rows.iter().flat_map(|row| row.comparison.findings.iter().map(move |found| (row, found)));
    Table::of("findings", "All quantities compared with theory and simulation", all)
        .note(note)
        .number("row", "Row", "", |(row, _)| row.read.number)
        .text("observable", "Quantity", |(_, found)| found.observable.words())
        .text("unit", "Unit", |(_, found)| found.observable.unit())
        .text("origin", "From", |(_, found)| found.origin.as_str())
        .text("reference", "Against", |(_, found)| found.reference.as_str())
        .text("run", "Run", |(_, found)| value(found.run))
        .number("run_relative_error", "Its error", "", |(_, found)| error(found.run))
        .text("ours", "Ours", |(_, found)| value(found.ours))
        .number("our_relative_error", "Our error", "", |(_, found)| error(found.ours))
        .number("difference", "Difference", "", |(_, found)| number(found.difference, ERROR_DIGITS))
        .number("allowed", "Allowed", "", |(_, found)| number(found.allowed, ERROR_DIGITS))
        .text("verdict", "Verdict", |(_, found)| found.verdict.as_str())
        .text("reason", "Reason", |(_, found)| &found.why)
        .table()
}

fn value(value: Value) -> Cell {
    match value {
        Value::None => Cell::empty(),
        Value::Word(word) => Cell::text(word),
        Value::Number(Measured { value, .. }) => number(Some(value), VALUE_DIGITS),
    }
}

/// The error of a number that has one.
fn error(value: Value) -> Cell {
    match value {
        Value::Number(Measured { relative_error, .. }) if relative_error > 0.0 => {
            number(Some(relative_error), ERROR_DIGITS)
        }
        _ => Cell::empty(),
    }
}

/// A rounded number; empty when there is none or it is not finite.
fn number(value: Option<f64>, digits: usize) -> Cell {
    match value.filter(|value| value.is_finite()) {
        Some(value) => Cell::number(round_digits(value, digits)),
        None => Cell::empty(),
    }
}
