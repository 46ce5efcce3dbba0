//! The table of work against error.

use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "work-precision", needs: &[Need::WorkPrecision], make: work }];

fn work(context: &Context) -> Option<Table> {
    let cases = context.outcome.each(|scene| &scene.work_precision).flat_map(|(_, cases)| cases);
    let rows = cases.flat_map(|case| case.points.iter().map(move |point| (case, point)));
    Table::of("work-precision", "Work against error on one period of the limit cycle, slip law", rows)
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(case, _)| {
            nearest_f64(&case.place.normal_stress_pa)
        })
        .digits("loading_velocity_m_per_s", "Loading velocity V0", "m/s", 4, |(case, _)| {
            nearest_f64(&case.place.loading_velocity_m_per_s)
        })
        .text("method", "Method", |(_, point)| point.method)
        .digits("setting", "Local tolerance, or step / √(M/K)", "", 4, |(_, point)| point.setting)
        .number("steps", "Steps", "", |(_, point)| point.steps)
        .number("evaluations", "Evaluations", "", |(_, point)| point.evaluations)
        .digits("peak_error", "Error of ln(V_peak/V0)", "", 2, |(_, point)| point.peak_error)
        .unless_empty()
}
