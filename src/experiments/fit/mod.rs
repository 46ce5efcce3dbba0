//! Friction parameters fitted to a record of velocity steps.

pub(crate) mod figures;
mod peaks;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod words;

pub use figures::fit_picture;
pub use peaks::peak_picture;
pub use run::FitOutcome;
pub use section::FitSection;
pub use words::{estimate_words, fit_words, shares_of_modes};

use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for FitSection {
    type Outcome = FitOutcome;
    const REQUIREMENT: Requirement = Requirement::Nothing;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::points(self.laws.len() as f64, SECONDS)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        FitOutcome::of(self, setting)
    }
}

/// Core-seconds of a fit with one law.
const SECONDS: f64 = 1.0;
