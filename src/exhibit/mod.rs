//! The figures and tables of a report, made from what was computed.
//!
//! An exhibit is asked for by id; the registry says what each needs, so that nothing is computed for figures nobody shows.

mod axes;
mod figures;
mod frequency;
mod maps;
mod tables;

pub use figures::{Figure, FigureMaker, figure_makers};
pub use tables::{TableMaker, table_makers};
