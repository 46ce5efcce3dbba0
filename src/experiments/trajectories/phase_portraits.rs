//! Phase portraits: velocity against shear stress, where the line of steady sliding organises every run.

use crate::experiments::trajectories::curves::{
    extent, linear_axis, mode_words, runs_of, stress_unit, velocity_ratio,
};
use crate::experiments::trajectories::figures::place_words;
use crate::experiments::trajectories::{Moment, TrajectoryRun};
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::dynamics::Behaviour;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_plot::figure::{Axis, Panel, Series};

pub(crate) const FIGURES: &[Drawer] =
    &[("phase-portraits", |outcome, words| portraits(outcome.potentially_unstable()?, words))];

/// The points, one for each kind of motion.
const POINTS: [&str; 4] = ["3b", "3e", "3g", "3f"];
/// Height of a panel.
const HEIGHT: f64 = 190.0;

fn portraits(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let parameters = scene.slider()?;
    let panels = POINTS.into_iter().filter_map(|id| portrait(scene, parameters, id));
    words.panels(2, HEIGHT, panels.collect())
}

fn portrait(scene: &SceneOutcome, parameters: &Slider<Rational>, id: &str) -> Option<Panel> {
    let runs: Vec<&TrajectoryRun> = [EvolutionLaw::Slip, EvolutionLaw::Aging]
        .into_iter()
        .flat_map(|law| runs_of(scene, id, law))
        .collect();
    let moments = || runs.iter().flat_map(|run| shown(run));
    let stresses = || moments().map(|moment: &Moment| moment.stress_change_pa);
    let (unit, size) = stress_unit(stresses());
    let (slowest, fastest) = extent(moments().map(velocity_ratio))?;
    let first = runs.first()?;
    let [theory, _] = mode_words(first);
    let mut lines: Vec<Series> = runs
        .iter()
        .map(|run| {
            let place = |moment: &Moment| (velocity_ratio(moment), moment.stress_change_pa / size);
            Series::line(format!("{} law", run.law.as_str()), shown(run).iter().map(place).collect())
        })
        .collect();
    let (low, high) = (slowest / 1.5, fastest * 1.5);
    lines.push(steady_line(parameters, first, [low, high], size));
    Some(Panel {
        heading: vec![theory, place_words(first)],
        x: Axis::log10("*V*/*V*_l", "", low, high),
        y: linear_axis("Δ*τ*", unit, stresses().map(|stress| stress / size))?,
        series: lines,
        references: Vec::new(),
    })
}

/// The last return of a limit cycle, and the whole of a decay.
fn shown(run: &TrajectoryRun) -> &[Moment] {
    let Ok(course) = &run.course else { return &[] };
    let found = run.simulation.as_ref().ok().filter(|found| found.behaviour == Behaviour::Periodic);
    let return_s = found.and_then(|found| found.period_s).unwrap_or(f64::INFINITY);
    let end_s = course.moments.last().map_or(0.0, |moment| moment.time_s);
    // From the last moment before the return, so that the loop closes.
    let before = course.moments.partition_point(|moment| end_s - moment.time_s >= return_s);
    &course.moments[before.saturating_sub(1)..]
}

/// Steady sliding at other velocities: Δτ = (a − b) σ ln(V/V_l), eq 1 with θ = D_c/V.
fn steady_line(parameters: &Slider<Rational>, run: &TrajectoryRun, ends: [f64; 2], unit_pa: f64) -> Series {
    let effect = nearest_f64(&parameters.direct_effect) - nearest_f64(&parameters.evolution_effect);
    let stress = |ratio: f64| effect * nearest_f64(&run.point.normal_stress_pa) * libm::log(ratio) / unit_pa;
    Series::of_theory("steady sliding", ends.map(|ratio| (ratio, stress(ratio))).to_vec())
}
