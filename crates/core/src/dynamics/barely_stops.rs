//! Whether a cycle is the limit cycle where its errors decide that the slider stops; if it is not, a crossing near the limit cycle.
//!
//! For κη ≫ 1 the slider vibrates about V = V_l with an amplitude A V_l. An orbit with A > 1 stops and forgets its amplitude: its returns
//! contract fast. An orbit with A < 1 changes its amplitude by a part of 1/√(κη) in a return, up or down. The return map is continuous
//! at A = 1, but its derivative is not. A run that comes from A > 1 contracts fast down to A = 1. From there it changes by so little in a return
//! that it seems to have arrived, and a derivative differenced across A = 1 says that it has.
//!
//! So where the estimated error ε of V, or the interval over which contraction was measured, reaches across A = 1, the ends of the error are
//! tested with one return each. If A − ε grows and A + ε shrinks, a fixed point lies between them, because the map is continuous. If not,
//! starts farther away in this direction are tried until the change has the other sign: the limit cycle lies between the last two.

use super::Failure;
use super::refine::Refined;
use super::return_errors::velocity_error;
use super::return_map::{ReturnMap, shifted};
use super::stepper::Stepper;

/// Local tolerance of the returns. Their amplitudes err by less than 1e-10, and change by 1/√(κη).
const TOLERANCE: f64 = 1e-7;

/// Factor between the distances of two starts from the cycle.
const FARTHER: f64 = 4.0;

/// What is known of a cycle.
#[derive(Debug)]
pub(super) enum Confirmed {
    /// It is the limit cycle within its errors.
    Cycle,
    /// It is not; the limit cycle is near this crossing (y, ζ).
    Elsewhere([f64; 2]),
    /// It is not, and no other was found.
    Nowhere,
}

/// Whether the slider stops on one side of what a cycle's errors depend on, and does not on the other.
///
/// With V = κt²/2η − Δ next to the turn, V is least with −Δ where the slider turns above zero; where it stops, friction falls by √(2κηΔ).
pub(super) fn may_stop_or_not<R>(refined: &Refined<f64>, map: &ReturnMap<'_, f64, R>) -> bool {
    let groups = map.model.groups();
    let orbit = &refined.mapped.orbit;
    let swing_squared = groups.stiffness_group * groups.inertial_parameter;
    let margin = libm::exp(orbit.trough).max(0.5 * orbit.trough * orbit.trough / swing_squared);
    let measured_over = libm::exp(orbit.peak) * refined.measured_over;
    margin <= velocity_error(refined.errors, orbit).max(measured_over)
}

/// Tests both ends of the error of a cycle that may stop or not.
pub(super) fn confirm<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    refined: &Refined<f64>,
) -> Result<Confirmed, Failure> {
    let orbit = &refined.mapped.orbit;
    let from = refined.mapped.from;
    let error = velocity_error(refined.errors, orbit);
    // With an error as large as the amplitude there is nothing to test, and the result misses every request.
    if error >= 1.0 {
        return Ok(Confirmed::Cycle);
    }
    let below = growth(map, from, -error)?;
    if below < 0.0 {
        return beyond(map, from, -error, below);
    }
    // An orbit that stops does not grow.
    if libm::exp(orbit.trough) > error {
        let above = growth(map, from, error)?;
        if above > 0.0 {
            return beyond(map, from, error, above);
        }
    }
    Ok(Confirmed::Cycle)
}

/// Seeks the amplitude at which the growth changes its sign, away from a part where it does not have it yet.
fn beyond<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    from: [f64; 2],
    mut part: f64,
    mut change: f64,
) -> Result<Confirmed, Failure> {
    while (FARTHER * part).abs() < 1.0 {
        let farther = FARTHER * part;
        let next = growth(map, from, farther)?;
        if (next < 0.0) != (change < 0.0) {
            let zero = part + (farther - part) * change / (change - next);
            return Ok(Confirmed::Elsewhere(raised(map, from, zero)));
        }
        (part, change) = (farther, next);
    }
    Ok(Confirmed::Nowhere)
}

/// The crossing with an amplitude larger by a part: ζ − φ is the momentum there, and in proportion to the amplitude.
fn raised<M>(map: &ReturnMap<'_, f64, M>, from: [f64; 2], part: f64) -> [f64; 2] {
    let momentum = map.model.imbalance(&[0.0, from[0], from[1]]);
    shifted(&from, [0.0, part * momentum], map.model.groups().effect_ratio)
}

/// The part by which a return changes the amplitude when it begins with one larger by `part`.
fn growth<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    from: [f64; 2],
    part: f64,
) -> Result<f64, Failure> {
    let start = raised(map, from, part);
    let image = map.apply(&start, TOLERANCE)?.image;
    let momentum = |[y, zeta]: [f64; 2]| map.model.imbalance(&[0.0, y, zeta]);
    Ok(momentum(image) / momentum(start) - 1.0)
}

#[cfg(test)]
mod tests {
    use crate::dynamics::{Model, Options, simulate_model};
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn a_cycle_that_turns_above_zero_is_not_taken_for_one_that_stops() {
        // V_peak/V_l by a Taylor series in 113-bit arithmetic (heyoka); orbits at V_peak = 2 V_l change by 3e-5 in a return.
        let groups = Groups { inertial_parameter: 1e5, stiffness_group: 1.2e4, effect_ratio: 1.61 };
        let model = Model::new(groups, EvolutionLaw::Aging);
        for tolerance in [1e-2, 1e-3, 1e-5, 1e-8] {
            let found = simulate_model(&model, &Options::at(tolerance)).unwrap();
            let error = (libm::exp(found.log_peak()) / 1.964_756_889_730_67 - 1.0).abs();
            assert!(error <= found.largest_error(), "{tolerance:e}: {error:e} {:e}", found.largest_error());
        }
    }

    #[test]
    fn a_cycle_that_turns_at_a_millionth_of_the_loading_velocity_is_found_at_every_tolerance() {
        let groups = Groups { inertial_parameter: 3.559e7, stiffness_group: 8.341e4, effect_ratio: 1.309 };
        let model = Model::new(groups, EvolutionLaw::Aging);
        let [loose, tight, tightest] = [1e-2, 1e-5, 1e-8].map(|tolerance| {
            let found = simulate_model(&model, &Options::at(tolerance)).unwrap();
            (libm::exp(found.log_peak()), found.largest_error())
        });
        assert!(tightest.0 < 2.0 - 1e-6 && tightest.1 < 1e-8, "{tightest:?}");
        for (peak, error) in [loose, tight] {
            assert!((peak / tightest.0 - 1.0).abs() <= error + tightest.1, "{peak} {error:e}");
        }
    }
}
