//! How fast and how slow the simulated limit cycles slip, in one sentence.

use crate::experiments::Outcome;
use crate::experiments::simulations::SimulatedPoint;
use crate::scene::cited;
use slipmode_core::number::format::round_digits;

/// Velocities at which the rate-and-state law is measured in laboratories, m/s, rounded outward to decades: the reviews of Marone
/// (1998) and of Baumberger and Caroli (2006) have none outside.
const MEASURED_M_PER_S: [f64; 2] = [1e-10, 1e-2];

/// Digits of a velocity in the sentence; the table has more.
const DIGITS: usize = 2;

/// A warning where limit cycles leave the velocities at which the law is measured: Markdown; `None` where none does.
pub(crate) fn range_of_velocities(outcome: &Outcome) -> Option<String> {
    let grids = outcome.each(|scene| &scene.simulations).flat_map(|(_, found)| &found.grids);
    let points = grids.flat_map(|(_, grid)| grid.points());
    let extremes: Vec<[f64; 2]> =
        points.filter_map(|(velocity, _, point)| extremes(velocity, point)).collect();
    let slowest = extremes.iter().map(|range| range[0]).fold(f64::INFINITY, f64::min);
    let fastest = extremes.iter().map(|range| range[1]).fold(0.0, f64::max);
    let [least, most] = MEASURED_M_PER_S;
    let outside = extremes.iter().filter(|[low, high]| *low < least || *high > most).count();
    let [low, high, least, most] =
        [slowest, fastest, least, most].map(|velocity| round_digits(velocity, DIGITS));
    (outside > 0).then(|| {
        cited(&format!(
            "Validity: the simulated limit cycles slip as slowly as {low} m/s and as fast as {high} m/s. In {outside} of {} cycles the law of {{friction}} is extrapolated beyond {least} to {most} m/s, where laboratories measure it.",
            extremes.len()
        ))
    })
}

/// The lowest and the highest velocity of a limit cycle.
fn extremes(loading_velocity: f64, point: &SimulatedPoint) -> Option<[f64; 2]> {
    let simulation = point.simulation.as_ref().ok().filter(|_| point.periodic() == Some(true))?;
    let lowest = loading_velocity * libm::exp10(simulation.minimum_velocity_log10_ratio);
    Some([lowest, simulation.peak_velocity_m_per_s])
}
