//! Tables of hard cases by family.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::hard_cases::FamilyOutcome;
use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::unless_empty;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "hard-cases", needs: &[Need::HardCases], make: hard_cases }];

fn hard_cases(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("family", "Family"),
        Column::number("points", "Points", ""),
        Column::number("wrong", "Wrong signs, classes or modes", ""),
        Column::number("worst_real_error", "Largest error of max Re(s), relative to the root", ""),
        Column::number("worst_imaginary_error", "Largest relative error of max Im(s)", ""),
        Column::text("highest_rung", "Highest precision level"),
    ];
    let mut table = Table::new("hard-cases", "Hard cases compared with independent programs", columns);
    for family in families(context) {
        table.push(vec![
            Cell::text(&family.family),
            count(family.points),
            count(family.wrong),
            rounded(family.worst_real_error, 1),
            rounded(family.worst_imaginary_error, 1),
            Cell::text(family.highest_precision_level.as_str()),
        ]);
    }
    unless_empty(table)
}

fn families<'c>(context: &'c Context<'_>) -> impl Iterator<Item = &'c FamilyOutcome> {
    context
        .outcome
        .scenes
        .iter()
        .filter_map(|scene| scene.hard_cases.as_ref())
        .flat_map(|found| &found.families)
}
