//! CSV files of points and of trajectories, read row by row in constant memory; every fault names line, row and column.
//!
//! The readers take a stream of bytes and open no file.

mod cells;
mod dialect;
mod header;
mod name;
mod peak_table;
mod recording;
mod row_work;
mod rows;
mod samples;
mod step_record;
mod wanted;
mod work;

pub use cells::{Column, Datum, joined, names, push_cell, push_cells};
pub use dialect::Dialect;
pub use header::Header;
pub use name::is_named;
pub use peak_table::{PeakTable, read_peak_table};
pub use recording::read_recording;
pub use row_work::{Cells, Remark, RowWork};
pub use rows::{Block, Input, Row, RowReader};
pub use step_record::read_step_record;
pub use wanted::misnamed;
pub use work::{Counts, Work, Worked};
