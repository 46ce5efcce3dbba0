//! The table of work against error.

use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "work-precision", needs: &[Need::WorkPrecision], make: work }];

fn work(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::text("method", "Method"),
        Column::number("setting", "Local tolerance, or step / √(M/K)", ""),
        Column::number("steps", "Steps", ""),
        Column::number("evaluations", "Evaluations", ""),
        Column::number("peak_error", "Error of ln(V_peak/V0)", ""),
    ];
    let mut table = Table::new(
        "work-precision",
        "Work against error on one period of the limit cycle, slip law",
        columns,
    );
    for case in context.outcome.scenes.iter().filter_map(|scene| scene.work_precision.as_ref()).flatten() {
        for point in &case.points {
            table.push(vec![
                rounded(nearest_f64(&case.place.normal_stress_pa), 4),
                rounded(nearest_f64(&case.place.loading_velocity_m_per_s), 4),
                Cell::text(point.method),
                rounded(point.setting, 4),
                count(point.steps),
                count(point.evaluations),
                rounded(point.peak_error, 2),
            ]);
        }
    }
    unless_empty(table)
}
