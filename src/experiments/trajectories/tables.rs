//! Tables of the trajectories: what each run showed, and the samples that the figures draw.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::rounded;
use crate::experiments::trajectories::TrajectoryRun;
use crate::experiments::unless_empty;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "trajectory-modes", needs: &[Need::Trajectories], make: modes },
    TableMaker { id: "trajectories", needs: &[Need::Trajectories], make: samples },
];

/// Most digits of a number in these tables.
const MOST_DIGITS: usize = 9;
/// Digits of a sample: ten times finer than the thinning.
const SAMPLE_DIGITS: usize = 5;
/// Digits of a sample's time, so that the samples of a fast event stay apart in a plot over the whole run.
const TIME_DIGITS: usize = 7;

fn runs<'c>(context: &'c Context) -> impl Iterator<Item = &'c TrajectoryRun> {
    context.outcome.scenes.iter().filter_map(|scene| scene.trajectories.as_ref()).flatten()
}

/// A value with the digits that its relative error leaves certain.
fn certain(value: f64, relative_error: f64) -> Cell {
    let digits = -libm::log10(relative_error);
    let digits = if digits >= 1.0 { libm::floor(digits) as usize } else { 1 };
    rounded(value, digits.min(MOST_DIGITS))
}

fn error(relative: f64) -> Cell {
    if relative.is_finite() { rounded(relative, 2) } else { Cell::empty() }
}

fn modes(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("point", "Point"),
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V_l", "m/s"),
        Column::text("slip_mode_theory", "Slip mode, theory"),
        Column::text("slip_mode_simulation", "Slip mode, simulation"),
        Column::number("period_theory_s", "2π/max Im(s), theory", "s"),
        Column::number("period_s", "Period, simulation", "s"),
        Column::number("period_relative_error", "Its error", ""),
        Column::number("peak_over_loading_velocity", "Peak velocity / V_l", ""),
        Column::number("peak_relative_error", "Its error", ""),
        Column::number("stress_drop_pa", "Stress drop", "Pa"),
        Column::number("stress_drop_relative_error", "Its error", ""),
        Column::number("free_residual_pa", "Free residual", "Pa"),
        Column::text("failure", "Failure"),
    ];
    let mut table = Table::new("trajectory-modes", "Results of the runs of figs 3b to 3g and 6b to 6d", columns)
        .with_note("The slip mode of a simulation is determined from its long-term behaviour alone. Peak and stress drop are those of the limit cycle, or of the transient of a decay. Errors are relative estimates from a second run at a tenth of the tolerance. The period of the theory is that of the small oscillation, from the exact class and a 64-bit root. The free residual is the largest difference between the integrated spring stress and the spring stress computed from separately integrated slip.");
    runs(context).for_each(|run| table.push(mode_row(run)));
    unless_empty(table)
}

fn mode_row(run: &TrajectoryRun) -> Vec<Cell> {
    let found = run.simulation.as_ref().ok();
    let number = |cell: Option<Cell>| cell.unwrap_or_else(Cell::empty);
    let velocity = nearest_f64(&run.point.loading_velocity_m_per_s);
    let imaginary = run.theory.max_imaginary_per_s.to_f64().filter(|imaginary| *imaginary > 0.0);
    let failure = run.simulation.as_ref().err().or(run.course.as_ref().err());
    let mut cells = point_cells(run);
    cells.extend([
        Cell::number(rational_to_decimal(&run.point.normal_stress_pa, 6)),
        Cell::number(rational_to_decimal(&run.point.loading_velocity_m_per_s, 6)),
        Cell::text(run.theory.slip_mode.as_str()),
        number(found.map(|found| Cell::text(found.slip_mode.as_str()))),
        number(imaginary.map(|imaginary| rounded(std::f64::consts::TAU / imaginary, MOST_DIGITS))),
        number(found.and_then(|found| Some(certain(found.period_s?, found.period_relative_error?)))),
        number(found.and_then(|found| found.period_relative_error).map(error)),
        number(found.map(|found| certain(found.peak_velocity_m_per_s / velocity, found.peak_relative_error))),
        number(found.map(|found| error(found.peak_relative_error))),
        number(found.map(|found| certain(found.stress_drop_pa, found.stress_drop_relative_error))),
        number(found.map(|found| error(found.stress_drop_relative_error))),
        number(run.course.as_ref().ok().map(|course| rounded(course.free_residual_pa, 1))),
        number(failure.map(|failure| Cell::text(failure.to_string()))),
    ]);
    cells
}

fn point_cells(run: &TrajectoryRun) -> Vec<Cell> {
    vec![Cell::text(&run.point.id), Cell::text(run.law.as_str())]
}

fn samples(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("point", "Point"),
        Column::text("law", "Law"),
        Column::number("time_s", "Time since the start", "s"),
        Column::number("velocity_log10_ratio", "log10 of V/V_l", ""),
        Column::number("shear_stress_change_pa", "Shear stress relative to steady sliding", "Pa"),
    ];
    let mut table = Table::new("trajectories", "Samples of the runs in the figures", columns)
        .with_note("Start: steady sliding at V_l/10. The samples are thinned: every omitted sample lies within a thousandth of the curve's extent from the line through the samples shown, in every pair of time, velocity, its logarithm and stress. Values are rounded for drawing; the tables of observables have all certain digits.");
    for run in runs(context) {
        for moment in run.course.iter().flat_map(|course| &course.moments) {
            let log10_ratio = moment.log_velocity_ratio / std::f64::consts::LN_10;
            let mut cells = point_cells(run);
            cells.push(rounded(moment.time_s, TIME_DIGITS));
            cells.push(rounded(log10_ratio, SAMPLE_DIGITS));
            cells.push(rounded(moment.stress_change_pa, SAMPLE_DIGITS));
            table.push(cells);
        }
    }
    unless_empty(table)
}
