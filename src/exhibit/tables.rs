//! Which tables there are, and what each needs.

use crate::claims::Context;
use crate::exhibit::{
    boundary_tables, deviation_tables, mode_tables, numeric_tables, numerical_error_tables,
    simulation_tables, theory_tables,
};
use crate::study::Need;
use crate::table::Table;

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

/// All tables.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    [
        theory_tables::TABLES,
        boundary_tables::TABLES,
        deviation_tables::TABLES,
        mode_tables::TABLES,
        numeric_tables::TABLES,
        simulation_tables::TABLES,
        numerical_error_tables::TABLES,
    ]
    .into_iter()
    .flatten()
}

/// A table, unless it has no rows.
pub(super) fn unless_empty(table: Table) -> Option<Table> {
    (!table.rows.is_empty()).then_some(table)
}
