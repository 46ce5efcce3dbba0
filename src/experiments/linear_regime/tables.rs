//! Tables of small disturbances compared with the roots, and of steady sliding.

use crate::experiments::linear_regime::ModeRuns;
use crate::experiments::linear_regime::figures::runs_of;
use crate::experiments::{Context, Need, Outcome, TableMaker, table_of};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "linear-regime", needs: &[Need::LinearRegime], make: all_runs },
    TableMaker { id: "linear-regime-extremes", needs: &[Need::LinearRegime], make: extremes },
    TableMaker { id: "steady-sliding", needs: &[Need::LinearRegime], make: steady },
];

fn all_runs(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.linear_regime);
    let runs = found.flat_map(|(name, found)| found.runs.iter().flatten().map(move |run| (name, run)));
    let rows =
        runs.filter_map(|(name, run)| Some((name, run, run.mismatches.first()?, run.mismatches.last()?)));
    table_of("linear-regime", rows)
        .text("scene", |(name, ..)| name)
        .digits("loading_velocity_m_per_s", 6, |(_, run, ..)| run.loading_velocity_m_per_s)
        .digits("normal_stress_pa", 6, |(_, run, ..)| run.normal_stress_pa)
        .text("slip_mode", |(_, run, ..)| run.slip_mode.as_str())
        .text("law", |(_, run, ..)| run.law.as_str())
        .digits("growth_rate", 8, |(_, run, ..)| run.growth_rate)
        .digits("angular_frequency", 8, |(_, run, ..)| run.angular_frequency)
        .text("direction", |(_, run, ..)| run.direction.as_str())
        .digits("largest_amplitude", 3, |(_, _, first, _)| first.amplitude)
        .digits("mismatch_at_largest", 3, |(_, _, first, _)| first.size())
        .digits("smallest_amplitude", 3, |(.., last)| last.amplitude)
        .digits("growth_mismatch", 3, |(.., last)| last.growth.abs())
        .digits("frequency_mismatch", 3, |(.., last)| last.frequency.abs())
        .digits("snapshot_mismatch", 3, |(.., last)| last.snapshots)
        .digits("order", 5, |(_, run, ..)| run.order())
        .digits("coefficient", 4, |(_, run, ..)| run.coefficient)
        .digits("off_prediction", 2, |(_, run, ..)| run.off_prediction())
        .digits("difference_of_64_bit", 2, |(_, run, ..)| run.difference_of_64_bit)
        .table()
}

/// A real root or a pair, by one law, in one scene.
struct Group<'o> {
    scene: &'o str,
    law: EvolutionLaw,
    pair: bool,
    runs: Vec<&'o ModeRuns>,
    /// Starts of the scene without a result.
    failures: usize,
}

fn groups(outcome: &Outcome) -> Vec<Group<'_>> {
    let mut groups = Vec::new();
    for scene in &outcome.scenes {
        let all = scene.linear_regime.iter().flat_map(|found| &found.runs);
        let failures = all.filter(|run| run.is_err()).count();
        for law in [EvolutionLaw::Slip, EvolutionLaw::Aging] {
            for pair in [false, true] {
                let belongs = |run: &&ModeRuns| run.law == law && (run.angular_frequency != 0.0) == pair;
                let runs: Vec<&ModeRuns> = runs_of(scene).filter(belongs).collect();
                if !runs.is_empty() {
                    groups.push(Group { scene: &scene.scene.name, law, pair, runs, failures });
                }
            }
        }
    }
    groups
}

impl Group<'_> {
    fn root(&self) -> &'static str {
        if self.pair { "pair" } else { "real" }
    }

    fn largest(&self, value: impl Fn(&ModeRuns) -> Option<f64>) -> f64 {
        self.runs.iter().filter_map(|run| value(run)).fold(0.0, f64::max)
    }

    fn order_farthest_from_1(&self) -> Option<f64> {
        let orders = self.runs.iter().filter_map(|run| run.order());
        orders.max_by(|a, b| (a - 1.0).abs().total_cmp(&(b - 1.0).abs()))
    }

    fn smallest_amplitude(&self) -> Option<f64> {
        self.runs[0].mismatches.last().map(|last| last.amplitude)
    }
}

fn extremes(context: &Context) -> Option<Table> {
    table_of("linear-regime-extremes", &groups(context.outcome))
        .text("scene", |group| group.scene)
        .text("law", |group| group.law.as_str())
        .text("root", |group| group.root())
        .number("starts", |group| group.runs.len())
        .digits("amplitude", 3, |group| group.smallest_amplitude())
        .digits("worst_mismatch", 2, |group| group.largest(ModeRuns::least_mismatch))
        .digits("worst_order", 5, |group| group.order_farthest_from_1())
        .digits("off_prediction", 2, |group| group.largest(ModeRuns::off_prediction))
        .digits("difference_of_64_bit", 2, |group| group.largest(|run| Some(run.difference_of_64_bit)))
        .number("failures", |group| group.failures)
        .table()
}

fn steady(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.linear_regime);
    let rows = found.flat_map(|(name, found)| found.steady.iter().flatten().map(move |run| (name, run)));
    table_of("steady-sliding", rows)
        .text("scene", |(name, _)| name)
        .digits("loading_velocity_m_per_s", 6, |(_, run)| run.loading_velocity_m_per_s)
        .digits("normal_stress_pa", 6, |(_, run)| run.normal_stress_pa)
        .text("law", |(_, run)| run.law.as_str())
        .digits("departure", 2, |(_, run)| run.departure)
        .digits("disturbed_over_disturbance", 3, |(_, run)| run.disturbed_over_disturbance)
        .digits("free_residual_over_normal_stress", 2, |(_, run)| run.free_residual_over_normal_stress)
        .table()
}
