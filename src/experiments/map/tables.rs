//! The table of precision levels.

use crate::experiments::shared::cells::count;
use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_core::roots::PrecisionLevel;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "precision-levels", needs: &[Need::Map], make: precision_levels }];

fn precision_levels(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("rung", "Precision level"),
        Column::number("points", "Points decided", ""),
    ];
    let mut table =
        Table::new("precision-levels", "Precision level that decided the points of the maps", columns);
    for scene in &context.outcome.scenes {
        let Some(map) = &scene.map else { continue };
        for precision_level in [PrecisionLevel::F64, PrecisionLevel::DoubleDouble, PrecisionLevel::Exact] {
            let points = map.values.iter().filter(|point| point.precision_level == precision_level).count();
            table.push(vec![
                Cell::text(&scene.scene.name),
                Cell::text(precision_level.as_str()),
                count(points),
            ]);
        }
    }
    unless_empty(table)
}
