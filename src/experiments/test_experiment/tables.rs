//! The table of the test experiment.

use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[TableMaker {
    id: "test-experiment",
    needs: &[Need::TestExperiment],
    make: |context| stiffnesses(context),
}];

fn stiffnesses(context: &Context) -> Option<Table> {
    let columns = vec![Column::number("critical_stiffness_pa_per_m", "Critical stiffness", "Pa/m")];
    let mut table = Table::new("test-experiment", "Critical stiffness", columns);
    for stiffness in
        context.outcome.scenes.iter().filter_map(|scene| scene.test_experiment.as_ref()).flatten()
    {
        table.push(vec![Cell::number(rational_to_decimal(stiffness, 6))]);
    }
    unless_empty(table)
}
