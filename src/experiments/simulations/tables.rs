//! Tables of the simulations: the grid, the disagreements with the theory, and the least peaks.

use crate::experiments::Context;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::{rounded, rounded_or_empty};
use crate::experiments::simulations::{SimulatedPoint, SimulationsOutcome};
use crate::experiments::unless_empty;
use crate::experiments::{Need, SceneOutcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "simulations", needs: &[Need::Simulations], make: simulations },
    TableMaker { id: "simulation-disagreements", needs: &[Need::Simulations], make: disagreements },
    TableMaker { id: "least-peaks", needs: &[Need::Simulations], make: least_peaks },
];

/// Digits of peak and period: one fewer than the tolerance of 1e-8 allows, so that no rounding shows.
const DIGITS: usize = 7;

fn simulated<'c>(context: &'c Context) -> impl Iterator<Item = (&'c SceneOutcome, &'c SimulationsOutcome)> {
    context.outcome.scenes.iter().filter_map(|scene| Some((scene, scene.simulations.as_ref()?)))
}

/// Every point of every grid with its scene and law.
fn for_each_point(context: &Context, mut visit: impl FnMut(&str, EvolutionLaw, f64, f64, &SimulatedPoint)) {
    for (scene, outcome) in simulated(context) {
        for (law, grid) in &outcome.grids {
            for (velocity, stress, point) in grid.points() {
                visit(&scene.scene.name, *law, velocity, stress, point);
            }
        }
    }
}

fn simulations(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V_l", "m/s"),
        Column::number("stiffness_over_critical", "K/K_c", ""),
        Column::text("slip_mode_theory", "Slip mode, theory"),
        Column::text("slip_mode_simulation", "Slip mode, simulation"),
        Column::text("behaviour", "Long-term behaviour"),
        Column::number("peak_velocity_m_per_s", "Peak velocity", "m/s"),
        Column::number("period_s", "Period", "s"),
        Column::number("stress_drop_pa", "Stress drop", "Pa"),
        Column::number("peak_relative_error", "Error of the peak", ""),
        Column::number("period_relative_error", "Error of the period", ""),
        Column::text("failure", "Failure"),
    ];
    let mut table = Table::new("simulations", "Simulations, all grid points", columns)
        .with_note("Start: steady sliding at V_l/10. Peak and stress drop are those of the limit cycle, or of the transient of a decay; the period is that of the cycle or of the small oscillation at the end. Errors are relative estimates from a second run at a tenth of the tolerance.");
    for_each_point(context, |scene, law, velocity, stress, point| {
        let found = point.simulation.as_ref().ok();
        let word = |word: &str| if word.is_empty() { Cell::empty() } else { Cell::text(word) };
        let failure = point.simulation.as_ref().err().map_or_else(String::new, ToString::to_string);
        table.push(vec![
            Cell::text(scene),
            Cell::text(law.as_str()),
            rounded(stress, DIGITS),
            rounded(velocity, DIGITS),
            rounded_or_empty(point.stiffness_over_critical, DIGITS),
            Cell::text(point.theory.slip_mode.as_str()),
            word(found.map_or("", |found| found.slip_mode.as_str())),
            word(found.map_or("", |found| found.behaviour.as_str())),
            rounded_or_empty(found.map(|found| found.peak_velocity_m_per_s), DIGITS),
            rounded_or_empty(found.and_then(|found| found.period_s), DIGITS),
            rounded_or_empty(found.map(|found| found.stress_drop_pa), DIGITS),
            rounded_or_empty(found.map(|found| found.peak_relative_error), 2),
            rounded_or_empty(found.and_then(|found| found.period_relative_error), 2),
            word(&failure),
        ]);
    });
    unless_empty(table)
}

fn disagreements(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("scene", "Scene"),
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V_l", "m/s"),
        Column::text("slip_mode_theory", "Theory"),
        Column::text("slip_mode_simulation", "Simulation"),
        Column::number("max_imaginary_per_s", "max Im(s)", "1/s"),
        Column::number("angular_frequency_per_s", "Angular frequency of the run", "1/s"),
    ];
    let mut table =
        Table::new("simulation-disagreements", "Runs whose slip mode differs from theory", columns)
            .with_note("Runs without a result are listed with an empty mode.");
    for_each_point(context, |scene, law, velocity, stress, point| {
        if point.agrees() {
            return;
        }
        let found = point.simulation.as_ref().ok();
        let angular = found.and_then(|found| found.frequency_hz).map(|hz| std::f64::consts::TAU * hz);
        table.push(vec![
            Cell::text(scene),
            Cell::text(law.as_str()),
            rounded(stress, 4),
            rounded(velocity, 4),
            Cell::text(point.theory.slip_mode.as_str()),
            found.map_or_else(Cell::empty, |found| Cell::text(found.slip_mode.as_str())),
            rounded_or_empty(point.theory.max_imaginary_per_s.to_f64(), 5),
            rounded_or_empty(angular, 5),
        ]);
    });
    unless_empty(table)
}

fn least_peaks(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("eq18_velocity_m_per_s", "Velocity of eq 18", "m/s"),
        Column::number("offset_dex", "Offset of the minimum from eq 18", "dex"),
        Column::number("offset_error_dex", "Its error", "dex"),
        Column::number("peak_at_eq18_over_least", "Peak at eq 18 / lowest peak", ""),
        Column::number("curvature_per_dex2", "Curvature of ln(peak)", "1/dex²"),
        Column::number("one_percent_from_dex", "Within 1 % from", "dex"),
        Column::number("one_percent_to_dex", "to", "dex"),
        Column::number("five_percent_from_dex", "Within 5 % from", "dex"),
        Column::number("five_percent_to_dex", "to", "dex"),
        Column::number("cycle_mode_change_dex", "Mode of the cycle changes", "dex"),
        Column::number("theory_mode_change_dex", "Mode by theory changes", "dex"),
    ];
    let mut table = Table::new("least-peaks", "Velocity of the lowest peak, compared with eq 18", columns)
        .with_note("Minimised over one decade on either side of eq 18. All positions are log10 of the velocity divided by that of eq 18. The ends of the flat range and the changes of mode are located to 0.001 dex. The mode changes from stick-slip to harmonic vibration where the frequency of the limit cycle, or of small deviations by the exact theory, passes the threshold.");
    for least in simulated(context).flat_map(|(_, outcome)| &outcome.least_peaks) {
        table.push(vec![
            Cell::text(least.law.as_str()),
            rounded(least.normal_stress_pa, 4),
            rounded(least.eq18_velocity_m_per_s, 4),
            rounded(least.offset_dex, 4),
            rounded(least.offset_error_dex, 1),
            rounded(least.peak_at_eq18_over_least, 5),
            rounded(least.curvature_per_dex2, 3),
            rounded_or_empty(least.flat[0][0], 3),
            rounded_or_empty(least.flat[0][1], 3),
            rounded_or_empty(least.flat[1][0], 3),
            rounded_or_empty(least.flat[1][1], 3),
            rounded_or_empty(least.cycle_mode_change_dex, 3),
            rounded_or_empty(least.theory_mode_change_dex, 3),
        ]);
    }
    unless_empty(table)
}
