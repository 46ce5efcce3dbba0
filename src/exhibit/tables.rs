//! Which tables there are, and what each needs.

use crate::claims::Context;
use crate::study::Need;
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

/// The tables of every room, a line each.
const ROOMS: &[&[TableMaker]] = &[
    crate::exhibit::boundary_tables::TABLES,
    crate::exhibit::coverage_table::TABLES,
    crate::exhibit::deviation_tables::TABLES,
    crate::exhibit::hard_return_tables::TABLES,
    crate::exhibit::linear_regime::TABLES,
    crate::exhibit::mode_tables::TABLES,
    crate::exhibit::near_transition_tables::TABLES,
    crate::exhibit::numeric_tables::TABLES,
    crate::exhibit::numerical_error_tables::TABLES,
    crate::exhibit::onset_tables::TABLES,
    crate::exhibit::planted_fault_tables::TABLES,
    crate::exhibit::simulation_tables::TABLES,
    crate::exhibit::speed_tables::TABLES,
    crate::exhibit::start_tables::TABLES,
    crate::exhibit::swept_tables::TABLES,
    crate::exhibit::theory_tables::TABLES,
    crate::exhibit::timing_tables::TABLES,
    crate::exhibit::trajectory_tables::TABLES,
];

/// All tables.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    ROOMS.iter().copied().flatten()
}

/// A table, unless it has no rows.
pub(super) fn unless_empty(table: Table) -> Option<Table> {
    (!table.rows.is_empty()).then_some(table)
}
