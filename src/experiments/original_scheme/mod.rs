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

use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker};

impl Experiment for OriginalSchemeSection {
    type Outcome = OriginalSchemeOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(original_scheme(setting.slider()?, self))
    }
}
