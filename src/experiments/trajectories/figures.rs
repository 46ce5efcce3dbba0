//! Trajectories over time: the six slip modes (figs 3b to 3g) and the approach to steady sliding for a > b (figs 6b to 6d).

use crate::experiments::trajectories::curves::{
    extent, linear_axis, mode_words, power_markup, runs_of, series, stress_unit, velocity_ratio,
};
use crate::experiments::trajectories::{Moment, TrajectoryRun};
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::{EvolutionLaw, SlipMode};
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, Panel, Reference};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-3b-g", |outcome, words| slip_modes(outcome.potentially_unstable()?, words)),
    ("fig-6b-d", |outcome, words| approaches(outcome.intrinsically_stable()?, words)),
];

/// The law of the paper's figures.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

/// Height of a panel of the six.
const MODE_HEIGHT: f64 = 130.0;

fn slip_modes(scene: &SceneOutcome, words: &Words) -> Option<String> {
    words.panels(2, MODE_HEIGHT, runs_of(scene, "3", LAW).into_iter().filter_map(mode_panel).collect())
}

fn mode_panel(run: &TrajectoryRun) -> Option<Panel> {
    let course = run.course.as_ref().ok()?;
    let stresses = || course.moments.iter().map(|moment| moment.stress_change_pa);
    let (unit, size) = stress_unit(stresses());
    let [theory, simulation] = mode_words(run);
    let letter = run.point.id.trim_start_matches('3');
    Some(Panel {
        heading: vec![format!("**{letter}** {theory}"), simulation, place_words(run)],
        x: Axis::linear("Time", "s", 0.0, course.moments.last()?.time_s),
        y: linear_axis("Δ*τ*", unit, stresses().map(|stress| stress / size))?,
        series: vec![series(String::new(), run, |moment| (moment.time_s, moment.stress_change_pa / size))],
        references: vec![Reference::Horizontal { at: 0.0, label: String::new() }],
    })
}

/// σ and V_l of a run.
pub(crate) fn place_words(run: &TrajectoryRun) -> String {
    let stress = power_markup(nearest_f64(&run.point.normal_stress_pa));
    let velocity = power_markup(nearest_f64(&run.point.loading_velocity_m_per_s));
    format!("*σ* = {stress} Pa, *V*_l = {velocity} m/s")
}

/// Height of a panel of the three.
const APPROACH_HEIGHT: f64 = 170.0;

/// The panels of fig 6, by the beginning of their points' ids, with what they show.
const APPROACHES: [(&str, &str); 3] = [
    ("6b", "**b** across the upper boundary"),
    ("6c", "**c** from non-inertial to inertial oscillation"),
    ("6d", "**d** across the lower boundary"),
];

fn approaches(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let panel = |(prefix, words): (&str, &str)| approach_panel(&runs_of(scene, prefix, LAW), words);
    words.panels(1, APPROACH_HEIGHT, APPROACHES.into_iter().filter_map(panel).collect())
}

fn approach_panel(runs: &[&TrajectoryRun], words: &str) -> Option<Panel> {
    let moments = || runs.iter().flat_map(|run| run.course.iter().flat_map(|course| &course.moments));
    let (_, last) = extent(moments().map(|moment: &Moment| moment.time_s))?;
    let stress = power_markup(nearest_f64(&runs.first()?.point.normal_stress_pa));
    let lines = runs.iter().map(|run| {
        let velocity = power_markup(nearest_f64(&run.point.loading_velocity_m_per_s));
        let label = format!("{velocity} m/s, {}", damping_words(run));
        series(label, run, |moment| (moment.time_s, velocity_ratio(moment)))
    });
    Some(Panel {
        heading: vec![format!("{words}, *σ* = {stress} Pa")],
        x: Axis::linear("Time", "s", 0.0, last),
        y: linear_axis("*V*/*V*_l", "", moments().map(velocity_ratio).chain([0.0]))?,
        series: lines.collect(),
        references: vec![Reference::Horizontal { at: 1.0, label: String::new() }],
    })
}

/// What the theory's slip mode says of the damping, in a word that fits a legend.
fn damping_words(run: &TrajectoryRun) -> &'static str {
    match run.theory.slip_mode {
        SlipMode::OverdampedStableSliding | SlipMode::OverdampedOscillation => "overdamped",
        SlipMode::NonInertialUnderdampedOscillation => "non-inertial",
        SlipMode::InertialUnderdampedOscillation => "inertial",
        SlipMode::StickSlip | SlipMode::HarmonicVibration => "unstable",
    }
}
