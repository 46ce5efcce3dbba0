//! Tables of the theory: the paper's equations as read, and the asymptotes' error series.

use crate::experiments::{Context, TableMaker};
use slipmode_core::theory::asymptote_series;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "equations", needs: &[], make: equations },
    TableMaker { id: "series", needs: &[], make: series },
];

fn equations(context: &Context) -> Option<Table> {
    Table::of("equations", "The paper's equations, as read by the program", context.equations.iter())
        .text("equation", "Eq", |equation| &equation.number)
        .text("text", "As read", |equation| format!("{} = {}", equation.left, equation.right))
        .text("note", "Note", |equation| &equation.note)
        .unless_empty()
}

fn series(context: &Context) -> Option<Table> {
    let note = "Coefficients in w = √β for eqs 15 and 16, in β for eqs 18 and 20. Each series was derived along the rational curve and checked to make the discriminant vanish to the same order.";
    let orders = [("first_order", "x¹"), ("second_order", "x²"), ("third_order", "x³")];
    let all = asymptote_series::derive(context.equations, orders.len()).ok()?;
    Table::of("series", "Relative error exact/asymptote − 1 as a series, derived from eq 8", &all)
        .note(note)
        .text("asymptote", "Asymptote", |series| format!("eq {}", series.equation))
        .text("quantity", "Relative error of", |series| series.quantity)
        .text("variable", "Small quantity x", |series| series.variable)
        .columns(orders.map(|(name, header)| Column::text(name, header)), |series| {
            let coefficient = |order| series.coefficients.get(order);
            (1..=orders.len()).map(move |order| {
                Cell::text(coefficient(order).map_or_else(String::new, ToString::to_string))
            })
        })
        .unless_empty()
}
