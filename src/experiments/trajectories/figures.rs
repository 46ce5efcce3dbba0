//! Panels of runs: the six slip modes (figs 3b to 3g) and the approach to steady sliding for a > b (figs 6b to 6d) over time, phase
//! portraits, where the line of steady sliding organises every run, and the runs of a laboratory's own points.

use crate::experiments::described::{extent, over};
use crate::experiments::trajectories::curves::{power_markup, runs_of, stress_unit};
use crate::experiments::trajectories::own_runs::{LAWS, by_point, cycle};
use crate::experiments::trajectories::{Moment, TrajectoryRun};
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::{EvolutionLaw, SlipMode};
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Panel, Scale, Series};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-3b-g", |outcome, words| {
        let runs = runs_of(outcome.potentially_unstable()?, "3", LAW);
        words.panels(runs.into_iter().filter_map(|run| STRESS.panel(words, "", &[run])))
    }),
    ("fig-6b-d", |outcome, words| {
        let scene = outcome.intrinsically_stable()?;
        let panel = |(id, title)| VELOCITY.panel(words, title, &runs_of(scene, id, LAW));
        words.panels(APPROACHES.into_iter().filter_map(panel))
    }),
    ("phase-portraits", |outcome, words| {
        let scene = outcome.potentially_unstable()?;
        words.panels(PORTRAITS.into_iter().filter_map(|id| portrait(scene, words, id)))
    }),
    ("own-runs", |outcome, words| {
        let scene = outcome.scenes.iter().find(|scene| scene.trajectories.is_some())?;
        let panel = |runs: &[TrajectoryRun]| STRESS.panel(words, "", &runs.iter().collect::<Vec<_>>());
        words.panels(by_point(scene).into_iter().filter_map(panel))
    }),
];

/// The law of the paper's figures.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

/// The panels of fig 6, by the beginning of their points' ids, with what they show.
const APPROACHES: [(&str, &str); 3] = [
    ("6b", "**b** across the upper boundary"),
    ("6c", "**c** from non-inertial to inertial oscillation"),
    ("6d", "**d** across the lower boundary"),
];

/// The points of the phase portraits, one for each kind of motion.
const PORTRAITS: [&str; 4] = ["3b", "3e", "3g", "3f"];

/// What a panel shows of its runs.
struct Shown {
    moments: fn(&TrajectoryRun) -> &[Moment],
    /// Where a moment is drawn, with the unit of stress in Pa.
    place: fn(&Moment, f64) -> (f64, f64),
    /// A height that the panel shows even where no run reaches it.
    with: Option<f64>,
}

const STRESS: Shown =
    Shown { moments: all_of, place: |at, unit_pa| (at.time_s, at.stress_change_pa / unit_pa), with: None };
const VELOCITY: Shown =
    Shown { moments: all_of, place: |at, _| (at.time_s, libm::exp(at.log_velocity_ratio)), with: Some(0.0) };
const PORTRAIT: Shown = Shown {
    moments: last_return,
    place: |at, unit_pa| (libm::exp(at.log_velocity_ratio), at.stress_change_pa / unit_pa),
    with: None,
};

impl Shown {
    /// The described panel with these runs; its heading is about the first of them.
    fn panel(&self, words: &Words, title: &str, runs: &[&TrajectoryRun]) -> Option<Panel> {
        let moments = || runs.iter().flat_map(|run| (self.moments)(run));
        let (unit, unit_pa) = stress_unit(moments().map(|moment| moment.stress_change_pa));
        let place = |moment: &Moment| (self.place)(moment, unit_pa);
        let described = |run: &TrajectoryRun| described(words, run, &[("title", title), ("unit", unit)]);
        let line = |&run: &&TrajectoryRun| {
            let series = described(run)?.series.into_iter().next()?;
            Some(Series { points: (self.moments)(run).iter().map(place).collect(), ..series })
        };
        let mut panel = described(runs.first()?)?;
        let (first, last) = extent(moments().map(|moment| place(moment).0))?;
        let room = if panel.x.scale == Scale::Log10 { 1.5 } else { 1.0 };
        (panel.x.min, panel.x.max) = (first / room, last * room);
        panel.y = over(&panel.y, moments().map(|moment| place(moment).1).chain(self.with))?;
        panel.series.splice(..1, runs.iter().filter_map(line));
        Some(panel)
    }
}

/// The described panel with what is known of a run in the place of the names in braces.
fn described(words: &Words, run: &TrajectoryRun, more: &[(&str, &str)]) -> Option<Panel> {
    let theory = run.theory.slip_mode;
    let simulated = match &run.simulation {
        Ok(found) if found.slip_mode == theory => "by theory and by simulation".into(),
        Ok(found) => format!("by theory; simulated: {}", found.slip_mode.words()),
        Err(_) => "by theory; not simulated".into(),
    };
    let damping = match theory {
        SlipMode::OverdampedStableSliding | SlipMode::OverdampedOscillation => "overdamped",
        SlipMode::NonInertialUnderdampedOscillation => "non-inertial",
        SlipMode::InertialUnderdampedOscillation => "inertial",
        SlipMode::StickSlip | SlipMode::HarmonicVibration => "unstable",
    };
    let known: [(&str, &str); 8] = [
        ("point", &run.point.id.replace('-', " ")),
        ("letter", run.point.id.trim_start_matches('3')),
        ("mode", theory.words()),
        ("simulated", &simulated),
        ("damping", damping),
        ("stress", &power_markup(nearest_f64(&run.point.normal_stress_pa))),
        ("velocity", &power_markup(nearest_f64(&run.point.loading_velocity_m_per_s))),
        ("law", run.law.as_str()),
    ];
    words.panel(&[&known, more].concat())
}

fn all_of(run: &TrajectoryRun) -> &[Moment] {
    run.course.as_ref().map_or(&[], |course| &course.moments)
}

/// The last return of a limit cycle, and the whole of a decay.
fn last_return(run: &TrajectoryRun) -> &[Moment] {
    let moments = all_of(run);
    let return_s = cycle(run).and_then(|found| found.period_s).unwrap_or(f64::INFINITY);
    let end_s = moments.last().map_or(0.0, |moment| moment.time_s);
    // From the last moment before the return, so that the loop closes.
    let before = moments.partition_point(|moment| end_s - moment.time_s >= return_s);
    &moments[before.saturating_sub(1)..]
}

/// Both laws at a point, with steady sliding at other velocities: Δτ = (a − b) σ ln(V/V_l), eq 1 with θ = D_c/V.
fn portrait(scene: &SceneOutcome, words: &Words, id: &str) -> Option<Panel> {
    let runs = LAWS.into_iter().flat_map(|law| runs_of(scene, id, law)).collect::<Vec<_>>();
    let mut panel = PORTRAIT.panel(words, "", &runs)?;
    let slider = scene.slider()?.map(nearest_f64);
    let stress_pa = nearest_f64(&runs.first()?.point.normal_stress_pa);
    let (_, unit_pa) =
        stress_unit(runs.iter().flat_map(|run| last_return(run)).map(|at| at.stress_change_pa));
    let effect = slider.direct_effect - slider.evolution_effect;
    let steady = |ratio: f64| (ratio, effect * stress_pa * libm::log(ratio) / unit_pa);
    panel.series.last_mut()?.points = [panel.x.min, panel.x.max].map(steady).to_vec();
    Some(panel)
}
