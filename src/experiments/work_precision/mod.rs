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

use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker};

impl Experiment for WorkPrecisionSection {
    type Outcome = Vec<WorkCase>;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(work_precision(setting.slider()?, self))
    }
}
