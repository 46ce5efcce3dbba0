//! The plan and its run: what is required, cut down to what the scenes state. Pure, and the same values on any number
//! of threads.

use std::collections::BTreeSet;

use crate::experiments::{Need, Outcome, References, Scene, SceneOutcome};

/// A set of required computations, in a fixed order.
pub type Needs = BTreeSet<Need>;

/// Hears of each item that is about to be computed: its id, the estimated work before it, and that of all items, in hundredths of a
/// core-second.
pub type Progress<'p> = &'p dyn Fn(&str, usize, usize);

/// Computes what the needs and the scenes have in common, item by item; each item spreads over the threads.
#[must_use]
pub fn run(scenes: &[Scene], needs: &Needs, references: &References, progress: Progress) -> Outcome {
    let items = plan(scenes, needs);
    let mut outcome = Outcome { scenes: scenes.iter().cloned().map(SceneOutcome::new).collect() };
    let estimates: Vec<usize> = items.iter().map(|&(scene, need)| estimate(&scenes[scene], need)).collect();
    let (mut before, all) = (0, estimates.iter().sum());
    for (&(scene, need), estimate) in items.iter().zip(&estimates) {
        let id = format!("{}/{}", scenes[scene].name, need.key().replace('_', "-"));
        progress(&id, before, all);
        need.compute(&mut outcome.scenes[scene], references);
        before += estimate;
    }
    outcome
}

/// Hundredths of a core-second that an item may take, at least one.
fn estimate(scene: &Scene, need: Need) -> usize {
    let work = scene.work().into_iter().find(|(key, _)| *key == need.key());
    work.map_or(1, |(_, work)| (100.0 * work.core_seconds) as usize).max(1)
}

/// The computations that are required and stated: the index of the scene and what to compute, scene by scene.
fn plan(scenes: &[Scene], needs: &Needs) -> Vec<(usize, Need)> {
    let of = |(index, scene)| {
        needs.iter().filter(move |need| need.is_stated_by(scene)).map(move |&need| (index, need))
    };
    scenes.iter().enumerate().flat_map(of).collect()
}

/// Everything a scene states: what `slipmode run` computes.
#[must_use]
pub fn all_needs() -> Needs {
    Need::ALL.iter().copied().collect()
}
