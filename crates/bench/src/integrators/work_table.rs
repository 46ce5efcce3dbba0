//! The table of work against error.

use super::WorkCase;
use crate::digit_columns::DigitColumns;
use crate::paper::{place_cells, place_columns};
use slipmode_plot::table::Table;

/// A row for each method and setting.
#[must_use]
pub fn table(cases: &[WorkCase]) -> Table {
    let rows = cases.iter().flat_map(|case| case.points.iter().map(move |point| (case, point)));
    Table::of("work-precision", "Work against error on one period of the limit cycle, slip law", rows)
        .columns(place_columns(), |(case, _)| place_cells(&case.place))
        .text("method", "Method", |(_, point)| point.method)
        .digits("setting", "Local tolerance, or step / √(M/K)", "", 4, |(_, point)| point.setting)
        .number("steps", "Steps", "", |(_, point)| point.steps)
        .number("evaluations", "Evaluations", "", |(_, point)| point.evaluations)
        .digits("peak_error", "Error of ln(V_peak/V0)", "", 2, |(_, point)| point.peak_error)
        .table()
}
