//! Work against error of the integrators on one cycle.

pub(crate) mod run;
pub(crate) mod section;

pub use run::{
    MeasuredReturn, NamedMethod, WorkCase, WorkPoint, reference_return, return_methods, return_of,
    work_precision,
};
pub use section::WorkPrecisionSection;

use crate::experiments::{Experiment, Setting};

impl Experiment for WorkPrecisionSection {
    type Outcome = Vec<WorkCase>;

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(work_precision(setting.slider()?, self))
    }
}
