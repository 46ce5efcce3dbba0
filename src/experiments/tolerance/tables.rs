//! Tables of the asymptotes' errors: limits of use, and convergence.

use crate::experiments::shared::cells::ERROR_DIGITS;
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::number::Ball;
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::tolerance::Limit;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "tolerance", needs: &[Need::Tolerance], make: tolerance },
    TableMaker { id: "convergence", needs: &[Need::Tolerance], make: convergence },
    TableMaker { id: "worst-errors", needs: &[Need::Tolerance], make: worst_errors },
];

fn tolerance(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.tolerance);
    let rows = found.flat_map(|(name, found)| found.rows.iter().map(move |row| (name, row)));
    table_of("tolerance", rows)
        .text("scene", |(name, _)| name)
        .text("asymptote", |(_, row)| row.limit.asymptote.as_str())
        .digits("relative_error", 6, |(_, row)| &row.tolerance)
        .text("where", |(_, row)| place_of_limit(row.limit.asymptote, row.limit.whole_branch))
        .digits("limit", ERROR_DIGITS, |(_, row)| &row.in_si)
        .digits("group_at_limit", ERROR_DIGITS, |(_, row)| group(&row.limit))
        .digits("leading_order", ERROR_DIGITS, |(_, row)| &row.limit.leading)
        .digits("exact_over_leading", ERROR_DIGITS, |(_, row)| &row.limit.exact_over_leading)
        .table()
}

fn worst_errors(context: &Context) -> Option<Table> {
    let scenes = context.outcome.scenes.iter();
    let found = scenes.filter_map(|scene| Some((scene, &scene.tolerance.as_ref()?.corners)));
    table_of("worst-errors", found)
        .text("scene", |(scene, _)| scene.scene.name.as_str())
        .text("slider", |(scene, _)| scene.slider_words())
        .digits("quasi_static_upper", ERROR_DIGITS, |(_, corners)| {
            Some(&corners.upper.as_ref()?.quasi_static)
        })
        .digits("quasi_static_lower", ERROR_DIGITS, |(_, corners)| &corners.cusp.quasi_static)
        .digits("inertial_upper", ERROR_DIGITS, |(_, corners)| Some(&corners.upper.as_ref()?.inertial))
        .digits("inertial_lower", ERROR_DIGITS, |(_, corners)| &corners.cusp.inertial)
        .digits("inertial_lower_at_corner", ERROR_DIGITS, |(_, corners)| {
            &corners.lower_at_corner_normal_stress
        })
        .table()
}

/// On which side of its limit an asymptote is good: of V0 for eqs 15 and 16, of σ for eqs 18 and 20.
pub(crate) fn place_of_limit(asymptote: Asymptote, whole_branch: bool) -> &'static str {
    let above = asymptote == Asymptote::InertialUpper;
    match (asymptote.is_quasi_static(), whole_branch, above) {
        (true, true, _) => "V0 up to the cusp",
        (true, false, _) => "V0 below",
        (false, true, _) => "σ up to the cusp",
        (false, false, true) => "σ above",
        (false, false, false) => "σ below",
    }
}

fn convergence(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.tolerance);
    let series =
        found.flat_map(|(name, found)| found.convergence.iter().map(move |(of, steps)| (name, of, steps)));
    let rows = series.flat_map(|(name, of, steps)| steps.iter().map(move |step| (name, of, step)));
    table_of("convergence", rows)
        .text("scene", |(name, ..)| name)
        .text("asymptote", |(_, asymptote, _)| asymptote.as_str())
        .digits("leading", ERROR_DIGITS, |(.., step)| &step.leading)
        .digits("relative_error", ERROR_DIGITS, |(.., step)| &step.relative_error)
        .digits("ratio", ERROR_DIGITS, |(.., step)| &step.ratio)
        .digits("order", ERROR_DIGITS, |(.., step)| step.order.as_ref())
        .table()
}

/// The group that the limit bounds.
fn group(limit: &Limit) -> &Ball {
    let groups = &limit.groups;
    if limit.asymptote.is_quasi_static() { &groups.inertial_parameter } else { &groups.stiffness_group }
}
