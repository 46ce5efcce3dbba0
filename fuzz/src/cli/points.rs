//! Files of points.

#[path = "../../../src/cli/points/cells.rs"]
mod cells;
#[path = "../../../src/cli/points/header.rs"]
mod header;
#[path = "../../../src/cli/points/row_work.rs"]
mod row_work;
#[path = "../../../src/cli/points/rows.rs"]
mod rows;
#[path = "../../../src/cli/points/work.rs"]
mod work;

pub use cells::push_cell;
pub use header::{Header, absent, column_faults, names, other_unit};
pub use row_work::{Cells, Remark, RowWork};
pub use rows::{Block, Row, RowReader};
pub use work::{Work, Worked, cell_problem};
