//! The table of frequencies.

use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::number::Wide;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "frequency", needs: &[Need::Frequency], make: frequency }];

fn frequency(context: &Context) -> Option<Table> {
    let note = "Relative error at most 1e-14; 0 where all roots are real.";
    let rows = context.outcome.each(|scene| &scene.frequency).flat_map(|(name, found)| {
        found.lines.iter().flat_map(move |line| {
            let points = found.loading_velocity_m_per_s.iter().zip(&line.max_imaginary_per_s);
            points.map(move |(velocity, imaginary)| (name, line, *velocity, *imaginary))
        })
    });
    Table::of("frequency", "Largest imaginary part along lines of constant normal stress", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .digits("normal_stress_over_critical", "σ/σ_c", "", 6, |(_, line, ..)| {
            &line.normal_stress_over_critical
        })
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 8, |(_, line, ..)| &line.normal_stress_pa)
        .digits("loading_velocity_m_per_s", "Loading velocity V0", "m/s", 8, |(_, _, velocity, _)| velocity)
        .number("max_imaginary_per_s", "max Im(s)", "1/s", |(.., imaginary)| shown(imaginary))
        .table()
        .into()
}

/// Twelve digits: two fewer than the error allows, so that no rounding shows.
fn shown(value: Wide) -> Cell {
    Cell::number(value.to_f64().map_or_else(|| value.to_string(), |value| round_digits(value, 12)))
}
