//! The figures and tables of a report, made from what was computed.
//!
//! An exhibit is asked for by id; the registry says what each needs, so that nothing is computed for figures nobody shows.

mod axes;
mod boundary_tables;
mod deviation;
mod deviation_tables;
mod figures;
mod frequency;
mod maps;
mod mode_tables;
mod numeric_tables;
mod numerical_error;
mod numerical_error_tables;
mod simulation_map;
mod simulation_tables;
mod tables;
mod theory_tables;

pub use boundary_tables::{boundary_columns, boundary_row, vanishes};
pub use figures::{Figure, FigureMaker, figure_makers};
pub use tables::{TableMaker, table_makers};
