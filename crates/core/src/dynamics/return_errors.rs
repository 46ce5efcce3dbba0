//! What a return errs by: from its difference to another return of the same crossing, from bad steps, from rounding.

use super::observables::Observables;
use super::return_map::MappedReturn;
use super::{Return, Scalar};
use crate::friction::Groups;

/// Error of the finer return over the difference of the two: 1/99 and less when the error follows the tolerance. Where Newton's iteration rather
/// than the tolerance limits the steps both returns take nearly the same ones; 3 holds as long as the finer errs by a quarter less.
pub(super) const OF_DIFFERENCE: f64 = 3.0;

/// The part of the largest difference of all observables that each is granted, should it agree by chance.
pub(super) const OF_LARGEST: f64 = 0.3;

/// Units that a stress held through a stick phase may err by in a step, over those of other quantities.
const HELD: f64 = 5.0;

/// A bound of the rounding errors of a return, and of what rounding the groups does: units of the largest quantity in every step, of either
/// sign, so that they add up to the root of the number of steps.
pub(super) fn rounding<R: Scalar>(mapped: &MappedReturn<R>) -> f64 {
    let largest =
        [&mapped.orbit.trough, &mapped.orbit.peak, &mapped.orbit.highest_stress, &mapped.orbit.lowest_stress];
    let size = largest.iter().fold(mapped.size(), |size, value| size.max(value.to_f64().abs()));
    // A state below 1 is computed relative to its size, observables are compared with 1.
    (mapped.steps as f64).sqrt() * 4.0 * R::UNIT_ROUNDOFF.max(f64::EPSILON * f64::EPSILON) * size
}

/// What is shown of rounding errors: ζ acts on the velocity through its part of ζ, which is no larger than the range of ln V.
///
/// A stress that is held through a stick phase keeps all that Newton's iteration leaves in a step: it ends where updates are below two
/// units for each of the ten sums that they are made of. What follows a stick phase sees of it what it sees of another crossing.
pub(super) fn rounding_shown<R: Scalar>(
    mapped: &MappedReturn<R>,
    gains: Observables<f64>,
) -> Observables<f64> {
    let shown = Observables::of(&mapped.orbit).map(|value| value.abs());
    let range = shown.log_peak.max(shown.log_trough).max(1.0);
    let whole = rounding(mapped);
    let unit = whole / mapped.size().max(range);
    shown
        .zip(gains)
        .zip(Observables::held(1.0, 0.0))
        .map(|&((shown, gain), held)| unit * shown.max(range) + HELD * whole * gain.max(held))
}

/// The errors of the finer of two returns that differ by this much, and of what is seen of a bad step, which acts like a deviation of the
/// crossing: a slider that barely stops does so at a stress that changes by hundreds of times as much.
pub(super) fn return_errors<R: Scalar>(
    differences: Observables<f64>,
    orbit: &Return<R>,
    gains: Observables<f64>,
    floor: f64,
) -> Observables<f64> {
    let scales = Observables::of(orbit).map(|value| value.abs().max(1.0));
    let largest = differences.zip(scales).map(|(difference, scale)| difference.abs() / scale).largest();
    // Stress is loaded at a steady rate: what a stick phase errs in its duration, stress errs in its range.
    let range = (orbit.highest_stress.to_f64() - orbit.lowest_stress.to_f64()).abs();
    let loaded = Observables::held(range, 0.0).map(|range| range * differences.log_duration.abs());
    differences.zip(loaded).zip(scales).zip(gains).map(|&(((difference, loaded), scale), gain)| {
        OF_DIFFERENCE * (difference.abs() + loaded) + OF_LARGEST * largest * scale + gain.max(1.0) * floor
    })
}

/// The errors with what inertia makes of that of the velocity, ε in units of V_l.
///
/// Next to its turn the slider moves with V = κt²/2η − Δ. Where Δ > 0 it stops, and friction has fallen by D = √(2κηΔ) when it does: V near
/// zero is decided by parts of ε, and D² errs by 2κηε. Stress swings with the velocity by √(κη) times as much.
pub(super) fn with_inertia<R: Scalar>(
    errors: Observables<f64>,
    orbit: &Return<R>,
    groups: &Groups<R>,
) -> Observables<f64> {
    let shown = Observables::of(orbit);
    let swing = (groups.stiffness_group.to_f64() * groups.inertial_parameter.to_f64()).sqrt();
    let velocity_error = velocity_error(errors, orbit);
    let square = (2.0 * swing * swing * velocity_error).min(f64::MAX);
    let depth = shown.log_trough.abs();
    let stop = square.sqrt().min(square / (depth + (depth * depth - square).max(0.0).sqrt()));
    let stress = (swing * velocity_error).min(f64::MAX);
    errors + Observables { log_trough: stop, ..Observables::held(stress, 0.0) }
}

/// The error of the velocity in units of V_l.
pub(super) fn velocity_error<R: Scalar>(errors: Observables<f64>, orbit: &Return<R>) -> f64 {
    (libm::exp(orbit.peak.to_f64()) * errors.log_peak).min(f64::MAX)
}
