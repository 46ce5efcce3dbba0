//! Tables of what the unstated part of the start decides.

use crate::experiments::described::extent;
use crate::experiments::start_sensitivity::{Early, StartGroup, StartRun};
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::dynamics::{Behaviour, Simulation, Start};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "starts", needs: &[Need::StartSensitivity], make: starts },
    TableMaker { id: "start-spread", needs: &[Need::StartSensitivity], make: spread },
];

fn groups<'c>(context: &'c Context) -> impl Iterator<Item = (&'c str, &'c StartGroup)> {
    let found = context.outcome.each(|scene| &scene.start_sensitivity);
    found.flat_map(|(name, groups)| groups.iter().map(move |group| (name, group)))
}

/// A run with what it gave.
#[derive(Clone, Copy)]
struct Started<'c> {
    scene: &'c str,
    group: &'c StartGroup,
    run: &'c StartRun,
    early: Option<&'c (Early, f64)>,
    long_term: Option<&'c Simulation>,
    cycle: Option<&'c Simulation>,
}

impl<'c> Started<'c> {
    fn of((scene, group, run): (&'c str, &'c StartGroup, &'c StartRun)) -> Self {
        let long_term = run.long_term.as_ref().ok();
        let cycle = long_term.filter(|found| found.behaviour == Behaviour::Periodic);
        Self { scene, group, run, early: run.early.as_ref().ok(), long_term, cycle }
    }
}

fn starts(context: &Context) -> Option<Table> {
    let runs = groups(context).flat_map(|(name, group)| group.runs.iter().map(move |run| (name, group, run)));
    table_of("starts", runs.map(Started::of))
        .text("scene", |at| at.scene)
        .digits("loading_velocity_m_per_s", 6, |at| at.group.loading_velocity_m_per_s)
        .digits("normal_stress_pa", 6, |at| at.group.normal_stress_pa)
        .digits("stiffness_over_critical", 7, |at| at.group.stiffness_over_critical)
        .text("law", |at| at.group.law.as_str())
        .text("start", |at| at.run.start.as_str())
        .digits("first_peak_over_loading", 6, |at| at.early?.0.first_log_peak.map(libm::exp))
        .digits("first_peak_relative_error", 2, |at| at.early?.0.first_log_peak.and(Some(at.early?.1)))
        .digits("time_back_over_inertial_time", 3, |at| {
            Some(at.early?.0.time_back / at.group.inertial_parameter)
        })
        .digits("left_over", 3, |at| Some(at.early?.0.left_over))
        .text("behaviour", |at| at.long_term.map(|found| found.behaviour.as_str()))
        .digits("late_peak_velocity_m_per_s", 7, |at| Some(at.cycle?.peak_velocity_m_per_s))
        .digits("late_peak_relative_error", 2, |at| Some(at.cycle?.peak_relative_error))
        .digits("late_period_s", 7, |at| at.long_term?.period_s)
        .digits("late_period_relative_error", 2, |at| at.long_term?.period_relative_error)
        .text("failure", |at| {
            at.run.long_term.as_ref().err().or(at.run.early.as_ref().err()).map(ToString::to_string)
        })
        .table()
}

/// Largest over least of positive values, less 1; none when one is missing or there are fewer than two.
fn relative_spread(values: &[Option<f64>]) -> Option<f64> {
    let values: Vec<f64> = values.iter().copied().collect::<Option<_>>()?;
    let (least, most) = extent(values.iter().copied())?;
    (values.len() > 1 && least > 0.0).then(|| most / least - 1.0)
}

/// What the four starts of a group make of the same values.
struct Spread<'c> {
    scene: &'c str,
    group: &'c StartGroup,
    peak: Option<f64>,
    period: Option<f64>,
    /// Sum of the two largest errors of the peak.
    two_errors: Option<f64>,
    /// The smallest and the largest.
    first_peaks: Option<[f64; 2]>,
}

impl<'c> Spread<'c> {
    fn of((scene, group): (&'c str, &'c StartGroup)) -> Self {
        let long_term: Vec<&Simulation> =
            group.runs.iter().filter_map(|run| run.long_term.as_ref().ok()).collect();
        let is_cycle = |found: &&Simulation| found.behaviour == Behaviour::Periodic;
        let cycles: Vec<&Simulation> = long_term.iter().copied().filter(is_cycle).collect();
        let peaks: Vec<Option<f64>> = cycles.iter().map(|cycle| Some(cycle.peak_velocity_m_per_s)).collect();
        let mut errors: Vec<f64> = cycles.iter().map(|cycle| cycle.peak_relative_error).collect();
        errors.sort_by(|a, b| b.total_cmp(a));
        let alike = cycles.is_empty() || cycles.len() == long_term.len();
        let periods: Vec<Option<f64>> =
            if alike { &long_term } else { &cycles }.iter().map(|long_term| long_term.period_s).collect();
        let first = group.runs.iter().filter_map(|run| run.early.as_ref().ok()?.0.first_log_peak);
        let first = extent(first).map(|(least, most)| [least, most].map(libm::exp));
        Self {
            scene,
            group,
            peak: relative_spread(&peaks),
            period: relative_spread(&periods),
            two_errors: (errors.len() > 1).then(|| errors[0] + errors[1]),
            first_peaks: first,
        }
    }
}

fn spread(context: &Context) -> Option<Table> {
    let spreads: Vec<Spread<'_>> = groups(context).map(Spread::of).collect();
    table_of("start-spread", &spreads)
        .text("scene", |of| of.scene)
        .digits("loading_velocity_m_per_s", 6, |of| of.group.loading_velocity_m_per_s)
        .digits("normal_stress_pa", 6, |of| of.group.normal_stress_pa)
        .digits("stiffness_over_critical", 7, |of| of.group.stiffness_over_critical)
        .text("slip_mode", |of| of.group.slip_mode.as_str())
        .text("law", |of| of.group.law.as_str())
        .text("late_behaviour", |of| behaviours(of.group))
        .digits("late_peak_spread", 2, |of| of.peak)
        .digits("late_peak_allowed", 2, |of| of.two_errors)
        .digits("late_period_spread", 2, |of| of.period)
        .digits("first_peak_least", 6, |of| Some(of.first_peaks?[0]))
        .digits("first_peak_most", 6, |of| Some(of.first_peaks?[1]))
        .table()
}

/// `all periodic`, or which starts end otherwise than the first.
fn behaviours(group: &StartGroup) -> String {
    let word =
        |run: &StartRun| run.long_term.as_ref().map_or("no result", |long_term| long_term.behaviour.as_str());
    let Some(first) = group.runs.iter().find(|run| run.start == Start::default()).map(word) else {
        return String::new();
    };
    let others = group.runs.iter().filter(|run| word(run) != first);
    let others: Vec<String> = others.map(|run| format!("{} {}", run.start.as_str(), word(run))).collect();
    if others.is_empty() { format!("all {first}") } else { format!("{first}, but {}", others.join(", ")) }
}
