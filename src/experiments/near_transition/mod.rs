//! The nonlinear slider close to K = K_c.

pub(crate) mod bistability;
pub(crate) mod cycle_families;
pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use bistability::{Edge, Threshold, place_on_transition};
pub use cycle_families::{AmplitudeDeviation, CycleFamilyOutcome, FamilyCycle};
pub use run::{NearRun, NearTransitionOutcome, near_transition};
pub use section::NearTransitionSection;

use crate::experiments::{Experiment, FigureMaker, Requirement, Setting, TableMaker};

impl Experiment for NearTransitionSection {
    type Outcome = NearTransitionOutcome;
    const REQUIREMENT: Requirement = Requirement::CriticalNormalStress;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(near_transition(setting.slider()?, self))
    }
}
