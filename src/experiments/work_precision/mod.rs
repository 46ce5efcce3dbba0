//! Work against error of the integrators on one cycle.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{
    MeasuredReturn, NamedMethod, WorkCase, WorkPoint, reference_return, return_methods, return_of,
    work_precision,
};
pub use section::WorkPrecisionSection;

use crate::experiments::work::SEARCH_RUNS;
use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker, Work};

impl Experiment for WorkPrecisionSection {
    type Outcome = Vec<WorkCase>;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::simulations(self.places.len() as f64 * SEARCH_RUNS, 1e-8)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(work_precision(setting.slider()?, self))
    }
}
