//! The figures and tables of a report, made from what was computed.
//!
//! An exhibit is requested by id; the registry says what each needs, so that nothing is computed for figures nobody shows.

mod axes;
mod boundary_tables;
mod coverage_table;
mod deviation;
mod deviation_tables;
mod explorer;
mod explorer_formulas;
mod explorer_tables;
mod figures;
mod frequency;
mod hard_return_tables;
mod least_peak;
mod linear_regime;
mod map_readout;
mod maps;
mod mode_tables;
mod near_transition;
mod near_transition_tables;
mod numeric_tables;
mod numerical_error;
mod numerical_error_tables;
mod onset;
mod onset_tables;
mod overshoot_map;
mod phase_portraits;
mod planted_fault_tables;
mod simulation_map;
mod simulation_tables;
mod speed_figures;
mod speed_tables;
mod start_tables;
mod swept;
mod swept_tables;
mod tables;
mod theory_tables;
mod timing_tables;
mod trajectory_curves;
mod trajectory_figures;
mod trajectory_tables;

pub use boundary_tables::{boundary_columns, boundary_row, vanishes};
pub use deviation_tables::place_of_limit;
pub use explorer::{Control, Explorer, FormulaRow, PointRow, Varying, Window, explorer};
pub use figures::{Figure, FigureMaker, figure_makers};
pub use tables::{TableMaker, table_makers};
