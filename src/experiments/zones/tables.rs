//! Tables of slip modes.

use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::unless_empty;
use crate::experiments::zones::ZonesOutcome;
use crate::experiments::{Need, SceneOutcome};
use slipmode_core::stability::SlipMode;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "zones", needs: &[Need::Map, Need::Zones], make: zones },
    TableMaker { id: "thresholds", needs: &[Need::Map, Need::Zones], make: thresholds },
];

fn zoned(context: &Context) -> impl Iterator<Item = (SceneOutcome, ZonesOutcome)> {
    context.outcome.scenes.iter().filter_map(|scene| Some((scene.clone(), scene.zones.clone()?)))
}

fn zones(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("slip_mode", "Slip mode"),
        Column::number("points_exact", "Points, exact", ""),
        Column::number("points_simplified", "Points, simplified map", ""),
        Column::number("areas", "Connected areas, exact", ""),
    ];
    let mut table = Table::new("zones", "Slip modes: exact, and by the lines of fig 7", columns);
    for (scene, zones) in zoned(context) {
        for mode in SlipMode::ALL {
            let points = |values: &[SlipMode]| values.iter().filter(|value| **value == mode).count();
            let (exact, simplified) = (points(&zones.exact.values), points(&zones.simplified.values));
            if exact + simplified > 0 {
                table.push(vec![
                    Cell::text(&scene.scene.name),
                    Cell::text(mode.as_str()),
                    count(exact),
                    count(simplified),
                    count(zones.exact.areas_of(&mode)),
                ]);
            }
        }
    }
    unless_empty(table)
}

fn thresholds(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("frequency_ratio", "Threshold ω/ω_n", ""),
        Column::number("oscillating", "Oscillating points", ""),
        Column::number("inertial", "Of them inertial", ""),
        Column::number("moved", "Points whose mode differs from the default's", ""),
    ];
    let mut table = Table::new(
        "thresholds",
        "Dependence of the map on the threshold between inertial and non-inertial",
        columns,
    )
    .with_note("The default threshold is √½, the frequency ratio on K = K_c at η = 1.");
    for (scene, zones) in zoned(context) {
        for share in &zones.thresholds {
            table.push(vec![
                Cell::text(&scene.scene.name),
                rounded(share.frequency_ratio, 4),
                count(share.oscillating),
                count(share.inertial),
                count(share.moved),
            ]);
        }
    }
    unless_empty(table)
}
