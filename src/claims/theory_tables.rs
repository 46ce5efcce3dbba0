//! Tables of the theory: the paper's equations as read, the asymptotes' error series, and the constants of the peak velocity.

use crate::experiments::shared::cells::Digits;
use crate::experiments::{Context, TableMaker};
use slipmode_core::dynamics::PeakLaw;
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::{Cell, Column, Table};
use slipmode_theory::asymptote_series;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "equations", needs: &[], make: equations },
    TableMaker { id: "series", needs: &[], make: series },
    TableMaker { id: "peak-constants", needs: &[], make: peak_constants },
];

fn equations(context: &Context) -> Option<Table> {
    Table::of("equations", "The paper's equations, as read by the program", context.equations.iter())
        .text("equation", "Eq", |equation| &equation.number)
        .text("text", "As read", |equation| format!("{} = {}", equation.left, equation.right))
        .text("note", "Note", |equation| &equation.note)
        .table()
        .into()
}

fn series(context: &Context) -> Option<Table> {
    let note = "Coefficients in w = √β for {quasi-static-upper, quasi-static-lower}, in β for {inertial-upper, inertial-lower}. Each series was derived along the rational curve and checked to make the discriminant vanish to the same order.";
    let orders = [("first_order", "x¹"), ("second_order", "x²"), ("third_order", "x³")];
    let all = asymptote_series::derive(&context.equations.in_symbols(), orders.len()).ok()?;
    Table::of("series", "Relative error exact/asymptote − 1 as a series, derived from {characteristic}", &all)
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
        .table()
        .into()
}

/// b/a of the table of constants.
const EFFECT_RATIOS: [f64; 9] = [1.01, 1.1, 1.25, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0];

fn peak_constants(_: &Context) -> Option<Table> {
    let note = "Slip law: V_peak = 2 V_18 [ln(V_peak/V_l) + ln(1/κ) + c]. Aging law: the bracket also has s ln(V_peak/V_18), and c is in closed form. The error is the change of c when the step of its integration is doubled.";
    let rows = EFFECT_RATIOS
        .map(|beta| (beta, PeakLaw::new(EvolutionLaw::Slip, beta), PeakLaw::new(EvolutionLaw::Aging, beta)));
    Table::of("peak-constants", "Constants of the peak velocity in deep stick-slip", &rows)
        .note(note)
        .number("effect_ratio", "b/a", "", |(beta, ..)| beta.cell(4))
        .number("slip_constant", "c, slip law", "", |(_, slip, _)| slip.constant()[0].cell(7))
        .number("slip_error", "± of its integration", "", |(_, slip, _)| slip.constant()[1].cell(1))
        .number("aging_constant", "c, aging law", "", |(.., aging)| aging.constant()[0].cell(7))
        .number("aging_healing", "s, aging law", "", |(.., aging)| aging.healing().cell(7))
        .table()
        .into()
}
