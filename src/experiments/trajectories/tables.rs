//! Tables of the trajectories: what each run showed, and the samples that the figures draw.

use crate::experiments::shared::cells::Digits;
use crate::experiments::trajectories::{DRAWING_TOLERANCE, TrajectoryRun};
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::dynamics::Simulation;
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::{Cell, Table};

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
    context.outcome.each(|scene| &scene.trajectories).flat_map(|(_, runs)| runs)
}

/// A value with the digits that its relative error leaves certain, no more than so many.
fn certain(value: f64, relative_error: f64, most: usize) -> Cell {
    let digits = -libm::log10(relative_error);
    let digits = if digits >= 1.0 { libm::floor(digits) as usize } else { 1 };
    value.cell(digits.min(most))
}

/// A value of a run and its relative error, with the digits that are certain.
pub(super) fn certain_of(
    found: Option<&Simulation>,
    value: fn(&Simulation) -> Option<(f64, f64)>,
    most: usize,
) -> Option<Cell> {
    let (value, relative_error) = value(found?)?;
    Some(certain(value, relative_error, most))
}

fn finite(relative: Option<f64>) -> Option<f64> {
    relative.filter(|relative| relative.is_finite())
}

fn modes(context: &Context) -> Option<Table> {
    table_of("trajectory-modes", runs(context))
        .text("point", |run| &run.point.id)
        .text("law", |run| run.law.as_str())
        .digits("normal_stress_pa", 6, |run| &run.point.normal_stress_pa)
        .digits("loading_velocity_m_per_s", 6, |run| &run.point.loading_velocity_m_per_s)
        .text("slip_mode_theory", |run| run.theory.slip_mode.as_str())
        .text("slip_mode_simulation", |run| found(run).map(|found| found.slip_mode.as_str()))
        .digits("period_theory_s", MOST_DIGITS, period_by_theory)
        .number("period_s", |run| certain_of(found(run), period, MOST_DIGITS))
        .digits("period_relative_error", 2, |run| finite(found(run)?.period_relative_error))
        .number("peak_over_loading_velocity", |run| {
            let velocity = nearest_f64(&run.point.loading_velocity_m_per_s);
            found(run).map(|found| {
                certain(found.peak_velocity_m_per_s / velocity, found.peak_relative_error, MOST_DIGITS)
            })
        })
        .digits("peak_relative_error", 2, |run| finite(Some(found(run)?.peak_relative_error)))
        .number("stress_drop_pa", |run| certain_of(found(run), stress_drop, MOST_DIGITS))
        .digits("stress_drop_relative_error", 2, |run| finite(Some(found(run)?.stress_drop_relative_error)))
        .number("visible_turns", |run| visible_turns(run).map(|found| found[0]))
        .number("visible_error", |run| {
            visible_turns(run).map(|[all, least, most]| (most - all).max(all - least))
        })
        .digits("free_residual_pa", 1, |run| run.course.as_ref().ok().map(|course| course.free_residual_pa))
        .text("failure", failure)
        .table()
}

pub(super) fn period(found: &Simulation) -> Option<(f64, f64)> {
    found.period_s.zip(found.period_relative_error)
}

pub(super) fn stress_drop(found: &Simulation) -> Option<(f64, f64)> {
    Some((found.stress_drop_pa, found.stress_drop_relative_error))
}

fn found(run: &TrajectoryRun) -> Option<&Simulation> {
    run.simulation.as_ref().ok()
}

fn period_by_theory(run: &TrajectoryRun) -> Option<f64> {
    let imaginary = run.theory.max_imaginary_per_s.to_f64().filter(|imaginary| *imaginary > 0.0);
    imaginary.map(|imaginary| std::f64::consts::TAU / imaginary)
}

/// Smallest deviation from V_l, in V_l, that a reader sees as a peak or trough.
const VISIBLE: f64 = 0.01;

/// How many peaks and troughs of V a reader sees, the least number and the most within the error of the drawing.
fn visible_turns(run: &TrajectoryRun) -> Option<[u64; 3]> {
    let moments = &run.course.as_ref().ok()?.moments;
    let velocities: Vec<f64> = moments.iter().map(|moment| libm::exp(moment.log_velocity_ratio)).collect();
    let error = DRAWING_TOLERANCE * velocities.iter().copied().fold(0.0, f64::max);
    Some([0.0, error, -error].map(|room| turns(&velocities, VISIBLE + room)))
}

/// How many peaks and troughs differ from V_l by so much, in V_l.
fn turns(velocities: &[f64], visible: f64) -> u64 {
    let is_turn = |three: &&[f64]| {
        let [before, here, after] = three else { return false };
        (here - before) * (after - here) < 0.0 && (here - 1.0).abs() >= visible
    };
    velocities.windows(3).filter(is_turn).count() as u64
}

fn failure(run: &TrajectoryRun) -> Option<String> {
    run.simulation.as_ref().err().or(run.course.as_ref().err()).map(ToString::to_string)
}

fn samples(context: &Context) -> Option<Table> {
    let rows = runs(context).flat_map(|run| {
        run.course.iter().flat_map(|course| &course.moments).map(move |moment| (run, moment))
    });
    table_of("trajectories", rows)
        .text("point", |(run, _)| &run.point.id)
        .text("law", |(run, _)| run.law.as_str())
        .digits("time_s", TIME_DIGITS, |(_, at)| at.time_s)
        .digits("velocity_log10_ratio", SAMPLE_DIGITS, |(_, at)| {
            at.log_velocity_ratio / std::f64::consts::LN_10
        })
        .digits("shear_stress_change_pa", SAMPLE_DIGITS, |(_, at)| at.stress_change_pa)
        .table()
}

#[cfg(test)]
mod tests {
    use super::turns;

    #[test]
    fn only_visible_turns_count() {
        assert_eq!(turns(&[0.1, 1.5, 0.9, 1.005, 1.0], 0.01), 2);
        assert_eq!(turns(&[0.1, 1.5, 0.9, 1.005, 1.0], 0.004), 3);
    }
}
