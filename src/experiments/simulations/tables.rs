//! Tables of the simulations: the grid, the disagreements with the theory, and the least peaks.

use crate::experiments::shared::cells::{DigitColumns, Rounded};
use crate::experiments::simulations::SimulatedPoint;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::dynamics::Simulation;
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "simulations", needs: &[Need::Simulations], make: simulations },
    TableMaker { id: "simulation-disagreements", needs: &[Need::Simulations], make: disagreements },
    TableMaker { id: "least-peaks", needs: &[Need::Simulations], make: least_peaks },
];

/// Digits of peak and period: one fewer than the tolerance of 1e-8 allows, so that no rounding shows.
const DIGITS: usize = 7;

/// A point of a grid with its scene, its law and its run, where that has a result.
#[derive(Clone, Copy)]
struct GridPoint<'c> {
    scene: &'c str,
    law: EvolutionLaw,
    velocity: f64,
    stress: f64,
    point: &'c SimulatedPoint,
    run: Option<&'c Simulation>,
}

fn points<'c>(context: &'c Context) -> impl Iterator<Item = GridPoint<'c>> {
    context.outcome.each(|scene| &scene.simulations).flat_map(|(scene, found)| {
        found.grids.iter().flat_map(move |&(law, ref grid)| {
            grid.points().map(move |(velocity, stress, point)| GridPoint {
                scene,
                law,
                velocity,
                stress,
                point,
                run: point.simulation.as_ref().ok(),
            })
        })
    })
}

fn simulations(context: &Context) -> Option<Table> {
    let note = "Start: steady sliding at V_l/10. Peak and stress drop are those of the limit cycle, or of the transient of a decay; the period is that of the cycle or of the small oscillation at the end. Errors are relative estimates from a second run at a tenth of the tolerance.";
    Table::of("simulations", "Simulations, all grid points", points(context))
        .note(note)
        .text("scene", "Scene", |at| at.scene)
        .text("law", "Law", |at| at.law.as_str())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", DIGITS, |at| Rounded(at.stress))
        .digits("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", DIGITS, |at| Rounded(at.velocity))
        .digits("stiffness_over_critical", "K/K_c", "", DIGITS, |at| {
            at.point.stiffness_over_critical.map(Rounded)
        })
        .text("slip_mode_theory", "Slip mode, theory", |at| at.point.theory.slip_mode.as_str())
        .text("slip_mode_simulation", "Slip mode, simulation", |at| at.run.map(|run| run.slip_mode.as_str()))
        .text("behaviour", "Long-term behaviour", |at| at.run.map(|run| run.behaviour.as_str()))
        .digits("peak_velocity_m_per_s", "Peak velocity", "m/s", DIGITS, |at| {
            Some(at.run?.peak_velocity_m_per_s)
        })
        .digits("period_s", "Period", "s", DIGITS, |at| at.run?.period_s)
        .digits("stress_drop_pa", "Stress drop", "Pa", DIGITS, |at| Some(at.run?.stress_drop_pa))
        .digits("peak_relative_error", "Error of the peak", "", 2, |at| Some(at.run?.peak_relative_error))
        .digits("period_relative_error", "Error of the period", "", 2, |at| at.run?.period_relative_error)
        .text("failure", "Failure", |at| at.point.simulation.as_ref().err().map(ToString::to_string))
        .table()
        .into()
}

fn disagreements(context: &Context) -> Option<Table> {
    let note = "Runs without a result are listed with an empty mode.";
    let disagreeing = points(context).filter(|at| !at.point.agrees());
    Table::of("simulation-disagreements", "Runs whose slip mode differs from theory", disagreeing)
        .note(note)
        .text("scene", "Scene", |at| at.scene)
        .text("law", "Law", |at| at.law.as_str())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |at| at.stress)
        .digits("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", 4, |at| at.velocity)
        .text("slip_mode_theory", "Theory", |at| at.point.theory.slip_mode.as_str())
        .text("slip_mode_simulation", "Simulation", |at| at.run.map(|run| run.slip_mode.as_str()))
        .digits("max_imaginary_per_s", "max Im(s)", "1/s", 5, |at| {
            at.point.theory.max_imaginary_per_s.to_f64()
        })
        .digits("angular_frequency_per_s", "Angular frequency of the run", "1/s", 5, |at| {
            Some(std::f64::consts::TAU * at.run?.frequency_hz?)
        })
        .table()
        .into()
}

fn least_peaks(context: &Context) -> Option<Table> {
    let note = "Minimised over one decade on either side of eq 18. All positions are log10 of the velocity divided by that of eq 18. The ends of the flat range and the changes of mode are located to 0.001 dex. The mode changes from stick-slip to harmonic vibration where the frequency of the limit cycle, or of small deviations by the exact theory, passes the threshold.";
    let found = context.outcome.each(|scene| &scene.simulations);
    let least_peaks = found.flat_map(|(_, found)| &found.least_peaks);
    Table::of("least-peaks", "Velocity of the lowest peak, compared with eq 18", least_peaks)
        .note(note)
        .text("law", "Law", |least| least.law.as_str())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |least| least.normal_stress_pa)
        .digits("eq18_velocity_m_per_s", "Velocity of eq 18", "m/s", 4, |least| least.eq18_velocity_m_per_s)
        .digits("offset_dex", "Offset of the minimum from eq 18", "dex", 4, |least| least.offset_dex)
        .digits("offset_error_dex", "Its error", "dex", 1, |least| least.offset_error_dex)
        .digits("peak_at_eq18_over_least", "Peak at eq 18 / lowest peak", "", 5, |least| {
            least.peak_at_eq18_over_least
        })
        .digits("curvature_per_dex2", "Curvature of ln(peak)", "1/dex²", 3, |least| least.curvature_per_dex2)
        .digits("one_percent_from_dex", "Within 1 % from", "dex", 3, |least| least.flat[0][0])
        .digits("one_percent_to_dex", "to", "dex", 3, |least| least.flat[0][1])
        .digits("five_percent_from_dex", "Within 5 % from", "dex", 3, |least| least.flat[1][0])
        .digits("five_percent_to_dex", "to", "dex", 3, |least| least.flat[1][1])
        .digits("cycle_mode_change_dex", "Mode of the cycle changes", "dex", 3, |least| {
            least.cycle_mode_change_dex
        })
        .digits("theory_mode_change_dex", "Mode by theory changes", "dex", 3, |least| {
            least.theory_mode_change_dex
        })
        .table()
        .into()
}
