//! The cells that `compare` appends to a row: what theory and simulation say, and the verdicts.

use slipmode::comparison::{Agreement, Comparison, Finding, Observable};
use slipmode::csv::{Column, Datum};
use slipmode_core::dynamics::Simulation;

use crate::cli::compare::rows::ComparedRow;

/// The appended columns.
pub const COLUMNS: [Column<ComparedRow>; 22] = [
    ("theory_class", |row| word(row.comparison.theory.class.as_str())),
    ("theory_slip_mode", |row| word(row.comparison.theory.slip_mode.as_str())),
    ("theory_stiffness_over_critical", |row| Datum::Number(row.comparison.theory.stiffness_ratio)),
    ("theory_frequency_hz", |row| Datum::Number(row.comparison.theory.frequency_hz)),
    ("simulated_mode", |row| simulated_word(row, |found| found.behaviour.as_str())),
    ("simulated_slip_mode", |row| simulated_word(row, |found| found.slip_mode.as_str())),
    ("simulated_peak_velocity_m_per_s", |row| simulated(row, |found| Some(found.peak_velocity_m_per_s))),
    ("simulated_period_s", |row| simulated(row, |found| found.period_s)),
    ("simulated_stress_drop_pa", |row| simulated(row, |found| Some(found.stress_drop_pa))),
    ("simulated_frequency_hz", |row| simulated(row, |found| found.frequency_hz)),
    ("simulated_peak_relative_error", |row| simulated(row, |found| Some(found.peak_relative_error))),
    ("simulated_period_relative_error", |row| simulated(row, |found| found.period_relative_error)),
    ("mode_verdict", |row| verdict_on(row, Observable::Mode)),
    ("peak_velocity_verdict", |row| verdict_on(row, Observable::PeakVelocity)),
    ("period_verdict", |row| verdict_on(row, Observable::Period)),
    ("stress_drop_verdict", |row| verdict_on(row, Observable::StressDrop)),
    ("frequency_verdict", |row| verdict_on(row, Observable::Frequency)),
    ("growth_rate_verdict", |row| verdict_on(row, Observable::GrowthRate)),
    ("largest_difference", |row| Datum::Number(largest_difference(&row.comparison))),
    ("verdict", |row| word(row.comparison.verdict.as_str())),
    ("reason", |row| Datum::Text(reason(&row.comparison))),
    ("warning", |row| Datum::Text(row.warnings.join("; "))),
];

fn word(word: &str) -> Datum {
    Datum::Text(word.into())
}

fn simulated(row: &ComparedRow, value: fn(&Simulation) -> Option<f64>) -> Datum {
    Datum::Number(row.comparison.simulation.as_ref().ok().and_then(value))
}

fn simulated_word(row: &ComparedRow, of: fn(&Simulation) -> &'static str) -> Datum {
    word(row.comparison.simulation.as_ref().map_or("", of))
}

/// The verdict on one quantity over all its references and origins; empty when the run does not give it.
fn verdict_on(row: &ComparedRow, of: Observable) -> Datum {
    let verdicts = row.comparison.findings.iter().filter(|finding| finding.observable == of);
    let verdict = Agreement::of_all(verdicts.map(|finding| finding.verdict));
    word(verdict.map_or("", Agreement::as_str))
}

/// The difference of the largest size.
fn largest_difference(found: &Comparison) -> Option<f64> {
    let differences = found.findings.iter().filter_map(|finding| finding.difference);
    differences.max_by(|one, other| one.abs().total_cmp(&other.abs()))
}

/// Why the verdict is not `agrees`, in words; empty when it is.
pub fn reason(found: &Comparison) -> String {
    if let Some(diagnosis) = &found.diagnosis {
        return diagnosis.clone();
    }
    if found.verdict == Agreement::Agrees {
        return String::new();
    }
    let counts = |finding: &&Finding| finding.verdict == found.verdict;
    let mut reasons: Vec<String> = Vec::new();
    for finding in found.findings.iter().filter(counts) {
        let why = if finding.why.is_empty() { "differs" } else { &finding.why };
        let reason = format!("{}: {why}", finding.observable.words());
        if !reasons.contains(&reason) {
            reasons.push(reason);
        }
    }
    reasons.join("; ")
}
