//! Estimated errors of simulations compared with true errors.

pub(crate) mod run;

pub use run::{BoundCheck, error_bound};
