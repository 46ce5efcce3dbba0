//! Tables of the asymptotes' errors: limits of use, and convergence.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::{ERROR_DIGITS, certain, certain_or_empty};
use crate::experiments::unless_empty;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::tolerance::Limit;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "tolerance", needs: &[Need::Tolerance], make: tolerance },
    TableMaker { id: "convergence", needs: &[Need::Tolerance], make: convergence },
];

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
                certain(&row.in_si),
                certain(group),
                Cell::number(rational_to_decimal(&limit.leading, ERROR_DIGITS)),
                certain(&limit.exact_over_leading),
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
                    certain(&step.leading),
                    certain(&step.relative_error),
                    certain(&step.ratio),
                    certain_or_empty(step.order.as_ref()),
                ]);
            }
        }
    }
    unless_empty(table)
}
