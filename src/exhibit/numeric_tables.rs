//! Tables of how the numbers came about: rungs, and hard cases.

use crate::claims::Context;
use crate::exhibit::TableMaker;
use crate::exhibit::tables::unless_empty;
use crate::number::format::round_digits;
use crate::roots::Rung;
use crate::study::Need;
use crate::table::{Cell, Column, Table};

pub(super) const TABLES: &[TableMaker] = &[
    TableMaker { id: "rungs", needs: &[Need::Map], make: rungs },
    TableMaker { id: "hard-cases", needs: &[Need::HardCases], make: hard_cases },
];

fn rungs(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("rung", "Rung"),
        Column::number("points", "Points decided", ""),
    ];
    let mut table = Table::new("rungs", "Which rung answered on the maps", columns);
    for scene in &context.outcome.scenes {
        let Some(map) = &scene.map else { continue };
        for rung in [Rung::F64, Rung::DoubleDouble, Rung::Exact] {
            let points = map.values.iter().filter(|point| point.rung == rung).count();
            table.push(vec![
                Cell::text(&scene.scene.name),
                Cell::text(rung.as_str()),
                Cell::number(points.to_string()),
            ]);
        }
    }
    unless_empty(table)
}

fn hard_cases(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("family", "Family"),
        Column::number("points", "Points", ""),
        Column::number("wrong", "Wrong signs, classes or modes", ""),
        Column::number("worst_real_error", "Worst error of max Re(s), relative to the root", ""),
        Column::number("worst_imaginary_error", "Worst relative error of max Im(s)", ""),
        Column::text("highest_rung", "Highest rung"),
    ];
    let mut table = Table::new("hard-cases", "Hard cases against independent programs", columns);
    for family in context.outcome.scenes.iter().filter_map(|scene| scene.hard_cases.as_ref()).flatten() {
        table.push(vec![
            Cell::text(&family.family),
            Cell::number(family.points.to_string()),
            Cell::number(family.wrong.to_string()),
            Cell::number(round_digits(family.worst_real_error, 1)),
            Cell::number(round_digits(family.worst_imaginary_error, 1)),
            Cell::text(family.highest_rung.as_str()),
        ]);
    }
    unless_empty(table)
}
