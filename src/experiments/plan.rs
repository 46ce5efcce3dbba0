//! The plan: what is requested, cut down to what a scene states, as items with stable ids.

use crate::experiments::Scene;
use crate::experiments::{Need, Needs};

/// One piece of work: one need of one scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Item<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// What of it.
    pub need: Need,
}

impl Item<'_> {
    /// The stable id, `scene/need`.
    #[must_use]
    pub fn id(&self) -> String {
        format!("{}/{}", self.scene.name, self.need.as_str())
    }
}

/// The items that `needs` and the scenes have in common, scene by scene in a fixed order.
#[must_use]
pub fn plan<'s>(scenes: &'s [Scene], needs: &Needs) -> Vec<Item<'s>> {
    scenes
        .iter()
        .flat_map(|scene| {
            needs.iter().filter(|need| states(scene, **need)).map(move |&need| Item { scene, need })
        })
        .collect()
}

/// Everything a scene states: what `slipmode run` computes.
#[must_use]
pub fn all_needs() -> Needs {
    Need::ALL.iter().copied().collect()
}

fn states(scene: &Scene, need: Need) -> bool {
    match need {
        Need::Map => scene.map.is_some(),
        Need::Boundary => scene.boundary.is_some(),
        Need::Frequency => scene.frequency.is_some(),
        Need::EffectRatioSweep => scene.effect_ratio_sweep.is_some(),
        Need::Tolerance => scene.tolerance.is_some(),
        Need::Zones => scene.zones.is_some(),
        Need::HardCases => scene.hard_cases.is_some(),
        Need::HardReturns => scene.hard_cases.as_ref().is_some_and(|section| section.returns.is_some()),
        Need::Simulations => scene.simulations.is_some(),
        Need::LinearRegime => scene.linear_regime.is_some(),
        Need::StartSensitivity => scene.start_sensitivity.is_some(),
        Need::Onset => scene.onset.is_some(),
        Need::NearTransition => scene.near_transition.is_some(),
        Need::Trajectories => scene.trajectories.is_some(),
        Need::OriginalScheme => scene.original_scheme.is_some(),
        Need::WorkPrecision => scene.work_precision.is_some(),
        Need::ErrorBound => scene.error_bound.is_some(),
        Need::SpeedCounts => scene.speed_counts.is_some(),
        Need::Timings => scene.timings.is_some(),
        Need::Swept => scene.swept.is_some(),
    }
}
