//! The fit of a scene's record, and the slip modes that it allows at the scene's operating point.

use std::sync::Arc;

use super::FitSection;
use crate::experiments::{References, SceneOutcome};
use crate::fitting::{FitFailure, Fits, StepRecord, sampled_modes};
use slipmode_core::stability::SlipMode;

/// A record with what was fitted to it.
#[derive(Debug, Clone)]
pub struct FitOutcome {
    /// The record.
    pub record: Arc<StepRecord>,
    /// The fits, or why there are none.
    pub fits: Result<Fits, FitFailure>,
    /// How many of the sampled sliders have which slip mode at the operating point; none without one, or without mass.
    pub modes: Option<Vec<(SlipMode, u32)>>,
}

impl FitOutcome {
    pub(super) fn of(section: &FitSection, earlier: &SceneOutcome, references: &References) -> Option<Self> {
        let record = references.records.get(&section.record)?.clone();
        let fits = Fits::of(&record, &section.laws, &section.given());
        let point = earlier.scene.parameters.as_ref().and_then(|parameters| parameters.point());
        let threshold = earlier.scene.threshold();
        let fitted = fits.as_ref().ok().zip(point);
        let modes = fitted.and_then(|(fits, point)| sampled_modes(&fits.best, &point, &threshold));
        Some(Self { record, fits, modes })
    }
}
