//! The tables of a comparison: one row a run, and one row a finding.

use slipmode::comparison::recording::Measured;
use slipmode::comparison::{Finding, Value};
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

use crate::cli::compare::cells::reason;
use crate::cli::compare::rows::ComparedRow;

/// Significant digits of values, and of differences and errors.
const VALUE_DIGITS: usize = 8;
const ERROR_DIGITS: usize = 2;

/// Both tables.
pub fn tables(rows: &[ComparedRow]) -> Vec<Table> {
    vec![runs(rows), findings(rows)]
}

fn runs(rows: &[ComparedRow]) -> Table {
    let columns = vec![
        Column::number("row", "Row", ""),
        Column::text("verdict", "Verdict"),
        Column::text("law", "Law"),
        Column::number("stiffness_over_critical", "K/K_c", ""),
        Column::text("theory_slip_mode", "Linear theory"),
        Column::text("simulated_slip_mode", "Our simulation"),
        Column::number("tolerance", "Tolerance", ""),
        Column::text("reason", "Reason"),
        Column::text("warning", "Warning"),
    ];
    let mut table = Table::new("runs", "The runs and their verdicts", columns);
    for row in rows {
        let found = &row.comparison;
        let simulated = found.simulation.as_ref().map_or("failed", |found| found.slip_mode.as_str());
        table.push(vec![
            Cell::number(row.number.to_string()),
            Cell::text(found.verdict.as_str()),
            Cell::text(row.run.law.as_str()),
            number(found.theory.stiffness_ratio, ERROR_DIGITS + 2),
            Cell::text(found.theory.slip_mode.as_str()),
            Cell::text(simulated),
            number(Some(row.run.tolerance), ERROR_DIGITS + 1),
            Cell::text(reason(found)),
            Cell::text(row.warnings.join("; ")),
        ]);
    }
    table
}

fn findings(rows: &[ComparedRow]) -> Table {
    let columns = vec![
        Column::number("row", "Row", ""),
        Column::text("observable", "Quantity"),
        Column::text("unit", "Unit"),
        Column::text("origin", "From"),
        Column::text("reference", "Against"),
        Column::text("run", "Run"),
        Column::number("run_relative_error", "Its error", ""),
        Column::text("ours", "Ours"),
        Column::number("our_relative_error", "Our error", ""),
        Column::number("difference", "Difference", ""),
        Column::number("allowed", "Allowed", ""),
        Column::text("verdict", "Verdict"),
        Column::text("reason", "Reason"),
    ];
    let note = "Errors and differences are relative. The error of a stated number is its tolerance. The error of a number from a trajectory comes from its sampling and from the change between its last cycles.";
    let mut table =
        Table::new("findings", "All quantities compared with theory and simulation", columns).with_note(note);
    for row in rows {
        for finding in &row.comparison.findings {
            table.push(finding_cells(row.number, finding));
        }
    }
    table
}

fn finding_cells(number_of_row: u64, finding: &Finding) -> Vec<Cell> {
    let [(run, run_error), (ours, our_error)] = [finding.run, finding.ours].map(value);
    vec![
        Cell::number(number_of_row.to_string()),
        Cell::text(finding.observable.words()),
        Cell::text(finding.observable.unit()),
        Cell::text(finding.origin.as_str()),
        Cell::text(finding.reference.as_str()),
        run,
        run_error,
        ours,
        our_error,
        number(finding.difference, ERROR_DIGITS),
        number(finding.allowed, ERROR_DIGITS),
        Cell::text(finding.verdict.as_str()),
        Cell::text(finding.why.clone()),
    ]
}

/// A value and its error as cells.
fn value(value: Value) -> (Cell, Cell) {
    match value {
        Value::None => (Cell::empty(), Cell::empty()),
        Value::Word(word) => (Cell::text(word), Cell::empty()),
        Value::Number(Measured { value, relative_error }) => {
            let error = Some(relative_error).filter(|error| *error > 0.0);
            (number(Some(value), VALUE_DIGITS), number(error, ERROR_DIGITS))
        }
    }
}

/// A rounded number; empty when there is none or it is not finite.
fn number(value: Option<f64>, digits: usize) -> Cell {
    match value.filter(|value| value.is_finite()) {
        Some(value) => Cell::number(round_digits(value, digits)),
        None => Cell::empty(),
    }
}
