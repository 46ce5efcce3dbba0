//! Every completion of the start V = V_l/10 at a few points.

pub(crate) mod run;
pub(crate) mod tables;

pub use run::{Early, StartGroup, StartRun, start_sensitivity};
