//! A scene's own operating point: its slip mode, the smallest changes that leave it, and which error bar decides it.

pub(crate) mod error_bars;
pub(crate) mod figures;
pub(crate) mod mark;
pub(crate) mod reach;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod words;

pub use error_bars::Bar;
pub use run::{Change, OperatingPointOutcome};
pub use section::OperatingPointSection;
pub use words::{operating_point_words, range_words, what_decides_words, what_leaves_words};

pub(crate) use words::error_bars;

use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for OperatingPointSection {
    type Outcome = OperatingPointOutcome;
    const REQUIREMENT: Requirement = Requirement::OperatingPoint;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::points(1.0, SECONDS)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        OperatingPointOutcome::of(setting)
    }
}

/// Core-seconds of an operating point with error bars.
const SECONDS: f64 = 1.0;
