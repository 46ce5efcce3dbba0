//! Small disturbances against the roots: tables of all runs and of their extremes, and the mismatch over the amplitude.

use crate::experiments::Context;
use crate::experiments::linear_regime::{Mismatch, ModeRuns, SteadyRun};
use crate::experiments::unless_empty;
use crate::experiments::{Figure, FigureMaker, TableMaker};
use crate::experiments::{Need, Outcome, SceneOutcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "linear-regime", needs: &[Need::LinearRegime], make: all_runs },
    TableMaker { id: "linear-regime-extremes", needs: &[Need::LinearRegime], make: extremes },
    TableMaker { id: "steady-sliding", needs: &[Need::LinearRegime], make: steady },
];

pub(crate) const FIGURES: &[FigureMaker] = &[FigureMaker {
    id: "small-disturbances",
    needs: &[Need::LinearRegime],
    data: &["linear-regime", "linear-regime-extremes"],
    make: mismatch_chart,
}];

fn runs_of(scene: &SceneOutcome) -> impl Iterator<Item = &ModeRuns> {
    scene.linear_regime.iter().flat_map(|outcome| &outcome.runs).filter_map(|run| run.as_ref().ok())
}

fn failures_of(scene: &SceneOutcome) -> usize {
    let outcome = scene.linear_regime.iter();
    outcome.flat_map(|outcome| &outcome.runs).filter(|run| run.is_err()).count()
}

fn number(value: f64, digits: usize) -> Cell {
    Cell::number(round_digits(value, digits))
}

fn optional(value: Option<f64>, digits: usize) -> Cell {
    value.map_or_else(Cell::empty, |value| number(value, digits))
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
                number(run.loading_velocity_m_per_s, 6),
                number(run.normal_stress_pa, 6),
                Cell::text(run.slip_mode.as_str()),
                Cell::text(run.law.as_str()),
                number(run.growth_rate, 8),
                number(run.angular_frequency, 8),
                Cell::text(run.direction.as_str()),
                number(first.amplitude, 3),
                number(first.size(), 3),
                number(last.amplitude, 3),
                number(last.growth.abs(), 3),
                number(last.frequency.abs(), 3),
                number(last.snapshots, 3),
                optional(run.order(), 5),
                number(run.coefficient, 4),
                optional(run.off_prediction(), 2),
                number(run.difference_of_64_bit, 2),
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
            Cell::number(group.runs.len().to_string()),
            optional(amplitude, 3),
            number(group.largest(ModeRuns::least_mismatch), 2),
            optional(farthest, 5),
            number(group.largest(ModeRuns::off_prediction), 2),
            number(group.largest(|run| Some(run.difference_of_64_bit)), 2),
            Cell::number(failures.map_or(0, failures_of).to_string()),
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
        number(run.loading_velocity_m_per_s, 6),
        number(run.normal_stress_pa, 6),
        Cell::text(run.law.as_str()),
        number(run.departure, 2),
        optional(run.disturbed_over_disturbance, 3),
        number(run.free_residual_over_normal_stress, 2),
    ]
}

const DESCRIPTION: &str = "Relative mismatch between the rate of a small disturbance and the root of the cubic, against the size of the disturbance, on logarithmic axes. Four series, the starts with the largest and smallest constant under each evolution law, follow straight lines of slope one over eight decades. The largest constants of the two laws nearly coincide. Only the smallest mismatches reach the rounding level of 64-bit runs.";

fn mismatch_chart(outcome: &Outcome) -> Option<Figure> {
    let all: Vec<&ModeRuns> = outcome.scenes.iter().flat_map(runs_of).collect();
    let mut series = Vec::new();
    for law in [EvolutionLaw::Slip, EvolutionLaw::Aging] {
        let mut runs: Vec<&ModeRuns> = all.iter().copied().filter(|run| run.law == law).collect();
        runs.sort_by(|a, b| b.coefficient.total_cmp(&a.coefficient));
        for (run, which) in [(runs.first(), "largest"), (runs.last(), "smallest")] {
            series.extend(run.map(|run| measured(&format!("{} law, {which} constant", law.as_str()), run)));
        }
    }
    let amplitudes = all.iter().flat_map(|run| &run.mismatches).map(|mismatch| mismatch.amplitude);
    let (least, most) =
        amplitudes.fold((f64::INFINITY, 0.0f64), |(least, most), a| (least.min(a), most.max(a)));
    let floor = all.iter().map(|run| run.difference_of_64_bit).fold(0.0, f64::max);
    let decade = |value: f64, round: fn(f64) -> f64| libm::exp10(round(libm::log10(value)));
    let highest = series.iter().flat_map(|s| &s.points).map(|point| point.1).fold(0.0, f64::max);
    let lowest = series.iter().flat_map(|s| &s.points).map(|point| point.1).fold(floor, f64::min);
    let caption =
        Caption::new("small-disturbances", "Mismatch with the roots against amplitude", DESCRIPTION);
    let chart = LineChart {
        caption,
        x: Axis::log10("Amplitude of the start", "", least, most),
        y: Axis::log10("|*p*_m − *p*| / |*p*|", "", decade(lowest, libm::floor), decade(highest, libm::ceil)),
        series,
        references: vec![Reference::Horizontal { at: floor, label: "rounding of 64-bit runs".into() }],
        bands: Vec::new(),
        labels: Vec::new(),
    };
    (least < most && floor > 0.0).then(|| Figure {
        id: "small-disturbances".into(),
        label: "Figure L1".into(),
        caption_markdown: "Relative mismatch between the measured rate of a small disturbance and the certified root, against the size of the disturbance: for each law, the starts with the largest and the smallest predicted constant of all points. The nonlinear runs are in double-double. All lines have slope 1, as the quadratic terms require; the lines of other starts lie between them. The grey line is the largest difference of a 64-bit run at the smallest amplitude.".into(),
        description: DESCRIPTION.into(),
        svg: chart.svg(),
    })
}

fn measured(label: &str, run: &ModeRuns) -> Series {
    let point = |mismatch: &Mismatch| (mismatch.amplitude, mismatch.size());
    let points = run.mismatches.iter().map(point).collect();
    Series { label: label.into(), points, marked: true, theory: false }
}
