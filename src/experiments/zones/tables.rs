//! Tables of slip modes and frequencies.

use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::unless_empty;
use crate::experiments::zones::ZonesOutcome;
use crate::experiments::{Need, SceneOutcome};
use slipmode_core::number::Wide;
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_core::stability::SlipMode;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "frequency", needs: &[Need::Frequency], make: frequency },
    TableMaker { id: "zones", needs: &[Need::Map, Need::Zones], make: zones },
    TableMaker { id: "thresholds", needs: &[Need::Map, Need::Zones], make: thresholds },
];

fn frequency(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("normal_stress_over_critical", "σ/σ_c", ""),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::number("max_imaginary_per_s", "max Im(s)", "1/s"),
    ];
    let mut table =
        Table::new("frequency", "Largest imaginary part along lines of constant normal stress", columns)
            .with_note("Relative error at most 1e-14; 0 where all roots are real.");
    for scene in &context.outcome.scenes {
        let Some(outcome) = &scene.frequency else { continue };
        for line in &outcome.lines {
            for (velocity, imaginary) in
                outcome.loading_velocity_m_per_s.iter().zip(&line.max_imaginary_per_s)
            {
                table.push(vec![
                    Cell::text(&scene.scene.name),
                    Cell::number(rational_to_decimal(&line.normal_stress_over_critical, 6)),
                    Cell::number(rational_to_decimal(&line.normal_stress_pa, 8)),
                    Cell::number(round_digits(*velocity, 8)),
                    Cell::number(shown(*imaginary)),
                ]);
            }
        }
    }
    unless_empty(table)
}

/// Twelve digits: two fewer than the error allows, so that no rounding shows.
fn shown(value: Wide) -> String {
    value.to_f64().map_or_else(|| value.to_string(), |value| round_digits(value, 12))
}

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
            let count = |values: &[SlipMode]| values.iter().filter(|value| **value == mode).count();
            let (exact, simplified) = (count(&zones.exact.values), count(&zones.simplified.values));
            if exact + simplified > 0 {
                table.push(vec![
                    Cell::text(&scene.scene.name),
                    Cell::text(mode.as_str()),
                    Cell::number(exact.to_string()),
                    Cell::number(simplified.to_string()),
                    Cell::number(zones.exact.areas_of(&mode).to_string()),
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
                Cell::number(round_digits(share.frequency_ratio, 4)),
                Cell::number(share.oscillating.to_string()),
                Cell::number(share.inertial.to_string()),
                Cell::number(share.moved.to_string()),
            ]);
        }
    }
    unless_empty(table)
}
