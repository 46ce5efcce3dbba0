//! Tables of hard cases by family.

use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "hard-cases", needs: &[Need::HardCases], make: hard_cases }];

fn hard_cases(context: &Context) -> Option<Table> {
    let families = context.outcome.each(|scene| &scene.hard_cases).flat_map(|(_, families)| families);
    Table::of("hard-cases", "Hard cases compared with independent programs", families)
        .text("family", "Family", |found| &found.family)
        .number("points", "Points", "", |found| found.points)
        .number("wrong", "Wrong signs, classes or modes", "", |found| found.wrong)
        .digits("worst_real_error", "Largest error of max Re(s), relative to the root", "", 1, |found| {
            found.worst_real_error
        })
        .digits("worst_imaginary_error", "Largest relative error of max Im(s)", "", 1, |found| {
            found.worst_imaginary_error
        })
        .text("highest_rung", "Highest precision level", |found| found.highest_precision_level.as_str())
        .unless_empty()
}
