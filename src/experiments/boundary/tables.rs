//! Tables of the boundary: its points, its marks, and the agreement of the routes.

use crate::experiments::boundary::LinePoint;
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::number::format::round_float;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::table::{Cell, Table};

const NEEDS: &[Need] = &[Need::Boundary];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "boundary", needs: NEEDS, make: |of| point_table(of, "boundary", |_| true) },
    TableMaker { id: "marks", needs: NEEDS, make: |of| point_table(of, "marks", |at| at.mark.is_some()) },
    TableMaker { id: "routes", needs: NEEDS, make: routes },
];

/// Digits shown of a coordinate in a report; `slipmode boundary --digits` prints as many as requested.
const SHOWN_DIGITS: usize = 20;

fn point_table(context: &Context, id: &str, wanted: fn(&BoundaryPoint) -> bool) -> Option<Table> {
    let boundaries = context.outcome.each(|scene| &scene.boundary);
    let points = boundaries.flat_map(|(name, found)| found.points.iter().map(move |point| (name, point)));
    table_of(id, points.filter(|(_, point)| wanted(point)))
        .text("scene", |(name, _)| name)
        .columns(BoundaryPoint::columns(), |(_, point)| point.row(SHOWN_DIGITS))
        .table()
}

fn routes(context: &Context) -> Option<Table> {
    table_of("routes", context.outcome.each(|scene| &scene.boundary))
        .text("scene", |(name, _)| name)
        .number("compared", |(_, found)| found.comparison.compared)
        .number("disagreements", |(_, found)| found.comparison.disagreements.len())
        .number("digits", |(_, found)| found.digits)
        .number("largest_relative_difference", |(_, found)| {
            Cell::number(round_float(&found.comparison.largest_difference, 2))
        })
        .table()
}
