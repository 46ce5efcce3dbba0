//! Tables of small disturbances compared with the roots, and of steady sliding.

use crate::experiments::linear_regime::figures::runs_of;
use crate::experiments::linear_regime::{ModeRuns, SteadyRun};
use crate::experiments::shared::cells::{count, rounded, rounded_or_empty};
use crate::experiments::{Context, Need, Outcome, SceneOutcome, TableMaker, unless_empty};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "linear-regime", needs: &[Need::LinearRegime], make: all_runs },
    TableMaker { id: "linear-regime-extremes", needs: &[Need::LinearRegime], make: extremes },
    TableMaker { id: "steady-sliding", needs: &[Need::LinearRegime], make: steady },
];

fn failures_of(scene: &SceneOutcome) -> usize {
    let outcome = scene.linear_regime.iter();
    outcome.flat_map(|outcome| &outcome.runs).filter(|run| run.is_err()).count()
}

fn all_runs(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("loading_velocity_m_per_s", "V_l", "m/s"),
        Column::number("normal_stress_pa", "σ", "Pa"),
        Column::text("slip_mode", "Slip mode"),
        Column::text("law", "Law"),
        Column::number("growth_rate", "Re p", "V_l/D_c"),
        Column::number("angular_frequency", "Im p", "V_l/D_c"),
        Column::text("direction", "Start along real or imaginary part of the eigenvector"),
        Column::number("largest_amplitude", "Largest amplitude", ""),
        Column::number("mismatch_at_largest", "Mismatch there", ""),
        Column::number("smallest_amplitude", "Smallest amplitude", ""),
        Column::number("growth_mismatch", "Mismatch of growth there", ""),
        Column::number("frequency_mismatch", "Mismatch of frequency there", ""),
        Column::number("snapshot_mismatch", "Mismatch from snapshots there", ""),
        Column::number("order", "Order in the amplitude", ""),
        Column::number("coefficient", "Predicted mismatch / amplitude", ""),
        Column::number("off_prediction", "Measured / predicted − 1", ""),
        Column::number("difference_of_64_bit", "Difference of a 64-bit run", ""),
    ];
    let mut table = Table::new("linear-regime", "Small disturbances compared with the roots of eq 8", columns)
        .with_note("Mismatches are relative to |p|; amplitudes are the largest of |ln(V/V_l)|, |ln(V_l θ/D_c)| and the spring stress in units of aσ. Roots: certified to 40 digits. Runs: double-double, local tolerance 1e-20.");
    for scene in &context.outcome.scenes {
        for run in runs_of(scene) {
            let (Some(first), Some(last)) = (run.mismatches.first(), run.mismatches.last()) else { continue };
            table.push(vec![
                Cell::text(&scene.scene.name),
                rounded(run.loading_velocity_m_per_s, 6),
                rounded(run.normal_stress_pa, 6),
                Cell::text(run.slip_mode.as_str()),
                Cell::text(run.law.as_str()),
                rounded(run.growth_rate, 8),
                rounded(run.angular_frequency, 8),
                Cell::text(run.direction.as_str()),
                rounded(first.amplitude, 3),
                rounded(first.size(), 3),
                rounded(last.amplitude, 3),
                rounded(last.growth.abs(), 3),
                rounded(last.frequency.abs(), 3),
                rounded(last.snapshots, 3),
                rounded_or_empty(run.order(), 5),
                rounded(run.coefficient, 4),
                rounded_or_empty(run.off_prediction(), 2),
                rounded(run.difference_of_64_bit, 2),
            ]);
        }
    }
    unless_empty(table)
}

/// A real root or a pair, by one law, in one scene.
struct Group<'o> {
    scene: &'o str,
    law: EvolutionLaw,
    pair: bool,
    runs: Vec<&'o ModeRuns>,
}

