//! Tables of hard cases by method.

use super::{FamilyScores, Method, MethodScore};
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

/// The two tables.
#[must_use]
pub fn tables(families: &[FamilyScores]) -> Vec<Table> {
    vec![verdicts(families), errors(families)]
}

/// A row per family, a column per method.
fn by_method(id: &str, title: &str, families: &[FamilyScores], cell: fn(&MethodScore) -> String) -> Table {
    let name = |method: Method| {
        method.as_str().replace([' ', '-'], "_").replace("64_bit", "binary64").to_lowercase()
    };
    let mut columns = vec![Column::text("family", "Family"), Column::number("points", "Points", "")];
    columns.extend(Method::ALL.map(|method| Column::text(&name(method), method.as_str())));
    let mut table = Table::new(id, title, columns);
    for family in families {
        let mut row = vec![Cell::text(&family.family), Cell::number(family.points.to_string())];
        row.extend(family.methods.iter().map(|score| Cell::text(cell(score))));
        table.push(row);
    }
    table
}

fn verdicts(families: &[FamilyScores]) -> Table {
    let title = "Wrong signs or classes by method; points without a finite answer, and undecided points";
    by_method("method-verdicts", title, families, |score| {
        let parts = [(score.wrong, "wrong"), (score.failed, "failed"), (score.open, "open")];
        let said =
            parts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}"));
        let said = said.collect::<Vec<_>>().join(", ");
        if said.is_empty() { "all right".to_owned() } else { said }
    })
}

fn errors(families: &[FamilyScores]) -> Table {
    let title = "Largest error of max Re(s) / of max Im(s) by method, in 2^-52 of the root and of Im(s), for points with an answer";
    by_method("method-errors", title, families, |score| {
        let [real, imaginary] =
            [score.worst_real_ulps, score.worst_imaginary_ulps].map(|ulps| round_digits(ulps, 1));
        format!("{real} / {imaginary}")
    })
}
