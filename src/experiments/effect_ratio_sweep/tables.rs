//! The table of the asymptotes' largest row.errors.

use crate::experiments::shared::cells::{DigitColumns, ERROR_DIGITS};
use crate::experiments::{Context, Need, TableMaker};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "corners", needs: &[Need::EffectRatioSweep], make: corners }];

fn corners(context: &Context) -> Option<Table> {
    let note = "Errors are exact/asymptote − 1, for σ at the same V0 ({quasi-static-upper, quasi-static-lower}) and for V0 at the same σ ({inertial-upper, inertial-lower}). Distances are to the nearer asymptote of the arc. All printed digits are certain.";
    let sweeps = context.outcome.each(|scene| &scene.effect_ratio_sweep);
    Table::of(
        "corners",
        "Largest errors of the asymptotes against b/a",
        sweeps.flat_map(|(_, sweep)| &sweep.rows),
    )
    .note(note)
    .digits("effect_ratio", "β = b/a", "", 15, |row| &row.effect_ratio)
    .digits("upper_worst_log10", "Upper arc: largest log10 distance", "", ERROR_DIGITS, |row| {
        row.errors.upper_worst_log10.as_ref()
    })
    .digits("upper_eq15_error", "{quasi-static-upper} at V0 of the corner", "", ERROR_DIGITS, |row| {
        row.errors.upper.as_ref().map(|pair| &pair.quasi_static)
    })
    .digits("upper_eq18_error", "{inertial-upper} at V0 of the corner", "", ERROR_DIGITS, |row| {
        row.errors.upper.as_ref().map(|pair| &pair.inertial)
    })
    .digits("lower_worst_log10", "Lower arc: largest log10 distance", "", ERROR_DIGITS, |row| {
        &row.errors.lower_worst_log10
    })
    .digits("cusp_eq16_error", "{quasi-static-lower} at the cusp", "", ERROR_DIGITS, |row| {
        &row.errors.cusp.quasi_static
    })
    .digits("cusp_eq20_error", "{inertial-lower} at the cusp", "", ERROR_DIGITS, |row| {
        &row.errors.cusp.inertial
    })
    .digits(
        "lower_eq20_error_at_corner_normal_stress",
        "{inertial-lower} at σ of {quasi-static-lower}",
        "",
        ERROR_DIGITS,
        |row| &row.errors.lower_at_corner_normal_stress,
    )
    .table()
    .into()
}
