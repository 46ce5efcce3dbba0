//! Work against error of the integrators on one cycle.

pub(crate) mod run;

pub use run::{
    MeasuredReturn, NamedMethod, WorkCase, WorkPoint, reference_return, return_methods, return_of,
    work_precision,
};
