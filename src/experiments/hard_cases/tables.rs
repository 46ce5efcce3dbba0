//! Tables of hard cases by family and by method.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::hard_cases::{FamilyOutcome, Method, MethodScore};
use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::unless_empty;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "hard-cases", needs: &[Need::HardCases], make: hard_cases },
    TableMaker { id: "method-verdicts", needs: &[Need::HardCases], make: method_verdicts },
    TableMaker { id: "method-errors", needs: &[Need::HardCases], make: method_errors },
];

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

/// A row per family, a column per method.
fn by_method(context: &Context, mut table: Table, cell: impl Fn(&MethodScore) -> String) -> Option<Table> {
    for family in families(context) {
        let mut row = vec![Cell::text(&family.family), count(family.points)];
        row.extend(family.methods.iter().map(|score| Cell::text(cell(score))));
        table.push(row);
    }
    unless_empty(table)
}

fn method_columns() -> Vec<Column> {
    let name = |method: Method| {
        method.as_str().replace([' ', '-'], "_").replace("64_bit", "binary64").to_lowercase()
    };
    let mut columns = vec![Column::text("family", "Family"), Column::number("points", "Points", "")];
    columns.extend(Method::ALL.map(|method| Column::text(&name(method), method.as_str())));
    columns
}

fn method_verdicts(context: &Context) -> Option<Table> {
    let title = "Wrong signs or classes by method; points without a finite answer, and undecided points";
    let table = Table::new("method-verdicts", title, method_columns());
    by_method(context, table, |score| {
        let parts = [(score.wrong, "wrong"), (score.failed, "failed"), (score.open, "open")];
        let said =
            parts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}"));
        let said = said.collect::<Vec<_>>().join(", ");
        if said.is_empty() { "all right".to_owned() } else { said }
    })
}

fn method_errors(context: &Context) -> Option<Table> {
    let title = "Largest error of max Re(s) / of max Im(s) by method, in 2^-52 of the root and of Im(s), for points with an answer";
    let table = Table::new("method-errors", title, method_columns());
    by_method(context, table, |score| {
        let [real, imaginary] =
            [score.worst_real_ulps, score.worst_imaginary_ulps].map(|ulps| round_digits(ulps, 1));
        format!("{real} / {imaginary}")
    })
}
