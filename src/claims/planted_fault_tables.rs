//! The table of planted faults: how many wrong equations the claims notice, and which they do not.

use crate::claims::{PlantedFaults, plant_faults};
use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::unless_empty;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "planted-faults", needs: &[], make: planted_faults }];

fn planted_faults(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("equation", "Eq"),
        Column::number("same", "Equivalent forms", ""),
        Column::number("planted", "Wrong versions", ""),
        Column::number("noticed", "Detected", ""),
        Column::number("rate_percent", "Detected share", "%"),
        Column::text("noticed_by", "First detected by"),
        Column::text("survivors", "Not detected"),
    ];
    let mut table = Table::new("planted-faults", "Deliberately wrong equations, and the claims that detect them", columns)
        .with_note("Each numbered equation with one sign reversed, one term doubled, one exponent or root changed, or a and b exchanged. Equivalent forms are not counted as wrong. For each wrong version, the code of the ledger decides the claims of linear theory again until a verdict changes; the version then counts as detected.");
    let found = plant_faults(context);
    for one in &found {
        let survivors: Vec<String> =
            one.survivors.iter().map(|survivor| format!("{}: {}", survivor.kind, survivor.text)).collect();
        table.push(row(
            &one.equation,
            [one.harmless, one.planted, one.noticed],
            &one.noticed_by.join(", "),
            &survivors.join("; "),
        ));
    }
    let sum = |count: fn(&PlantedFaults) -> usize| found.iter().map(count).sum::<usize>();
    let all = [sum(|one| one.harmless), sum(|one| one.planted), sum(|one| one.noticed)];
    table.push(row("all", all, "", ""));
    unless_empty(table)
}

fn row(
    equation: &str,
    [harmless, planted, noticed]: [usize; 3],
    noticed_by: &str,
    survivors: &str,
) -> Vec<Cell> {
    // Rounded down, so that 100 % means all of them.
    let rate = (1000 * noticed)
        .checked_div(planted)
        .map_or(String::new(), |rate| format!("{}.{}", rate / 10, rate % 10));
    vec![
        Cell::text(equation),
        Cell::number(harmless.to_string()),
        Cell::number(planted.to_string()),
        Cell::number(noticed.to_string()),
        Cell::number(rate),
        Cell::text(noticed_by),
        Cell::text(survivors),
    ]
}
