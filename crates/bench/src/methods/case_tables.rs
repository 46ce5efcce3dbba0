//! The table of hard cases by family.

use super::FamilyOutcome;
use crate::digit_columns::DigitColumns;
use slipmode_plot::table::Table;

/// The table.
#[must_use]
pub fn case_table(families: &[FamilyOutcome]) -> Table {
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
        .table()
}
