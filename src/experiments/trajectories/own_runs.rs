//! The runs of a laboratory's own points, each with both laws: a table and a sentence.

use crate::experiments::operating_point::first_point;
use crate::experiments::operating_point::reach::{in_words, is_within_reach};
use crate::experiments::trajectories::TrajectoryRun;
use crate::experiments::trajectories::curves::runs_of;
use crate::experiments::trajectories::tables::{certain_of, period, stress_drop};
use crate::experiments::{Context, Need, Outcome, SceneOutcome, TableMaker, table_of};
use crate::scene::Quantity;
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "own-runs", needs: &[Need::Trajectories], make: runs }];

/// The laws in the order in which scenes name them.
pub(crate) const LAWS: [EvolutionLaw; 2] = [EvolutionLaw::Slip, EvolutionLaw::Aging];
/// Digits of a result, at most.
const DIGITS: usize = 3;

/// The runs of every point of a scene, the laws of a point together.
pub(crate) fn by_point(scene: &SceneOutcome) -> Vec<&[TrajectoryRun]> {
    let all = scene.trajectories.as_deref().unwrap_or_default();
    all.chunk_by(|one, next| one.point.id == next.point.id).collect()
}

/// The limit cycle that a run ends on.
pub(super) fn cycle(run: &TrajectoryRun) -> Option<&Simulation> {
    run.simulation.as_ref().ok().filter(|found| found.behaviour == Behaviour::Periodic)
}

fn runs(context: &Context) -> Option<Table> {
    let points = context.outcome.scenes.iter().flat_map(by_point);
    let mut table = table_of("own-runs", points)
        .text("point", |runs| runs[0].point.id.replace('-', " "))
        .digits("normal_stress_pa", DIGITS, |runs| &runs[0].point.normal_stress_pa)
        .digits("loading_velocity_m_per_s", DIGITS, |runs| &runs[0].point.loading_velocity_m_per_s)
        .text("slip_mode", |runs| runs[0].theory.slip_mode.words());
    for law in LAWS {
        let word = law.as_str();
        let of = move |runs: &[TrajectoryRun]| runs.iter().position(|run| run.law == law);
        let cell = move |runs: &[TrajectoryRun], value| {
            certain_of(of(runs).and_then(|at| cycle(&runs[at])), value, DIGITS)
        };
        table = table
            .number(&format!("period_{word}_s"), move |runs| cell(runs, period))
            .number(&format!("stress_drop_{word}_pa"), move |runs| cell(runs, stress_drop));
    }
    table.table()
}

/// What the runs at the first scene's own operating point do; `None` when none is there.
pub(crate) fn own_run_words(outcome: &Outcome) -> Option<String> {
    let (scene, Parameters { point, .. }) = first_point(outcome)?;
    let is_there = |run: &&TrajectoryRun| {
        [&run.point.normal_stress_pa, &run.point.loading_velocity_m_per_s]
            == [&point.normal_stress_pa, &point.loading_velocity_m_per_s]
    };
    let there = LAWS.into_iter().flat_map(|law| runs_of(scene, "", law)).filter(is_there);
    let found: Vec<String> = there.filter_map(run_words).collect();
    (!found.is_empty()).then(|| format!("Simulated at this point: {}.", found.join("; ")))
}

fn run_words(run: &TrajectoryRun) -> Option<String> {
    let found = run.simulation.as_ref().ok()?;
    let law = run.law.as_str();
    let Some((cycle, period)) = cycle(run).and_then(|cycle| Some((cycle, cycle.period_s?))) else {
        return Some(format!("with the {law} law, a return to steady sliding ({})", found.slip_mode.words()));
    };
    let peak = match is_within_reach(Quantity::LoadingVelocity, cycle.peak_velocity_m_per_s) {
        true => format!("slip at up to {}", in_words(cycle.peak_velocity_m_per_s, "m/s")),
        false => "slip at velocities out of reach".into(),
    };
    let (mode, period) = (cycle.slip_mode.words(), in_words(period, "s"));
    let drop = in_words(cycle.stress_drop_pa, "Pa");
    Some(format!("with the {law} law, {mode} every {period}, with a stress drop of {drop} and {peak}"))
}
