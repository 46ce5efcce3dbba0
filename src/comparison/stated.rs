//! What another program's run states.

use std::sync::Arc;

use super::Observable;
use crate::comparison::recording::Recording;
use slipmode_core::dynamics::Behaviour;
use slipmode_core::friction::{EvolutionLaw, Parameters, SlipMode};
use slipmode_core::number::Rational;

/// A word for what a run ends in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatedMode {
    /// Whether it ends in a cycle or in steady sliding.
    Behaviour(Behaviour),
    /// The slip mode.
    Slip(SlipMode),
}

impl StatedMode {
    /// All words: those of `simulate`'s mode, then those of the slip modes.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let behaviours = [Behaviour::Periodic, Behaviour::Decaying].map(Self::Behaviour);
        behaviours.into_iter().chain(SlipMode::ALL.map(Self::Slip)).collect()
    }

    /// The word.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Behaviour(behaviour) => behaviour.as_str(),
            Self::Slip(mode) => mode.as_str(),
        }
    }
}

/// One run.
#[derive(Debug, Clone, PartialEq)]
pub struct StatedRun {
    /// The slider.
    pub parameters: Parameters<Rational>,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Whether the run's start is known to be the one that our simulation takes.
    pub has_known_start: bool,
    /// Stated relative error of its values.
    pub tolerance: f64,
    /// What it ends in.
    pub mode: Option<StatedMode>,
    /// Values of [`Observable::STATED`], in their order.
    pub values: [Option<f64>; 4],
    /// Its trajectory.
    pub recording: Option<Arc<Recording>>,
}

impl StatedRun {
    /// The stated values that are there.
    pub fn stated(&self) -> impl Iterator<Item = (Observable, f64)> {
        Observable::STATED.into_iter().zip(self.values).filter_map(|(of, value)| Some((of, value?)))
    }

    /// Whether it states anything that can be compared.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mode.is_none() && self.recording.is_none() && self.values.iter().all(Option::is_none)
    }
}
