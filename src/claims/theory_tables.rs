//! Tables of the theory: the paper's equations as read, and the asymptotes' error series.

use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::unless_empty;
use slipmode_core::theory::asymptote_series;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "equations", needs: &[], make: equations },
    TableMaker { id: "series", needs: &[], make: series },
];

/// The order to which the error series are shown.
const SERIES_ORDER: usize = 3;

fn equations(context: &Context) -> Option<Table> {
    let columns =
        vec![Column::text("equation", "Eq"), Column::text("text", "As read"), Column::text("note", "Note")];
    let mut table = Table::new("equations", "The paper's equations, as read by the program", columns);
    for equation in context.equations.iter() {
        let text = format!("{} = {}", equation.left, equation.right);
        table.push(vec![Cell::text(&equation.number), Cell::text(text), Cell::text(&equation.note)]);
    }
    unless_empty(table)
}

fn series(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("asymptote", "Asymptote"),
        Column::text("quantity", "Relative error of"),
        Column::text("variable", "Small quantity x"),
        Column::text("first_order", "x¹"),
        Column::text("second_order", "x²"),
        Column::text("third_order", "x³"),
    ];
    let mut table = Table::new("series", "Relative error exact/asymptote − 1 as a series, derived from eq 8", columns)
        .with_note("Coefficients in w = √β for eqs 15 and 16, in β for eqs 18 and 20. Each series was derived along the rational curve and checked to make the discriminant vanish to the same order.");
    for series in asymptote_series::derive(context.equations, SERIES_ORDER).ok()? {
        let mut row = vec![
            Cell::text(format!("eq {}", series.equation)),
            Cell::text(series.quantity),
            Cell::text(series.variable),
        ];
        row.extend((1..=SERIES_ORDER).map(|order| {
            Cell::text(series.coefficients.get(order).map_or_else(String::new, ToString::to_string))
        }));
        table.push(row);
    }
    unless_empty(table)
}
