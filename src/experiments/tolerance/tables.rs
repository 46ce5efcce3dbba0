//! Tables of the asymptotes' errors: limits of use, and convergence.

use crate::experiments::shared::cells::{DigitColumns, ERROR_DIGITS};
use crate::experiments::{Context, Need, TableMaker};
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
    let note = "Leading order in closed form, for a relative error ε: η = ε for {quasi-static-upper, quasi-static-lower}, κ = ε(β−1)²/(2β) for {inertial-upper}, κ = β/(2ε) for {inertial-lower}. A branch that is accurate up to the cusp has the values of the cusp.";
    let found = context.outcome.each(|scene| &scene.tolerance);
    let rows = found.flat_map(|(name, found)| found.rows.iter().map(move |row| (name, row)));
    Table::of("tolerance", "Which formula may be used where", rows)
        .note(note)
        .text("scene", "Scene", |(name, _)| name)
        .text("asymptote", "Asymptote", |(_, row)| row.limit.asymptote.as_str())
        .digits("relative_error", "Relative error", "", 6, |(_, row)| &row.tolerance)
        .text("where", "Where", |(_, row)| place_of_limit(row.limit.asymptote, row.limit.whole_branch))
        .digits("limit", "Limit", "m/s or Pa", ERROR_DIGITS, |(_, row)| &row.in_si)
        .digits("group_at_limit", "η or κ at the limit", "", ERROR_DIGITS, |(_, row)| group(&row.limit))
        .digits("leading_order", "Leading order", "", ERROR_DIGITS, |(_, row)| &row.limit.leading)
        .digits("exact_over_leading", "exact/leading", "", ERROR_DIGITS, |(_, row)| {
            &row.limit.exact_over_leading
        })
        .table()
        .into()
}

fn worst_errors(context: &Context) -> Option<Table> {
    let note = "exact/asymptote − 1, of σ at the same V0 ({quasi-static-upper, quasi-static-lower}) and of V0 at the same σ ({inertial-upper, inertial-lower}): of the upper two at the V0 of their corner, of the lower two at the cusp, and of {inertial-lower} at the σ of its corner with {quasi-static-lower}.";
    let scenes = context.outcome.scenes.iter();
    let found = scenes.filter_map(|scene| Some((scene, &scene.tolerance.as_ref()?.corners)));
    Table::of("worst-errors", "Largest errors of the asymptotes on their arcs", found)
        .note(note)
        .text("scene", "Scene", |(scene, _)| scene.scene.name.as_str())
        .text("slider", "Slider", |(scene, _)| scene.slider_words())
        .digits("quasi_static_upper", "{quasi-static-upper}", "", ERROR_DIGITS, |(_, corners)| {
            Some(&corners.upper.as_ref()?.quasi_static)
        })
        .digits("quasi_static_lower", "{quasi-static-lower}", "", ERROR_DIGITS, |(_, corners)| {
            &corners.cusp.quasi_static
        })
        .digits("inertial_upper", "{inertial-upper}", "", ERROR_DIGITS, |(_, corners)| {
            Some(&corners.upper.as_ref()?.inertial)
        })
        .digits("inertial_lower", "{inertial-lower}", "", ERROR_DIGITS, |(_, corners)| &corners.cusp.inertial)
        .digits("inertial_lower_at_corner", "at the corner", "", ERROR_DIGITS, |(_, corners)| {
            &corners.lower_at_corner_normal_stress
        })
        .table()
        .into()
}

/// On which side of its limit an asymptote is good: of V0 for eqs 15 and 16, of σ for eqs 18 and 20.
#[must_use]
pub fn place_of_limit(asymptote: Asymptote, whole_branch: bool) -> &'static str {
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
    Table::of("convergence", "Measured and derived order of convergence", rows)
        .text("scene", "Scene", |(name, ..)| name)
        .text("asymptote", "Asymptote", |(_, asymptote, _)| asymptote.as_str())
        .digits("leading", "Derived leading term", "", ERROR_DIGITS, |(.., step)| &step.leading)
        .digits("relative_error", "Relative error", "", ERROR_DIGITS, |(.., step)| &step.relative_error)
        .digits("ratio", "error/leading", "", ERROR_DIGITS, |(.., step)| &step.ratio)
        .digits("order", "Measured order (derived: 1)", "", ERROR_DIGITS, |(.., step)| step.order.as_ref())
        .table()
        .into()
}

/// The group that the limit bounds.
fn group(limit: &Limit) -> &Ball {
    let groups = &limit.groups;
    if limit.asymptote.is_quasi_static() { &groups.inertial_parameter } else { &groups.stiffness_group }
}
