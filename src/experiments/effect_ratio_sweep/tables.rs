//! The table of the asymptotes' largest errors.

use crate::experiments::shared::cells::{certain, certain_or_empty};
use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "corners", needs: &[Need::EffectRatioSweep], make: corners }];

fn corners(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("effect_ratio", "β = b/a", ""),
        Column::number("upper_worst_log10", "Upper arc: largest log10 distance", ""),
        Column::number("upper_eq15_error", "eq 15 at V0 of the corner", ""),
        Column::number("upper_eq18_error", "eq 18 at V0 of the corner", ""),
        Column::number("lower_worst_log10", "Lower arc: largest log10 distance", ""),
        Column::number("cusp_eq16_error", "eq 16 at the cusp", ""),
        Column::number("cusp_eq20_error", "eq 20 at the cusp", ""),
        Column::number("lower_eq20_error_at_corner_normal_stress", "eq 20 at σ of eq 16", ""),
    ];
    let mut table = Table::new("corners", "Largest errors of the asymptotes against b/a", columns)
        .with_note("Errors are exact/asymptote − 1, for σ at the same V0 (eqs 15 and 16) and for V0 at the same σ (eqs 18 and 20). Distances are to the nearer asymptote of the arc. All printed digits are certain.");
    for row in context
        .outcome
        .scenes
        .iter()
        .filter_map(|scene| scene.effect_ratio_sweep.as_ref())
        .flat_map(|sweep| &sweep.rows)
    {
        let errors = &row.errors;
        table.push(vec![
            Cell::number(rational_to_decimal(&row.effect_ratio, 15)),
            certain_or_empty(errors.upper_worst_log10.as_ref()),
            certain_or_empty(errors.upper.as_ref().map(|pair| &pair.quasi_static)),
            certain_or_empty(errors.upper.as_ref().map(|pair| &pair.inertial)),
            certain(&errors.lower_worst_log10),
            certain(&errors.cusp.quasi_static),
            certain(&errors.cusp.inertial),
            certain(&errors.lower_at_corner_normal_stress),
        ]);
    }
    unless_empty(table)
}
