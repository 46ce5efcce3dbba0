//! The answer of `compare`.

use slipmode::comparison::recording::Measured;
use slipmode::comparison::{Agreement, Finding, Value};
use slipmode_core::number::format::round_digits;

use crate::cli::answer::Answer;
use crate::cli::compare::rows::{ComparedRow, counts, reason, within_error_bars};
use crate::cli::compare::tables::{ERROR_DIGITS, VALUE_DIGITS};
use crate::cli::inputs::region_json;
use crate::cli::simulate;
use crate::cli::simulate::run::Simulated;
use crate::cli::terminal::{SCHEMA, count_of};

/// Up to so many rows, every finding is shown; beyond it those of rows that do not agree.
const ROWS_IN_FULL: usize = 20;

/// States the rows in their order with the numbers behind their verdicts, counts the verdicts, and counts the rows that were
/// passed over.
pub fn answer(rows: &[ComparedRow], faulty: u64) -> Answer {
    let row = |row: &ComparedRow| {
        let found = &row.comparison;
        let in_full = rows.len() <= ROWS_IN_FULL || found.verdict != Agreement::Agrees;
        let mut text = heading(row);
        if in_full {
            found.findings.iter().for_each(|finding| text += &line(finding));
        }
        let diagnosis = found.diagnosis.as_ref().map(|diagnosis| format!("  {diagnosis}\n"));
        row_part(row).text(&text).text(&diagnosis.unwrap_or_default())
    };
    let [agree, differ, not_compared] = counts(rows);
    let count = count_of(rows.len(), "row");
    let within = within_error_bars(rows)
        .filter(|within| *within > 0)
        .map(|within| format!(" ({within} within their error bars, sampled)"));
    let within = within.unwrap_or_default();
    let answer = Answer::default()
        .with("schema", SCHEMA)
        .list("rows", rows.iter().map(row))
        .text(&format!("{count}: {agree} agree{within}, {differ} differ, {not_compared} not compared\n"))
        .with("agree", agree)
        .with("differ", differ)
        .with("not_compared", not_compared)
        .with("at_fault", faulty);
    match within_error_bars(rows) {
        Some(within) => answer.with("agree_within_error_bars", within),
        None => answer,
    }
}

fn heading(row: &ComparedRow) -> String {
    let theory = &row.comparison.theory;
    let ratio = theory.stiffness_ratio.map_or_else(
        || "no transition (a >= b)".into(),
        |ratio| format!("K/K_c = {}", round_digits(ratio, 4)),
    );
    format!(
        "row {}: {}  ({} law, {ratio}, {}, tolerance {})\n",
        row.read.number,
        row.comparison.verdict.as_str(),
        row.read.run.law.as_str(),
        theory.slip_mode.as_str(),
        round_digits(row.read.run.tolerance, 3),
    )
}

fn line(finding: &Finding) -> String {
    let shown = |value: Value| shown_value(value, finding.observable.unit());
    let mut text = format!(
        "  {:<14} {:<12} {:<10} {:<10} {} | {}",
        finding.observable.words(),
        finding.verdict.as_str(),
        finding.origin.as_str(),
        finding.reference.as_str(),
        shown(finding.run),
        shown(finding.ours),
    );
    let allowed = finding.allowed.filter(|allowed| allowed.is_finite());
    if let (Some(difference), Some(allowed)) = (finding.difference, allowed) {
        let [difference, allowed] = [difference, allowed].map(|number| round_digits(number, ERROR_DIGITS));
        text += &format!("  difference {difference}, allowed {allowed}");
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
            let number = format!("{} {unit}", round_digits(value, VALUE_DIGITS));
            if relative_error > 0.0 && relative_error.is_finite() {
                return format!("{number} (within {} relative)", round_digits(relative_error, ERROR_DIGITS));
            }
            number
        }
    }
}

fn row_part(row: &ComparedRow) -> Answer {
    let found = &row.comparison;
    let theory = &found.theory;
    let simulated = Simulated::new(found.simulation.clone(), &row.read.run.parameters);
    Answer::default()
        .with("row", row.read.number)
        .with("inputs", region_json(&row.read.region))
        .with("law", row.read.run.law.as_str())
        .with("start", row.read.start.as_str())
        .with("tolerance", row.read.run.tolerance)
        .with("verdict", found.verdict.as_str())
        .with("reason", reason(found))
        .with("warnings", &row.warnings)
        .with("findings", &found.findings)
        .part("simulation", Answer::default().columns(&simulate::run::COLUMNS, &simulated))
        .part(
            "theory",
            Answer::default()
                .with("spectral_class", theory.class.as_str())
                .with("slip_mode", theory.slip_mode.as_str())
                .with("stiffness_over_critical", theory.stiffness_ratio)
                .with("frequency_hz", theory.frequency_hz)
                .with("growth_rate_per_s", theory.growth_rate_per_s),
        )
}
