//! The cells that `compare` appends to a row: what theory and simulation say, and the verdicts.

use slipmode::comparison::{Agreement, Comparison, Finding, Observable};
use slipmode::csv::push_cell;
use slipmode_core::dynamics::Simulation;
use slipmode_core::number::format::shortest;

/// The appended columns.
pub const APPENDED: &[&str] = &[
    "theory_class",
    "theory_slip_mode",
    "theory_stiffness_over_critical",
    "theory_frequency_hz",
    "simulated_mode",
    "simulated_slip_mode",
    "simulated_peak_velocity_m_per_s",
    "simulated_period_s",
    "simulated_stress_drop_pa",
    "simulated_frequency_hz",
    "simulated_peak_relative_error",
    "simulated_period_relative_error",
    "mode_verdict",
    "peak_velocity_verdict",
    "period_verdict",
    "stress_drop_verdict",
    "frequency_verdict",
    "growth_rate_verdict",
    "largest_difference",
    "verdict",
    "reason",
    "warning",
];

/// Appends the cells of a comparison, each behind a comma.
pub fn push_comparison(found: &Comparison, warnings: &[String], out: &mut Vec<u8>) {
    let optional = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let theory = &found.theory;
    let simulation = found.simulation.as_ref().ok();
    let simulated = |value: fn(&Simulation) -> Option<f64>| optional(simulation.and_then(value));
    let mut cells = vec![
        theory.class.as_str().to_string(),
        theory.slip_mode.as_str().into(),
        optional(theory.stiffness_ratio),
        optional(theory.frequency_hz),
        simulation.map_or("", |found| found.behaviour.as_str()).into(),
        simulation.map_or("", |found| found.slip_mode.as_str()).into(),
        simulated(|found| Some(found.peak_velocity_m_per_s)),
        simulated(|found| found.period_s),
        simulated(|found| Some(found.stress_drop_pa)),
        simulated(|found| found.frequency_hz),
        simulated(|found| Some(found.peak_relative_error)),
        simulated(|found| found.period_relative_error),
    ];
    cells.extend(Observable::ALL.map(|of| verdict_on(found, of).map_or("", Agreement::as_str).to_string()));
    cells.push(optional(largest_difference(found)));
    cells.push(found.verdict.as_str().into());
    cells.push(reason(found));
    cells.push(warnings.join("; "));
    for cell in cells {
        out.push(b',');
        push_cell(out, cell.as_bytes());
    }
}

/// The verdict on one quantity over all its references and origins; none when the run does not give it.
pub fn verdict_on(found: &Comparison, of: Observable) -> Option<Agreement> {
    let verdicts =
        found.findings.iter().filter(|finding| finding.observable == of).map(|finding| finding.verdict);
    verdicts.reduce(|one, other| match (one, other) {
        (Agreement::Differs, _) | (_, Agreement::Differs) => Agreement::Differs,
        (Agreement::Agrees, _) | (_, Agreement::Agrees) => Agreement::Agrees,
        _ => Agreement::NotCompared,
    })
}

/// The difference of the largest size.
pub fn largest_difference(found: &Comparison) -> Option<f64> {
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
