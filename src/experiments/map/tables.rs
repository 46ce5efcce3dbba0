//! The table of precision levels.

use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::roots::PrecisionLevel;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "precision-levels", needs: &[Need::Map], make: precision_levels }];

fn precision_levels(context: &Context) -> Option<Table> {
    let rows = context.outcome.each(|scene| &scene.map).flat_map(|(name, map)| {
        [PrecisionLevel::F64, PrecisionLevel::DoubleDouble, PrecisionLevel::Exact]
            .map(|level| (name, map, level))
    });
    table_of("precision-levels", rows)
        .text("scene", |(name, ..)| name)
        .text("rung", |(.., level)| level.as_str())
        .number("points", |(_, map, level)| {
            map.values.iter().filter(|point| point.precision_level == level).count()
        })
        .table()
}
