//! Sweeps that ran elsewhere, and what running them took.

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{Swept, read_swept};
pub use section::{SweptEntry, SweptSection};
