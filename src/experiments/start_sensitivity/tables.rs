//! Tables of what the unstated part of the start decides.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::{rounded, rounded_or_empty};
use crate::experiments::start_sensitivity::{StartGroup, StartRun};
use crate::experiments::unless_empty;
use slipmode_core::dynamics::{Behaviour, Simulation, Start};
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "starts", needs: &[Need::StartSensitivity], make: starts },
    TableMaker { id: "start-spread", needs: &[Need::StartSensitivity], make: spread },
];

fn groups<'c>(context: &'c Context) -> impl Iterator<Item = (&'c str, &'c StartGroup)> {
    context.outcome.scenes.iter().flat_map(|scene| {
        scene.start_sensitivity.iter().flatten().map(|group| (scene.scene.name.as_str(), group))
    })
}

fn starts(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("loading_velocity_m_per_s", "V_l", "m/s"),
        Column::number("normal_stress_pa", "σ", "Pa"),
        Column::number("stiffness_over_critical", "K/K_c", ""),
        Column::text("law", "Law"),
        Column::text("start", "Start"),
        Column::number("first_peak_over_loading", "First peak / V_l", ""),
        Column::number("first_peak_relative_error", "Its error", ""),
        Column::number("time_back_over_inertial_time", "Time of return to V_l / (η D_c/V_l)", ""),
        Column::number("left_over", "Remaining disturbance", ""),
        Column::text("behaviour", "Long-term behaviour"),
        Column::number("late_peak_velocity_m_per_s", "Peak velocity of the cycle", "m/s"),
        Column::number("late_peak_relative_error", "Its relative error", ""),
        Column::number("late_period_s", "Long-term period", "s"),
        Column::number("late_period_relative_error", "Its relative error", ""),
        Column::text("failure", "Failure"),
    ];
    let mut table = Table::new("starts", "Four ways to complete the start V_l/10", columns)
        .with_note("First peak: the largest velocity before the second upward crossing of V_l. Return to V_l: |ln(V/V_l)| has decreased to 1 % of its initial value. Remaining disturbance: the larger of |ln(V_l θ/D_c)| and the spring's distance from steady sliding in units of aσ at that time. Errors are relative estimates from a second run at a tenth of the tolerance.");
    for (scene, group) in groups(context) {
        for run in &group.runs {
            table.push(start_row(scene, group, run));
        }
    }
    unless_empty(table)
}

fn start_row(scene: &str, group: &StartGroup, run: &StartRun) -> Vec<Cell> {
    let early = run.early.as_ref().ok();
    let long_term = run.long_term.as_ref().ok();
    let cycle = long_term.filter(|long_term| long_term.behaviour == Behaviour::Periodic);
    let peak = early.and_then(|(early, error)| Some((early.first_log_peak?, *error)));
    let failure = run.long_term.as_ref().err().or(run.early.as_ref().err()).map(ToString::to_string);
    vec![
        Cell::text(scene),
        rounded(group.loading_velocity_m_per_s, 6),
        rounded(group.normal_stress_pa, 6),
        rounded_or_empty(group.stiffness_over_critical, 7),
        Cell::text(group.law.as_str()),
        Cell::text(run.start.as_str()),
        rounded_or_empty(peak.map(|(peak, _)| libm::exp(peak)), 6),
        rounded_or_empty(peak.map(|(_, error)| error), 2),
        rounded_or_empty(early.map(|(early, _)| early.time_back / group.inertial_parameter), 3),
        rounded_or_empty(early.map(|(early, _)| early.left_over), 3),
        long_term.map_or_else(Cell::empty, |long_term| Cell::text(long_term.behaviour.as_str())),
        rounded_or_empty(cycle.map(|cycle| cycle.peak_velocity_m_per_s), 7),
        rounded_or_empty(cycle.map(|cycle| cycle.peak_relative_error), 2),
        rounded_or_empty(long_term.and_then(|long_term| long_term.period_s), 7),
        rounded_or_empty(long_term.and_then(|long_term| long_term.period_relative_error), 2),
        failure.map_or_else(Cell::empty, Cell::text),
    ]
}

