//! The table of frequencies.

use crate::experiments::shared::cells::rounded;
use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_core::number::Wide;
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "frequency", needs: &[Need::Frequency], make: frequency }];

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
                    rounded(*velocity, 8),
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
