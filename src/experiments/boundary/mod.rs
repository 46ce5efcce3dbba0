//! The exact boundary of a scene: its points, its marks, and the agreement of the three routes to it.

pub(crate) mod run;
pub(crate) mod tables;

pub use run::{BoundaryOutcome, END_ERROR, boundary_outcome};
pub use tables::{boundary_columns, boundary_row, vanishes};