/// Largest over least of positive values, less 1; none when one is missing or there are fewer than two.
fn relative_spread(values: &[Option<f64>]) -> Option<f64> {
    let values: Vec<f64> = values.iter().copied().collect::<Option<_>>()?;
    let (least, most) = values.iter().fold((f64::INFINITY, 0.0f64), |(l, m), v| (l.min(*v), m.max(*v)));
    (values.len() > 1 && least > 0.0).then(|| most / least - 1.0)
}

fn spread(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("loading_velocity_m_per_s", "V_l", "m/s"),
        Column::number("normal_stress_pa", "σ", "Pa"),
        Column::number("stiffness_over_critical", "K/K_c", ""),
        Column::text("slip_mode", "Slip mode by theory"),
        Column::text("law", "Law"),
        Column::text("late_behaviour", "Long-term behaviour, by start"),
        Column::number("late_peak_spread", "Spread of the cycle's peak", ""),
        Column::number("late_peak_allowed", "Sum of the two errors", ""),
        Column::number("late_period_spread", "Spread of the long-term period", ""),
        Column::number("first_peak_least", "Smallest first peak / V_l", ""),
        Column::number("first_peak_most", "Largest first peak / V_l", ""),
    ];
    let mut table = Table::new("start-spread", "Dependence on the start", columns).with_note(
        "Spread: largest / smallest value − 1, over the starts with the same long-term behaviour.",
    );
    for (scene, group) in groups(context) {
        table.push(spread_row(scene, group));
    }
    unless_empty(table)
}

fn spread_row(scene: &str, group: &StartGroup) -> Vec<Cell> {
    let long_term: Vec<&Simulation> =
        group.runs.iter().filter_map(|run| run.long_term.as_ref().ok()).collect();
    let cycles: Vec<&Simulation> =
        long_term.iter().copied().filter(|long_term| long_term.behaviour == Behaviour::Periodic).collect();
    let peaks: Vec<Option<f64>> = cycles.iter().map(|cycle| Some(cycle.peak_velocity_m_per_s)).collect();
    let mut errors: Vec<f64> = cycles.iter().map(|cycle| cycle.peak_relative_error).collect();
    errors.sort_by(|a, b| b.total_cmp(a));
    let alike = cycles.is_empty() || cycles.len() == long_term.len();
    let periods: Vec<Option<f64>> =
        if alike { &long_term } else { &cycles }.iter().map(|long_term| long_term.period_s).collect();
    let first = group.runs.iter().filter_map(|run| run.early.as_ref().ok()?.0.first_log_peak);
    let (least, most) = first.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(v), m.max(v)));
    let seen = |value: f64| value.is_finite().then(|| libm::exp(value));
    vec![
        Cell::text(scene),
        rounded(group.loading_velocity_m_per_s, 6),
        rounded(group.normal_stress_pa, 6),
        rounded_or_empty(group.stiffness_over_critical, 7),
        Cell::text(group.slip_mode.as_str()),
        Cell::text(group.law.as_str()),
        Cell::text(behaviours(group)),
        rounded_or_empty(relative_spread(&peaks), 2),
        rounded_or_empty((errors.len() > 1).then(|| errors[0] + errors[1]), 2),
        rounded_or_empty(relative_spread(&periods), 2),
        rounded_or_empty(seen(least), 6),
        rounded_or_empty(seen(most), 6),
    ]
}

/// `all periodic`, or which starts end otherwise than the first.
fn behaviours(group: &StartGroup) -> String {
    let word =
        |run: &StartRun| run.long_term.as_ref().map_or("no result", |long_term| long_term.behaviour.as_str());
    let Some(first) = group.runs.iter().find(|run| run.start == Start::default()).map(word) else {
        return String::new();
    };
    let others: Vec<String> = group
        .runs
        .iter()
        .filter(|run| word(run) != first)
        .map(|run| format!("{} {}", run.start.as_str(), word(run)))
        .collect();
    if others.is_empty() { format!("all {first}") } else { format!("{first}, but {}", others.join(", ")) }
}
