//! The fixed-step scheme of the original simulations compared with converged runs.

pub(crate) mod figures;
pub(crate) mod least_peak;
pub(crate) mod run;
pub(crate) mod scheme;
pub(crate) mod section;
pub(crate) mod stability;
pub(crate) mod tables;

pub use least_peak::SchemeLeastPeak;
pub use run::{OriginalSchemeOutcome, SchemeSeries, SchemeStep, original_scheme};
pub use scheme::{AFFORDABLE_STEPS, SchemePeak};
pub use section::OriginalSchemeSection;
pub use stability::{SchemeMapRow, SchemeTransition, critical_shift};

use crate::experiments::work::{SEARCH_RUNS, rectangle_points};
use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

impl Experiment for OriginalSchemeSection {
    type Outcome = OriginalSchemeOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        // With the step 0.1 a run takes as long as one to 1e-8; a search needs a quarter of the usual runs.
        let steps: f64 = self.steps.iter().map(|step| 0.1 / nearest_f64(step)).sum();
        let places = rectangle_points(&self.rectangle) + self.places.len() as f64;
        let searched = self.least_peak_stresses_pa.len() as f64 * SEARCH_RUNS / 4.0;
        Work::simulations((places + searched) * steps, 1e-8)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(original_scheme(setting.slider()?, self))
    }
}
