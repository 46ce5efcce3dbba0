//! The table of frequencies.

use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::number::Wide;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "frequency", needs: &[Need::Frequency], make: frequency }];

fn frequency(context: &Context) -> Option<Table> {
    let rows = context.outcome.each(|scene| &scene.frequency).flat_map(|(name, found)| {
        found.lines.iter().flat_map(move |line| {
            let points = found.loading_velocity_m_per_s.iter().zip(&line.max_imaginary_per_s);
            points.map(move |(velocity, imaginary)| (name, line, *velocity, *imaginary))
        })
    });
    table_of("frequency", rows)
        .text("scene", |(name, ..)| name)
        .digits("normal_stress_over_critical", 6, |(_, line, ..)| &line.normal_stress_over_critical)
        .digits("normal_stress_pa", 8, |(_, line, ..)| &line.normal_stress_pa)
        .digits("loading_velocity_m_per_s", 8, |(_, _, velocity, _)| velocity)
        .number("max_imaginary_per_s", |(.., imaginary)| shown(imaginary))
        .table()
}

/// Twelve digits: two fewer than the error allows, so that no rounding shows.
fn shown(value: Wide) -> Cell {
    Cell::number(value.to_f64().map_or_else(|| value.to_string(), |value| round_digits(value, 12)))
}
