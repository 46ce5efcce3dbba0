//! Where each asymptote is good to a given relative error.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::{ToleranceOutcome, ToleranceRow, tolerance_limits};
pub use tables::place_of_limit;