fn groups(outcome: &Outcome) -> Vec<Group<'_>> {
    let mut groups = Vec::new();
    for scene in &outcome.scenes {
        for law in [EvolutionLaw::Slip, EvolutionLaw::Aging] {
            for pair in [false, true] {
                let belongs = |run: &&ModeRuns| run.law == law && (run.angular_frequency != 0.0) == pair;
                let runs: Vec<&ModeRuns> = runs_of(scene).filter(belongs).collect();
                if !runs.is_empty() {
                    groups.push(Group { scene: &scene.scene.name, law, pair, runs });
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
}

fn extremes(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("law", "Law"),
        Column::text("root", "Root"),
        Column::number("starts", "Starts", ""),
        Column::number("amplitude", "Smallest amplitude", ""),
        Column::number("worst_mismatch", "Largest mismatch there, by either method", ""),
        Column::number("worst_order", "Order farthest from 1", ""),
        Column::number("off_prediction", "Farthest from the predicted constant", ""),
        Column::number("difference_of_64_bit", "Largest difference of a 64-bit run", ""),
        Column::number("failures", "Starts of the scene without a result", ""),
    ];
    let mut table =
        Table::new("linear-regime-extremes", "Growth rate and frequency compared with the roots: largest mismatches", columns)
            .with_note("Mismatch: |p_measured − p|/|p|. The order is the slope of the mismatch over the amplitude from the largest to the smallest amplitude.");
    for group in groups(context.outcome) {
        let failures = context.outcome.scenes.iter().find(|scene| scene.scene.name == group.scene);
        let orders = group.runs.iter().filter_map(|run| run.order());
        let farthest = orders.max_by(|a, b| (a - 1.0).abs().total_cmp(&(b - 1.0).abs()));
        let amplitude = group.runs[0].mismatches.last().map(|last| last.amplitude);
        table.push(vec![
            Cell::text(group.scene),
            Cell::text(group.law.as_str()),
            Cell::text(group.root()),
            count(group.runs.len()),
            rounded_or_empty(amplitude, 3),
            rounded(group.largest(ModeRuns::least_mismatch), 2),
            rounded_or_empty(farthest, 5),
            rounded(group.largest(ModeRuns::off_prediction), 2),
            rounded(group.largest(|run| Some(run.difference_of_64_bit)), 2),
            count(failures.map_or(0, failures_of)),
        ]);
    }
    unless_empty(table)
}

fn steady(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("loading_velocity_m_per_s", "V_l", "m/s"),
        Column::number("normal_stress_pa", "σ", "Pa"),
        Column::text("law", "Law"),
        Column::number("departure", "Departure from steady sliding", ""),
        Column::number("disturbed_over_disturbance", "Largest / initial disturbance of 2^-52", ""),
        Column::number("free_residual_over_normal_stress", "Free residual / σ", ""),
    ];
    let mut table = Table::new("steady-sliding", "Steady sliding over a million D_c/V_l, and the free residual", columns)
        .with_note("Departure: the largest of |ln(V/V_l)|, |ln(V_l θ/D_c)| and the spring stress in units of aσ. The disturbed start has 2^-52 in all three. Where steady sliding is unstable, the disturbance must grow and is not run. Free residual: difference between the spring stress and that computed from loading and separately integrated slip, from the paper's start over 1 000 D_c/V_l (100 for a decay), local tolerance 1e-11.");
    for scene in &context.outcome.scenes {
        let steady = scene.linear_regime.iter().flat_map(|outcome| &outcome.steady);
        for run in steady.filter_map(|run| run.as_ref().ok()) {
            table.push(steady_row(&scene.scene.name, run));
        }
    }
    unless_empty(table)
}

fn steady_row(scene: &str, run: &SteadyRun) -> Vec<Cell> {
    vec![
        Cell::text(scene),
        rounded(run.loading_velocity_m_per_s, 6),
        rounded(run.normal_stress_pa, 6),
        Cell::text(run.law.as_str()),
        rounded(run.departure, 2),
        rounded_or_empty(run.disturbed_over_disturbance, 3),
        rounded(run.free_residual_over_normal_stress, 2),
    ]
}
