//! What `compare` says: a table for people, one object for programs.

use serde_json::{Value as Json, json};
use slipmode::comparison::recording::Measured;
use slipmode::comparison::{Agreement, Finding, Value};
use slipmode_core::number::format::round_digits;

use crate::cli::compare::cells::reason;
use crate::cli::compare::rows::{ComparedRow, counts};
use crate::cli::inputs::{SCHEMA, inputs_json};
use crate::cli::simulate::rows::Answer;
use crate::cli::simulate::view;
use crate::cli::terminal;

/// Up to so many rows, every finding is shown; beyond it those of rows that do not agree.
const ROWS_IN_FULL: usize = 20;
/// Significant digits of values, and of differences and errors.
const VALUE_DIGITS: usize = 8;
const ERROR_DIGITS: usize = 2;

/// The verdicts with the numbers behind them.
pub fn text(rows: &[ComparedRow]) -> String {
    let mut text = String::new();
    for row in rows {
        let found = &row.comparison;
        let in_full = rows.len() <= ROWS_IN_FULL || found.verdict != Agreement::Agrees;
        text += &heading(row);
        if in_full {
            found.findings.iter().for_each(|finding| text += &line(finding));
        }
        if let Some(diagnosis) = &found.diagnosis {
            text += &format!("  {diagnosis}\n");
        }
    }
    let [agree, differ, not_compared] = counts(rows);
    let rows = terminal::count_of(rows.len(), "row");
    text += &format!("{rows}: {agree} agree, {differ} differ, {not_compared} not compared\n");
    text
}

fn heading(row: &ComparedRow) -> String {
    let theory = &row.comparison.theory;
    let ratio = theory.stiffness_ratio.map_or_else(
        || "no transition (a >= b)".into(),
        |ratio| format!("K/K_c = {}", round_digits(ratio, 4)),
    );
    format!(
        "row {}: {}  ({} law, {ratio}, {}, tolerance {})\n",
        row.number,
        row.comparison.verdict.as_str(),
        row.run.law.as_str(),
        theory.slip_mode.as_str(),
        round_digits(row.run.tolerance, 3),
    )
}

fn line(finding: &Finding) -> String {
    let unit = finding.observable.unit();
    let shown = |value: Value| shown_value(value, unit);
    let mut text = format!(
        "  {:<14} {:<12} {:<10} {:<10} {} | {}",
        finding.observable.words(),
        finding.verdict.as_str(),
        finding.origin.as_str(),
        finding.reference.as_str(),
        shown(finding.run),
        shown(finding.ours),
    );
    if let (Some(difference), Some(allowed)) = (finding.difference, finding.allowed) {
        text += &format!(
            "  difference {}, allowed {}",
            round_digits(difference, ERROR_DIGITS),
            round_digits(allowed, ERROR_DIGITS)
        );
    }
    if !finding.why.is_empty() {
        text += &format!("  ({})", finding.why);
    }
    text + "\n"
}

/// A value with its unit and, when it has one, its error.
fn shown_value(value: Value, unit: &str) -> String {
    match value {
        Value::Word(word) => word.into(),
        Value::None => "-".into(),
        Value::Number(Measured { value, relative_error }) => {
            let number = round_digits(value, VALUE_DIGITS);
            match relative_error {
                error if error > 0.0 && error.is_finite() => {
                    format!("{number} {unit} (within {} relative)", round_digits(error, ERROR_DIGITS))
                }
                _ => format!("{number} {unit}"),
            }
        }
    }
}

/// One object: the rows in their order, how many there are of each verdict, and how many were passed over.
pub fn json(rows: &[ComparedRow], faulty: u64) -> Json {
    let [agree, differ, not_compared] = counts(rows);
    json!({
        "schema": SCHEMA,
        "rows": rows.iter().map(row_object).collect::<Vec<_>>(),
        "agree": agree,
        "differ": differ,
        "not_compared": not_compared,
        "at_fault": faulty,
    })
}

fn row_object(row: &ComparedRow) -> Json {
    let found = &row.comparison;
    let theory = &found.theory;
    json!({
        "row": row.number,
        "inputs": inputs_json(&row.run.parameters),
        "law": row.run.law.as_str(),
        "start": row.start.as_str(),
        "tolerance": row.run.tolerance,
        "verdict": found.verdict.as_str(),
        "reason": reason(found),
        "warnings": row.warnings,
        "theory": {
            "spectral_class": theory.class.as_str(),
            "slip_mode": theory.slip_mode.as_str(),
            "stiffness_over_critical": theory.stiffness_ratio,
            "frequency_hz": theory.frequency_hz,
            "growth_rate_per_s": theory.growth_rate_per_s,
        },
        "simulation": view::json(&Answer::new(found.simulation.clone(), &row.run.parameters)),
        "findings": found.findings,
    })
}
