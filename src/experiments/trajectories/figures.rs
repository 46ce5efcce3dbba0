//! Trajectories over time: the six slip modes (figs 3b to 3g) and the approach to steady sliding for a > b (figs 6b to 6d).

use crate::experiments::trajectories::curves::{
    extent, linear_axis, mode_words, power_markup, runs_of, series, stress_unit, velocity_ratio,
};
use crate::experiments::trajectories::{Moment, TrajectoryRun};
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use slipmode_core::friction::{EvolutionLaw, SlipMode};
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, Caption, Panel, Panels, Reference};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker::new("fig-3b-g", &[Need::Trajectories], &["trajectory-modes", "trajectories"], |outcome| {
        slip_modes(outcome.potentially_unstable()?)
    }),
    FigureMaker::new("fig-6b-d", &[Need::Trajectories], &["trajectory-modes", "trajectories"], |outcome| {
        approaches(outcome.intrinsically_stable()?)
    }),
];

/// The law of the paper's figures.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

const MODES_DESCRIPTION: &str = "Six panels of shear stress against time. Panels b and c show a sawtooth of slow loading and sudden drops, larger and rarer in b at the higher normal stress. Panel d shows a slow oscillation that decays after two swings. Panel e shows a steady vibration at the natural period that neither grows nor decays. Panel f rises once and approaches steady sliding without oscillation. Panel g shows a fast oscillation that decays over more than six swings.";
const MODES_CAPTION: &str = "Shear stress relative to steady sliding, against time, in each of the six cases of section 3.1 (compare figs 3b to 3g of the paper), slip law, from steady sliding at a tenth of the loading velocity. The paper's text does not state its points; ours lie well inside each area and are marked in figure 3a. Curves are converged, drawn to half a pixel. The table has periods and peaks with their errors.";

/// Height of a panel of the six.
const MODE_HEIGHT: f64 = 130.0;

fn slip_modes(scene: &SceneOutcome) -> Option<Figure> {
    let panels: Vec<Panel> = runs_of(scene, "3", LAW).into_iter().filter_map(mode_panel).collect();
    let figure = Panels {
        caption: Caption::new("fig-3b-g", "The six slip modes, simulated", MODES_DESCRIPTION),
        columns: 2,
        height: MODE_HEIGHT,
        panels,
    };
    (!figure.panels.is_empty())
        .then(|| Figure::new(&figure.caption, "Figures 3b to 3g", MODES_CAPTION, figure.svg()))
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

const APPROACH_DESCRIPTION: &str = "Three panels of velocity divided by loading velocity against time, four loading velocities in each. In panel b, at high normal stress, the slower two rise to the loading velocity without exceeding it, and the faster two vibrate about it. In panel c the slower two show one rise and one trough, and the faster two vibrate. In panel d, at low normal stress, the slower two exceed the loading velocity by less than a tenth and return to it slowly from above, and the faster two vibrate.";
const APPROACH_CAPTION: &str = "Velocity divided by loading velocity after a start at a tenth of it, for a > b and the slip law (compare figs 6b to 6d of the paper): across the upper boundary (b), from non-inertial to inertial oscillation (c) and across the lower boundary (d). The legend names the exact class of each point: overdamped, or a non-inertial or inertial underdamped oscillation. The paper's text does not state its points; ours are marked in the simulated figure 6a. Curves are converged, drawn to half a pixel.";

/// Height of a panel of the three.
const APPROACH_HEIGHT: f64 = 170.0;

/// The panels of fig 6, by the beginning of their points' ids, with what they show.
const APPROACHES: [(&str, &str); 3] = [
    ("6b", "**b** across the upper boundary"),
    ("6c", "**c** from non-inertial to inertial oscillation"),
    ("6d", "**d** across the lower boundary"),
];

fn approaches(scene: &SceneOutcome) -> Option<Figure> {
    let panel = |(prefix, words): (&str, &str)| approach_panel(&runs_of(scene, prefix, LAW), words);
    let figure = Panels {
        caption: Caption::new(
            "fig-6b-d",
            "The approach to steady sliding for a > b, simulated",
            APPROACH_DESCRIPTION,
        ),
        columns: 1,
        height: APPROACH_HEIGHT,
        panels: APPROACHES.into_iter().filter_map(panel).collect(),
    };
    (!figure.panels.is_empty())
        .then(|| Figure::new(&figure.caption, "Figures 6b to 6d", APPROACH_CAPTION, figure.svg()))
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
