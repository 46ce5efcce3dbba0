//! Tables of the asymptotes' errors: limits of use, worst cases, convergence.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::unless_empty;
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, rational_to_decimal};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::tolerance::Limit;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "tolerance", needs: &[Need::Tolerance], make: tolerance },
    TableMaker { id: "convergence", needs: &[Need::Tolerance], make: convergence },
    TableMaker { id: "corners", needs: &[Need::EffectRatioSweep], make: corners },
];

/// Digits of an error: enough to compare, few enough to read.
const ERROR_DIGITS: usize = 6;

fn number(ball: &Ball) -> Cell {
    Cell::number(certain_digits(ball, ERROR_DIGITS))
}

fn optional(ball: Option<&Ball>) -> Cell {
    ball.map_or_else(Cell::empty, number)
}

fn tolerance(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("asymptote", "Asymptote"),
        Column::number("relative_error", "Relative error", ""),
        Column::text("where", "Where"),
        Column::number("limit", "Limit", "m/s or Pa"),
        Column::number("group_at_limit", "η or κ at the limit", ""),
        Column::number("leading_order", "Leading order", ""),
        Column::number("exact_over_leading", "exact/leading", ""),
    ];
    let mut table = Table::new("tolerance", "Which formula may be used where", columns)
        .with_note("Leading order in closed form, for a relative error ε: η = ε for eqs 15 and 16, κ = ε(β−1)²/(2β) for eq 18, κ = β/(2ε) for eq 20. A branch that is accurate up to the cusp has the values of the cusp.");
    for scene in &context.outcome.scenes {
        let Some(outcome) = &scene.tolerance else { continue };
        for row in &outcome.rows {
            let limit = &row.limit;
            let quasi_static = limit.asymptote.is_quasi_static();
            let group =
                if quasi_static { &limit.groups.inertial_parameter } else { &limit.groups.stiffness_group };
            table.push(vec![
                Cell::text(&scene.scene.name),
                Cell::text(limit.asymptote.as_str()),
                Cell::number(rational_to_decimal(&row.tolerance, 6)),
                Cell::text(place_of_limit(limit)),
                number(&row.in_si),
                number(group),
                Cell::number(rational_to_decimal(&limit.leading, ERROR_DIGITS)),
                number(&limit.exact_over_leading),
            ]);
        }
    }
    unless_empty(table)
}

/// On which side of its limit an asymptote is good: of V0 for eqs 15 and 16, of σ for eqs 18 and 20.
#[must_use]
pub fn place_of_limit(limit: &Limit) -> &'static str {
    let above = limit.asymptote == Asymptote::InertialUpper;
    match (limit.asymptote.is_quasi_static(), limit.whole_branch, above) {
        (true, true, _) => "V0 up to the cusp",
        (true, false, _) => "V0 below",
        (false, true, _) => "σ up to the cusp",
        (false, false, true) => "σ above",
        (false, false, false) => "σ below",
    }
}

fn convergence(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("asymptote", "Asymptote"),
        Column::number("leading", "Derived leading term", ""),
        Column::number("relative_error", "Relative error", ""),
        Column::number("ratio", "error/leading", ""),
        Column::number("order", "Measured order (derived: 1)", ""),
    ];
    let mut table = Table::new("convergence", "Measured and derived order of convergence", columns);
    for scene in &context.outcome.scenes {
        let Some(outcome) = &scene.tolerance else { continue };
        for (asymptote, steps) in &outcome.convergence {
            for step in steps {
                table.push(vec![
                    Cell::text(&scene.scene.name),
                    Cell::text(asymptote.as_str()),
                    number(&step.leading),
                    number(&step.relative_error),
                    number(&step.ratio),
                    optional(step.order.as_ref()),
                ]);
            }
        }
    }
    unless_empty(table)
}

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
            optional(errors.upper_worst_log10.as_ref()),
            optional(errors.upper.as_ref().map(|pair| &pair.quasi_static)),
            optional(errors.upper.as_ref().map(|pair| &pair.inertial)),
            number(&errors.lower_worst_log10),
            number(&errors.cusp.quasi_static),
            number(&errors.cusp.inertial),
            number(&errors.lower_at_corner_normal_stress),
        ]);
    }
    unless_empty(table)
}
