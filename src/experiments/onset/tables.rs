//! Tables of the onset of oscillation: velocities of theory and simulations, and the runs of fig 4.

use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::onset::{Located, Onset};
use crate::experiments::shared::cells::rounded;
use crate::experiments::unless_empty;
use crate::experiments::{Need, SceneOutcome};
use slipmode_core::number::format::{certain_digits, rational_to_decimal};
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "onset", needs: &[Need::Onset], make: onset },
    TableMaker { id: "onset-runs", needs: &[Need::Onset], make: runs },
];

fn lines<'c>(context: &'c Context) -> impl Iterator<Item = (&'c SceneOutcome, &'c Onset)> {
    let of = |scene: &'c SceneOutcome| Some((scene, scene.onset.as_ref()?));
    context
        .outcome
        .scenes
        .iter()
        .filter_map(of)
        .flat_map(|(scene, found)| found.lines.iter().map(move |line| (scene, line)))
}

/// log10 of a velocity over that of the asymptote.
fn dex(line: &Onset, velocity: f64, digits: usize) -> Cell {
    rounded(libm::log10(velocity / line.asymptote_velocity_m_per_s.to_f64()), digits)
}

/// A located velocity and its error.
fn located(line: &Onset, found: Option<&Located>) -> [Cell; 2] {
    found.map_or_else(
        || [Cell::empty(), Cell::empty()],
        |found| [dex(line, found.velocity_m_per_s, 4), rounded(found.error_dex, 1)],
    )
}

fn onset(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::text("asymptote", "Asymptote"),
        Column::number("asymptote_velocity_m_per_s", "Velocity of the asymptote", "m/s"),
        Column::number("boundary_velocity_m_per_s", "Velocity of the exact boundary", "m/s"),
        Column::number("boundary_dex", "Exact boundary", "dex"),
        Column::number("simulated_dex", "Oscillation in simulations", "dex"),
        Column::number("simulated_error_dex", "Its error", "dex"),
        Column::number("inertial_dex", "Inertial by the threshold", "dex"),
        Column::number("second_rise_dex", "Second rise visible", "dex"),
        Column::number("undershoot_dex", "Undershoot visible", "dex"),
        Column::number("seen_error_dex", "Error of the visible onset", "dex"),
        Column::number("peak_excess_at_boundary", "V_peak/V_l − 1 at the boundary", ""),
    ];
    let mut table = Table::new("onset", "Onset of oscillation at given normal stress", columns)
        .with_note("Velocities in dex are log10 of the ratio to that of the asymptote (eq 20; eq 18 on the upper arc). The exact boundary is enclosed and the threshold is decided exactly. Simulated oscillation begins where the squared frequency of small deviations extrapolates to zero. Oscillation is visible if V, after its first peak above V_l in the run from V_l/10, rises again, or falls below V_l, by the scene's visible fraction of V_l.");
    for (scene, line) in lines(context) {
        for seen in &line.seen {
            let [exists, exists_error] = located(line, seen.exists.as_ref());
            let [second_rise, _] = located(line, seen.second_rise.as_ref());
            let [undershoot, seen_error] = located(line, seen.undershoot.as_ref());
            let [inertial, _] = located(line, line.inertial.as_ref());
            let peak = seen.peak_excess_at_boundary;
            table.push(vec![
                Cell::text(&scene.scene.name),
                Cell::text(seen.law.as_str()),
                Cell::number(rational_to_decimal(&line.normal_stress_pa, 4)),
                Cell::text(line.asymptote.as_str()),
                Cell::number(certain_digits(&line.asymptote_velocity_m_per_s, 6)),
                Cell::number(certain_digits(&line.boundary_velocity_m_per_s, 6)),
                dex(line, line.boundary_velocity_m_per_s.to_f64(), 4),
                exists,
                exists_error,
                inertial,
                second_rise,
                undershoot,
                seen_error,
                peak.map_or_else(Cell::empty, |peak| rounded(peak, 3)),
            ]);
        }
    }
    unless_empty(table)
}

fn runs(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V_l", "m/s"),
        Column::number("loaded_distance_over_slip_distance", "V_l t/D_c", ""),
        Column::number("velocity_over_loading_velocity", "V/V_l", ""),
    ];
    let mut table = Table::new("onset-runs", "Runs on either side of the onset", columns)
        .with_note("Samples of the runs of fig 4, equally spaced in time.");
    for (scene, line) in lines(context) {
        for run in &line.shown {
            for &(time, velocity) in &run.history {
                table.push(vec![
                    Cell::text(&scene.scene.name),
                    Cell::number(rational_to_decimal(&line.normal_stress_pa, 4)),
                    rounded(run.loading_velocity_m_per_s, 4),
                    rounded(time, 4),
                    rounded(velocity, 5),
                ]);
            }
        }
    }
    unless_empty(table)
}
