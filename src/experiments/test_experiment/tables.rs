//! The table of the test experiment.

use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[TableMaker {
    id: "test-experiment",
    needs: &[Need::TestExperiment],
    make: |context| stiffnesses(context),
}];

fn stiffnesses(context: &Context) -> Option<Table> {
    let stiffnesses = context.outcome.each(|scene| &scene.test_experiment).flat_map(|(_, found)| found);
    table_of("test-experiment", stiffnesses)
        .digits("critical_stiffness_pa_per_m", 6, |stiffness| stiffness)
        .table()
}
