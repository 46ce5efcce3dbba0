//! The table of planted faults: how many wrong equations the claims notice, and which they do not.

use crate::claims::{PlantedFaults, Survivor, plant_faults};
use crate::experiments::{Context, TableMaker};
use slipmode_plot::table::{Cell, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "planted-faults", needs: &[], make: planted_faults }];

fn planted_faults(context: &Context) -> Option<Table> {
    let note = "Each equation with one sign reversed, one term doubled, one exponent or root changed, or two variables exchanged that some equation adds or subtracts, such as a and b. Equivalent forms are not counted as wrong. For each wrong version, the claims about the equations are decided again until a verdict changes; the version then counts as detected.";
    let found = plant_faults(context);
    let sum = |count: fn(&PlantedFaults) -> usize| found.iter().map(count).sum::<usize>();
    let all = PlantedFaults {
        equation: "all".into(),
        planted: sum(|one| one.planted),
        noticed: sum(|one| one.noticed),
        harmless: sum(|one| one.harmless),
        ..PlantedFaults::default()
    };
    Table::of(
        "planted-faults",
        "Deliberately wrong equations, and the claims that detect them",
        [&all].into_iter().chain(&found),
    )
    .note(note)
    .text("equation", "Eq", |one| &one.equation)
    .number("same", "Equivalent forms", "", |one| one.harmless)
    .number("planted", "Wrong versions", "", |one| one.planted)
    .number("noticed", "Detected", "", |one| one.noticed)
    .number("rate_percent", "Detected share", "%", rate_percent)
    .text("noticed_by", "First detected by", |one| one.noticed_by.join(", "))
    .text("survivors", "Not detected", |one| {
        let survivor = |survivor: &Survivor| format!("{}: {}", survivor.kind, survivor.text);
        one.survivors.iter().map(survivor).collect::<Vec<_>>().join("; ")
    })
    .table()
    .into()
}

/// Rounded down, so that 100 % means all of them.
fn rate_percent(one: &PlantedFaults) -> Cell {
    let rate = (1000 * one.noticed).checked_div(one.planted);
    Cell::number(rate.map_or(String::new(), |rate| format!("{}.{}", rate / 10, rate % 10)))
}
