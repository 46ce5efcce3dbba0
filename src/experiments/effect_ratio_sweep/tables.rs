//! The table of the asymptotes' largest row.errors.

use crate::experiments::shared::cells::ERROR_DIGITS;
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "corners", needs: &[Need::EffectRatioSweep], make: corners }];

fn corners(context: &Context) -> Option<Table> {
    let sweeps = context.outcome.each(|scene| &scene.effect_ratio_sweep);
    table_of("corners", sweeps.flat_map(|(_, rows)| rows))
        .digits("effect_ratio", 15, |row| &row.effect_ratio)
        .digits("upper_worst_log10", ERROR_DIGITS, |row| row.errors.upper_worst_log10.as_ref())
        .digits("upper_eq15_error", ERROR_DIGITS, |row| {
            row.errors.upper.as_ref().map(|pair| &pair.quasi_static)
        })
        .digits("upper_eq18_error", ERROR_DIGITS, |row| row.errors.upper.as_ref().map(|pair| &pair.inertial))
        .digits("lower_worst_log10", ERROR_DIGITS, |row| &row.errors.lower_worst_log10)
        .digits("cusp_eq16_error", ERROR_DIGITS, |row| &row.errors.cusp.quasi_static)
        .digits("cusp_eq20_error", ERROR_DIGITS, |row| &row.errors.cusp.inertial)
        .digits("lower_eq20_error_at_corner_normal_stress", ERROR_DIGITS, |row| {
            &row.errors.lower_at_corner_normal_stress
        })
        .table()
}
