//! Which tables there are, and what each needs.

use crate::experiments::{Context, Need};
use slipmode_plot::table::Table;

/// How a table is made.
#[derive(Debug)]
pub struct TableMaker {
    /// The table's id.
    pub id: &'static str,
    /// What must have been computed.
    pub needs: &'static [Need],
    /// Fills it; `None` when the scenes do not hold what it lists.
    pub make: fn(&Context) -> Option<Table>,
}
