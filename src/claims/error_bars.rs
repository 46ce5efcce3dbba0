//! What a ledger's verdicts hold for where values have error bars: all values within them, or those in the middle.

use serde::Serialize;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::over_box;

use crate::experiments::Outcome;
use crate::experiments::operating_point::error_bars;

slipmode_algebra::named! {
    /// The values for which a verdict was decided.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum DecidedFor {
        /// It is proved, and so is what it rests on: it holds for all values that meet the assumptions of the proofs.
        AllValues = "all-values",
        /// Runs, points or enclosures of the middle values decided it, too.
        MiddleValues = "middle-values",
    }
}

/// What a slider with error bars does at its operating point, decided for all values within them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointWithin {
    /// The scene.
    pub scene: String,
    /// The least and the greatest sign of K − K_c.
    pub transition_signs: [i8; 2],
    /// The slip modes that values within the error bars have: exactly these, and perhaps those not decided.
    pub slip_modes: Vec<String>,
    /// Slip modes that were neither found nor excluded.
    pub not_decided: Vec<String>,
    /// Whether all values have one slip mode.
    pub certain: bool,
    /// The largest share of the error bars in which a mode that was not decided could be.
    pub undecided_share: f64,
}

/// Every operating point with error bars.
pub(super) fn points_within(outcome: &Outcome) -> Vec<PointWithin> {
    let point = |scene: &crate::experiments::SceneOutcome| {
        let region = error_bars(scene)
            .filter(|_| scene.scene.parameters.as_ref().is_some_and(|it| it.point().is_some()))?;
        let found = over_box(region, &scene.scene.threshold())?;
        Some(PointWithin {
            scene: scene.scene.name.clone(),
            transition_signs: found.transition_signs,
            slip_modes: found.slip_modes.iter().map(|possible| possible.what.as_str().into()).collect(),
            not_decided: found.undecided.iter().map(|(mode, _)| mode.as_str().into()).collect(),
            certain: found.certain_mode().is_some(),
            undecided_share: nearest_f64(&found.undecided_share()),
        })
    };
    outcome.scenes.iter().filter_map(point).collect()
}
