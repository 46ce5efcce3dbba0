//! Which tables there are, and what each needs.

use crate::experiments::Context;
use crate::experiments::Need;
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
    crate::experiments::boundary::tables::TABLES,
    crate::experiments::timings::coverage_table::TABLES,
    crate::experiments::tolerance::tables::TABLES,
    crate::experiments::hard_cases::return_tables::TABLES,
    crate::experiments::linear_regime::figures::TABLES,
    crate::experiments::zones::tables::TABLES,
    crate::experiments::near_transition::tables::TABLES,
    crate::experiments::hard_cases::tables::TABLES,
    crate::experiments::original_scheme::tables::TABLES,
    crate::experiments::onset::tables::TABLES,
    crate::experiments::simulations::tables::TABLES,
    crate::experiments::speed_counts::tables::TABLES,
    crate::experiments::start_sensitivity::tables::TABLES,
    crate::experiments::swept::tables::TABLES,
    crate::experiments::timings::tables::TABLES,
    crate::experiments::trajectories::tables::TABLES,
];

/// All tables of the experiments.
pub fn table_makers() -> impl Iterator<Item = &'static TableMaker> {
    ROOMS.iter().copied().flatten()
}

/// A table, unless it has no rows.
pub(crate) fn unless_empty(table: Table) -> Option<Table> {
    (!table.rows.is_empty()).then_some(table)
}
