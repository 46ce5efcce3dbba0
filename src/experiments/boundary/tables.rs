//! Tables of the boundary: its points, its marks, and the agreement of the routes.

use rug::Float;

use crate::experiments::tables::table_of;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_float};
use slipmode_core::stability::PairLinePoint;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "boundary", needs: &[Need::Boundary], make: all_points },
    TableMaker { id: "marks", needs: &[Need::Boundary], make: marked_points },
    TableMaker { id: "routes", needs: &[Need::Boundary], make: routes },
];

/// Digits shown of a coordinate in a report; `slipmode boundary --digits` prints as many as requested.
const SHOWN_DIGITS: usize = 20;

/// The columns of the boundary's table, the same on the command line and in reports.
#[must_use]
pub fn boundary_columns() -> Vec<Column> {
    vec![
        Column::text("arc", "Arc"),
        Column::number("double_root", "Double root r", ""),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::text("asymptote", "Nearest asymptote"),
        Column::number("asymptote_value", "Its value", "Pa or m/s"),
        Column::number("relative_error", "exact/asymptote − 1", ""),
        Column::number("log10_distance", "log10 distance", ""),
        Column::number("condition_number", "Condition number", ""),
        Column::text("mark", "Mark"),
    ]
}

/// One row of the boundary's table, with at most `digits` certain digits of each number.
#[must_use]
pub fn boundary_row(point: &BoundaryPoint, digits: usize) -> Vec<Cell> {
    let number = |ball| Cell::number(certain_digits(ball, digits));
    let short = |ball| of_order_one(ball, digits);
    vec![
        Cell::text(point.arc.as_str()),
        number(&point.double_root),
        number(&point.normal_stress_pa),
        number(&point.loading_velocity_m_per_s),
        Cell::text(point.asymptote.as_str()),
        number(&point.asymptote_value),
        short(&point.relative_error),
        short(&point.log10_distance),
        short(&point.condition_number),
        Cell::text(point.mark.map_or("", |mark| mark.as_str())),
    ]
}

/// The columns of a line of given ω/ω_n or damping ratio.
#[must_use]
pub fn pair_line_columns() -> Vec<Column> {
    vec![
        Column::number("transition_sign", "Sign of K − K_c", ""),
        Column::number("real_part", "Re(s) in V0/D_c", ""),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::text("asymptote", "Nearest asymptote"),
        Column::number("asymptote_value", "Its value", "m/s or Pa"),
        Column::number("relative_error", "exact/asymptote − 1", ""),
        Column::number("log10_distance", "log10 distance", ""),
    ]
}

/// One row of such a line, with at most `digits` certain digits of each number.
#[must_use]
pub fn pair_line_row(point: &PairLinePoint, digits: usize) -> Vec<Cell> {
    vec![
        Cell::number(point.transition_sign.to_string()),
        of_order_one(&point.real_part, digits),
        Cell::number(certain_digits(&point.normal_stress_pa, digits)),
        Cell::number(certain_digits(&point.loading_velocity_m_per_s, digits)),
        Cell::text(point.asymptote.as_str()),
        Cell::number(certain_digits(&point.asymptote_value, digits)),
        of_order_one(&point.relative_error, digits),
        of_order_one(&point.log10_distance, digits),
    ]
}

/// The certain digits of a number; 0 where it is zero to all of them.
fn of_order_one(ball: &Ball, digits: usize) -> Cell {
    match vanishes(ball, digits) {
        true => Cell::number("0"),
        false => Cell::number(certain_digits(ball, digits)),
    }
}

/// Whether a number of order one is zero to all digits: where the asymptote meets the boundary, the enclosure of its error
/// is tiny and around zero.
#[must_use]
pub fn vanishes(ball: &Ball, digits: usize) -> bool {
    let decimals = -(digits as f64) * std::f64::consts::LOG2_10;
    let is_tiny = |radius: &Float| radius.get_exp().is_some_and(|exponent| f64::from(exponent) < decimals);
    ball.contains_zero() && (ball.is_exact() || is_tiny(&ball.radius()))
}

fn point_table(context: &Context, id: &str, wanted: fn(&BoundaryPoint) -> bool) -> Option<Table> {
    let boundaries = context.outcome.each(|scene| &scene.boundary);
    let points = boundaries.flat_map(|(name, found)| found.points.iter().map(move |point| (name, point)));
    table_of(id, points.filter(|(_, point)| wanted(point)))
        .text("scene", |(name, _)| name)
        .columns(boundary_columns(), |(_, point)| boundary_row(point, SHOWN_DIGITS))
        .table()
}

fn all_points(context: &Context) -> Option<Table> {
    point_table(context, "boundary", |_| true)
}

fn marked_points(context: &Context) -> Option<Table> {
    point_table(context, "marks", |point| point.mark.is_some())
}

fn routes(context: &Context) -> Option<Table> {
    table_of("routes", context.outcome.each(|scene| &scene.boundary))
        .text("scene", |(name, _)| name)
        .number("compared", |(_, found)| found.comparison.compared)
        .number("disagreements", |(_, found)| found.comparison.disagreements.len())
        .number("digits", |(_, found)| found.digits)
        .number("largest_relative_difference", |(_, found)| {
            Cell::number(round_float(&found.comparison.largest_difference, 2))
        })
        .table()
}
