//! Running a plan: pure, and the same values on any number of threads.

use crate::experiments::Scene;
use crate::experiments::boundary::boundary_outcome;
use crate::experiments::effect_ratio_sweep::sweep_effect_ratio;
use crate::experiments::error_bound::error_bound;
use crate::experiments::frequency::frequency_lines;
use crate::experiments::hard_cases::{compare_hard_cases, run_hard_returns};
use crate::experiments::linear_regime::linear_regime;
use crate::experiments::map::classify_rectangle;
use crate::experiments::near_transition::near_transition;
use crate::experiments::onset::onset;
use crate::experiments::original_scheme::original_scheme;
use crate::experiments::simulations::simulations;
use crate::experiments::speed_counts::speed_counts;
use crate::experiments::start_sensitivity::start_sensitivity;
use crate::experiments::swept::SweptEntry;
use crate::experiments::tolerance::tolerance_limits;
use crate::experiments::trajectories::trajectories;
use crate::experiments::work_precision::work_precision;
use crate::experiments::zones::compare_zones;
use crate::experiments::{Item, Need, Needs, Outcome, References, SceneOutcome, plan};
use slipmode_core::stability::InertialThreshold;

/// Hears of each item that is about to be computed: its id, its number and how many there are.
pub type Progress<'p> = &'p dyn Fn(&str, usize, usize);

/// Computes what the needs and the scenes have in common, item by item; each item spreads over the threads.
#[must_use]
pub fn run(scenes: &[Scene], needs: &Needs, references: &References, progress: Progress) -> Outcome {
    let items = plan(scenes, needs);
    let mut outcome = Outcome { scenes: scenes.iter().cloned().map(SceneOutcome::new).collect() };
    for (index, item) in items.iter().enumerate() {
        progress(&item.id(), index, items.len());
        if let Some(scene) = outcome.scenes.iter_mut().find(|scene| scene.scene.name == item.scene.name) {
            compute(item, scene, references);
        }
    }
    outcome
}

/// The threshold between inertial and non-inertial that a scene chose, or the default.
#[must_use]
pub fn inertial_threshold(scene: &Scene) -> InertialThreshold {
    scene.inertial_threshold.as_ref().and_then(InertialThreshold::from_ratio).unwrap_or_default()
}

fn compute(item: &Item, outcome: &mut SceneOutcome, references: &References) {
    let scene = item.scene;
    let parameters = scene.parameters.as_ref().map(|section| &section.slider);
    let threshold = inertial_threshold(scene);
    match item.need {
        Need::Map => {
            outcome.map = parameters
                .zip(scene.map.as_ref())
                .map(|(parameters, map)| classify_rectangle(parameters, map, &threshold));
        }
        Need::Boundary => {
            outcome.boundary = parameters
                .zip(scene.boundary)
                .map(|(parameters, section)| boundary_outcome(parameters, section));
        }
        Need::Frequency => {
            outcome.frequency = parameters
                .zip(scene.frequency.as_ref())
                .map(|(parameters, section)| frequency_lines(parameters, section));
        }
        Need::EffectRatioSweep => {
            outcome.effect_ratio_sweep = scene.effect_ratio_sweep.as_ref().map(sweep_effect_ratio)
        }
        Need::Tolerance => {
            outcome.tolerance = parameters
                .zip(scene.tolerance.as_ref())
                .map(|(parameters, section)| tolerance_limits(parameters, section));
        }
        Need::Zones => {
            // A map of the same rectangle has the exact half already.
            let same = outcome.map.as_ref().filter(|_| scene.map == scene.zones);
            outcome.zones = parameters.zip(scene.zones.as_ref()).map(|(parameters, rectangle)| match same {
                Some(map) => compare_zones(parameters, map),
                None => compare_zones(parameters, &classify_rectangle(parameters, rectangle, &threshold)),
            });
        }
        Need::HardCases => {
            let cases =
                scene.hard_cases.as_ref().and_then(|section| references.hard_cases.get(&section.file));
            outcome.hard_cases = cases.map(|cases| compare_hard_cases(cases));
        }
        Need::HardReturns => {
            let file = scene.hard_cases.as_ref().and_then(|section| section.returns.as_ref());
            let returns = file.and_then(|file| references.hard_returns.get(file));
            outcome.hard_returns = returns.map(|returns| run_hard_returns(returns));
        }
        Need::Simulations => {
            outcome.simulations = parameters
                .zip(scene.simulations.as_ref())
                .map(|(parameters, section)| simulations(parameters, section, &threshold));
        }
        Need::Trajectories => {
            outcome.trajectories = parameters
                .zip(scene.trajectories.as_ref())
                .map(|(parameters, section)| trajectories(parameters, section, &threshold));
        }
        Need::LinearRegime => {
            outcome.linear_regime = parameters
                .zip(scene.linear_regime.as_ref())
                .map(|(parameters, section)| linear_regime(parameters, section, &threshold));
        }
        Need::StartSensitivity => {
            outcome.start_sensitivity = parameters
                .zip(scene.start_sensitivity.as_ref())
                .map(|(parameters, section)| start_sensitivity(parameters, section, &threshold));
        }
        Need::Onset => {
            outcome.onset = parameters
                .zip(scene.onset.as_ref())
                .map(|(parameters, section)| onset(parameters, section, &threshold));
        }
        Need::NearTransition => {
            outcome.near_transition = parameters
                .zip(scene.near_transition.as_ref())
                .map(|(parameters, section)| near_transition(parameters, section));
        }
        Need::OriginalScheme => {
            outcome.original_scheme = parameters
                .zip(scene.original_scheme.as_ref())
                .map(|(parameters, section)| original_scheme(parameters, section));
        }
        Need::WorkPrecision => {
            outcome.work_precision = parameters
                .zip(scene.work_precision.as_ref())
                .map(|(parameters, section)| work_precision(parameters, section));
        }
        Need::ErrorBound => outcome.error_bound = scene.error_bound.as_ref().map(error_bound),
        Need::SpeedCounts => {
            outcome.speed_counts = parameters
                .zip(scene.speed_counts.as_ref())
                .map(|(parameters, section)| speed_counts(parameters, section));
        }
        Need::Timings => {
            outcome.timings =
                scene.timings.as_ref().and_then(|section| references.timings.get(section)).cloned();
        }
        Need::Swept => {
            let of = |entry: &SweptEntry| references.swept.get(&entry.name).cloned();
            outcome.swept =
                scene.swept.as_ref().map(|section| section.sweeps.iter().filter_map(of).collect());
        }
    }
}
