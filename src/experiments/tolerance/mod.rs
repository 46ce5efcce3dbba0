//! Where each asymptote is good to a given relative error.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod words;

pub use run::{ToleranceOutcome, ToleranceRow, tolerance_limits};
pub use section::ToleranceSection;
pub use tables::place_of_limit;
pub use words::{accuracy_of_asymptotes, at_most_per_cent};

use crate::experiments::work::certified_point_s;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for ToleranceSection {
    type Outcome = ToleranceOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::points(self.relative.len() as f64, 100.0 * certified_point_s(0.0))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(tolerance_limits(setting.slider()?, self))
    }
}
