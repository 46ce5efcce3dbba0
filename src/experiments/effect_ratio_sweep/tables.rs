//! The table of the asymptotes' largest row.errors.

use crate::experiments::shared::cells::{certain, decimal};
use crate::experiments::{Context, Need, TableMaker};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "corners", needs: &[Need::EffectRatioSweep], make: corners }];

fn corners(context: &Context) -> Option<Table> {
    let note = "Errors are exact/asymptote − 1, for σ at the same V0 (eqs 15 and 16) and for V0 at the same σ (eqs 18 and 20). Distances are to the nearer asymptote of the arc. All printed digits are certain.";
    let sweeps = context.outcome.each(|scene| &scene.effect_ratio_sweep);
    Table::of(
        "corners",
        "Largest errors of the asymptotes against b/a",
        sweeps.flat_map(|(_, sweep)| &sweep.rows),
    )
    .note(note)
    .number("effect_ratio", "β = b/a", "", |row| decimal(&row.effect_ratio, 15))
    .number("upper_worst_log10", "Upper arc: largest log10 distance", "", |row| {
        certain(row.errors.upper_worst_log10.as_ref())
    })
    .number("upper_eq15_error", "eq 15 at V0 of the corner", "", |row| {
        certain(row.errors.upper.as_ref().map(|pair| &pair.quasi_static))
    })
    .number("upper_eq18_error", "eq 18 at V0 of the corner", "", |row| {
        certain(row.errors.upper.as_ref().map(|pair| &pair.inertial))
    })
    .number("lower_worst_log10", "Lower arc: largest log10 distance", "", |row| {
        certain(&row.errors.lower_worst_log10)
    })
    .number("cusp_eq16_error", "eq 16 at the cusp", "", |row| certain(&row.errors.cusp.quasi_static))
    .number("cusp_eq20_error", "eq 20 at the cusp", "", |row| certain(&row.errors.cusp.inertial))
    .number("lower_eq20_error_at_corner_normal_stress", "eq 20 at σ of eq 16", "", |row| {
        certain(&row.errors.lower_at_corner_normal_stress)
    })
    .unless_empty()
}
