//! Exact slip modes compared with the simplified map of the asymptotes (fig 7).

pub(crate) mod run;
pub(crate) mod tables;

pub use run::{ThresholdShare, ZonesOutcome, compare_zones};
