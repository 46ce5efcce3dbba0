//! Tables of small disturbances compared with the roots, and of steady sliding.

use crate::experiments::linear_regime::ModeRuns;
use crate::experiments::linear_regime::figures::runs_of;
use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, Outcome, TableMaker};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "linear-regime", needs: &[Need::LinearRegime], make: all_runs },
    TableMaker { id: "linear-regime-extremes", needs: &[Need::LinearRegime], make: extremes },
    TableMaker { id: "steady-sliding", needs: &[Need::LinearRegime], make: steady },
];

fn all_runs(context: &Context) -> Option<Table> {
    let note = "Mismatches are relative to |p|; amplitudes are the largest of |ln(V/V_l)|, |ln(V_l θ/D_c)| and the spring stress in units of aσ. Roots: certified to 40 digits. Runs: double-double, local tolerance 1e-20.";
    let runs = context
        .outcome
        .each(|scene| &scene.linear_regime)
        .flat_map(|(name, found)| found.runs.iter().flatten().map(move |run| (name, run)));
    let rows =
        runs.filter_map(|(name, run)| Some((name, run, run.mismatches.first()?, run.mismatches.last()?)));
    Table::of("linear-regime", "Small disturbances compared with the roots of {characteristic}", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .digits("loading_velocity_m_per_s", "V_l", "m/s", 6, |(_, run, ..)| run.loading_velocity_m_per_s)
        .digits("normal_stress_pa", "σ", "Pa", 6, |(_, run, ..)| run.normal_stress_pa)
        .text("slip_mode", "Slip mode", |(_, run, ..)| run.slip_mode.as_str())
        .text("law", "Law", |(_, run, ..)| run.law.as_str())
        .digits("growth_rate", "Re p", "V_l/D_c", 8, |(_, run, ..)| run.growth_rate)
        .digits("angular_frequency", "Im p", "V_l/D_c", 8, |(_, run, ..)| run.angular_frequency)
        .text("direction", "Start along real or imaginary part of the eigenvector", |(_, run, ..)| {
            run.direction.as_str()
        })
        .digits("largest_amplitude", "Largest amplitude", "", 3, |(_, _, first, _)| first.amplitude)
        .digits("mismatch_at_largest", "Mismatch there", "", 3, |(_, _, first, _)| first.size())
        .digits("smallest_amplitude", "Smallest amplitude", "", 3, |(.., last)| last.amplitude)
        .digits("growth_mismatch", "Mismatch of growth there", "", 3, |(.., last)| last.growth.abs())
        .digits("frequency_mismatch", "Mismatch of frequency there", "", 3, |(.., last)| last.frequency.abs())
        .digits("snapshot_mismatch", "Mismatch from snapshots there", "", 3, |(.., last)| last.snapshots)
        .digits("order", "Order in the amplitude", "", 5, |(_, run, ..)| run.order())
        .digits("coefficient", "Predicted mismatch / amplitude", "", 4, |(_, run, ..)| run.coefficient)
        .digits("off_prediction", "Measured / predicted − 1", "", 2, |(_, run, ..)| run.off_prediction())
        .digits("difference_of_64_bit", "Difference of a 64-bit run", "", 2, |(_, run, ..)| {
            run.difference_of_64_bit
        })
        .table()
        .into()
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
    let note = "Mismatch: |p_measured − p|/|p|. The order is the slope of the mismatch over the amplitude from the largest to the smallest amplitude.";
    Table::of(
        "linear-regime-extremes",
        "Growth rate and frequency compared with the roots: largest mismatches",
        &groups(context.outcome),
    )
    .note(note)
    .text("scene", "Scene", |group| group.scene)
    .text("law", "Law", |group| group.law.as_str())
    .text("root", "Root", |group| group.root())
    .number("starts", "Starts", "", |group| group.runs.len())
    .digits("amplitude", "Smallest amplitude", "", 3, |group| group.smallest_amplitude())
    .digits("worst_mismatch", "Largest mismatch there, by either method", "", 2, |group| {
        group.largest(ModeRuns::least_mismatch)
    })
    .digits("worst_order", "Order farthest from 1", "", 5, |group| group.order_farthest_from_1())
    .digits("off_prediction", "Farthest from the predicted constant", "", 2, |group| {
        group.largest(ModeRuns::off_prediction)
    })
    .digits("difference_of_64_bit", "Largest difference of a 64-bit run", "", 2, |group| {
        group.largest(|run| Some(run.difference_of_64_bit))
    })
    .number("failures", "Starts of the scene without a result", "", |group| group.failures)
    .table()
    .into()
}

fn steady(context: &Context) -> Option<Table> {
    let note = "Departure: the largest of |ln(V/V_l)|, |ln(V_l θ/D_c)| and the spring stress in units of aσ. The disturbed start has 2^-52 in all three. Where steady sliding is unstable, the disturbance must grow and is not run. Free residual: difference between the spring stress and that computed from loading and separately integrated slip, from the paper's start over 1 000 D_c/V_l (100 for a decay), local tolerance 1e-11.";
    let rows = context
        .outcome
        .each(|scene| &scene.linear_regime)
        .flat_map(|(name, found)| found.steady.iter().flatten().map(move |run| (name, run)));
    Table::of("steady-sliding", "Steady sliding over a million D_c/V_l, and the free residual", rows)
        .note(note)
        .text("scene", "Scene", |(name, _)| name)
        .digits("loading_velocity_m_per_s", "V_l", "m/s", 6, |(_, run)| run.loading_velocity_m_per_s)
        .digits("normal_stress_pa", "σ", "Pa", 6, |(_, run)| run.normal_stress_pa)
        .text("law", "Law", |(_, run)| run.law.as_str())
        .digits("departure", "Departure from steady sliding", "", 2, |(_, run)| run.departure)
        .digits("disturbed_over_disturbance", "Largest / initial disturbance of 2^-52", "", 3, |(_, run)| {
            run.disturbed_over_disturbance
        })
        .digits("free_residual_over_normal_stress", "Free residual / σ", "", 2, |(_, run)| {
            run.free_residual_over_normal_stress
        })
        .table()
        .into()
}
