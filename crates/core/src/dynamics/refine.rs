//! A cycle found roughly, brought to its accuracy, with the errors of everything it shows.
//!
//! Two things part what is reported from the truth. The *returns* err: the same cycle is integrated at two tolerances a factor 100
//! apart, and the error of the finer one is taken as thrice their difference, part of the largest difference of all observables (two
//! returns agree by chance in one of them, not in all), and the finer tolerance itself: a step as bad as its estimate does happen. The
//! *crossing* is not the fixed point: with the derivative P' of the map the way left is (1 − P')^{-1}(P(s) − s), and an error ε of the
//! return's end moves the fixed point by (1 − P')^{-1}ε. Next to K = K_c, and for η ≫ 1, 1 − P' is small and this is the larger part by orders
//! of magnitude. Both are carried to the observables by derivatives that the same differences of returns give. That a return contracts
//! fast is not believed from its approach, which may have left a slow direction unexcited: a deviation is followed to see it shrink.

use super::history::{difference, size};
use super::long_term::SLOW;
use super::observables::Observables;
use super::outcome::Errors;
use super::return_errors::{OF_DIFFERENCE, return_errors, rounding, rounding_shown, with_inertia};
use super::return_map::{Derivative, MappedReturn, ReturnMap, shifted};
use super::stepper::Stepper;
use super::{Cycle, Failure, Scalar, State};

/// Newton's corrections before the derivative is called useless.
const MOST_CORRECTIONS: usize = 8;

/// Local tolerance of the returns whose differences are the derivative: their quotients must resolve 1 − P'.
const DERIVATIVE_TOLERANCE: f64 = 1e-6;

/// Where 1 − P' is less than this, the derivative of the returns' own errors may be all of it, and an entry too small to be seen may decide: it
/// is believed only when a tolerance a hundred times tighter gives about the same. Else decays that last millions of returns would pass for
/// cycles.
const RESOLVED: f64 = 1e-3;

/// The tolerance of each derivative over that of the one before, and the tightest.
const FINER: f64 = 0.01;
const TIGHTEST_DERIVATIVE: f64 = 1e-13;

/// Relative size of the deviation that shows whether a return contracts fast.
const DEVIATION: f64 = 1e-2;

/// The same over the tolerance: no larger than the errors of returns require, because a slider that barely stops is linear nearby only.
const DEVIATION_IN_TOLERANCES: f64 = 30.0;

/// The least relative size, for rounding errors.
const LEAST_DEVIATION: f64 = 1e-7;

/// Relative size of a correction after which the derivative stays good.
const SMALL: f64 = 1e-3;

/// A cycle with the errors of what it shows.
#[derive(Debug, Clone)]
pub(super) struct Refined<R> {
    pub mapped: MappedReturn<R>,
    pub errors: Observables<f64>,
    /// Newton's correction that is left, relative to the state.
    pub distance: f64,
    /// Part of the momentum of the crossing over which its contraction was measured.
    pub measured_over: f64,
}

impl Refined<f64> {
    /// The limit cycle and the errors of what it shows.
    pub fn cycle(self, returns_per_cycle: usize, contraction: Option<f64>) -> (Cycle<f64>, Errors) {
        let Self { mapped, errors, distance, .. } = self;
        let errors = Errors {
            peak: errors.log_peak,
            period: Some(errors.log_duration),
            trough: errors.log_trough,
            drop: errors.highest_stress + errors.lowest_stress,
        };
        let from = [0.0, mapped.from[0], mapped.from[1]];
        (Cycle { orbit: mapped.orbit, returns_per_cycle, contraction, distance, from }, errors)
    }
}

impl<R: Scalar> Refined<R> {
    /// The same in f64.
    pub fn rounded(self) -> Refined<f64> {
        let MappedReturn { from, image, orbit, steps } = self.mapped;
        let mapped = MappedReturn {
            from: from.map(|c| c.to_f64()),
            image: image.map(|c| c.to_f64()),
            orbit: orbit.rounded(),
            steps,
        };
        let errors =
            self.errors + Observables::of(&mapped.orbit).map(|shown| f64::EPSILON * shown.abs().max(1.0));
        Refined { mapped, errors, distance: self.distance, measured_over: self.measured_over }
    }
}

/// The tolerances of the two returns and the error they are for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accuracy {
    pub coarse: f64,
    pub fine: f64,
    /// What the steps of the finer return may add up to, however well the two agree.
    pub floor: f64,
    pub requested: f64,
}

/// Newton's corrections of a rough cycle with a derivative for each, until they are small; the last derivative and the crossing.
pub(super) fn derivative<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    rough: [f64; 2],
) -> Result<(Derivative, [f64; 2]), Failure> {
    let (mut from, mut tolerance) = (rough, DERIVATIVE_TOLERANCE);
    let mut derivative = Derivative::at(map, from, tolerance)?;
    for _ in 0..MOST_CORRECTIONS {
        let mapped = map.apply(&from, tolerance)?;
        let correction = derivative.correction(mapped.residual());
        let part = size(correction) / mapped.size();
        // A correction as large as the state leads to steady sliding or nowhere.
        if part.is_nan() || part >= 0.5 {
            return Err(Failure::Undecided { cycles: 0, change: part });
        }
        from = derivative.corrected(&from, correction);
        if part >= SMALL {
            derivative = Derivative::at(map, from, tolerance)?;
            continue;
        }
        if derivative.least_neutrality() > RESOLVED {
            return Ok((derivative, from));
        }
        let away = derivative.neutrality();
        tolerance *= FINER;
        if tolerance < TIGHTEST_DERIVATIVE {
            return Err(Failure::Undecided { cycles: 0, change: away });
        }
        let finer = Derivative::at(map, from, tolerance)?.confirmed_by(&derivative);
        let agree = (finer.neutrality() - away).abs() < 0.5 * away.abs();
        derivative = finer;
        if agree {
            return Ok((derivative, from));
        }
    }
    Err(Failure::Undecided { cycles: 0, change: derivative.neutrality() })
}

/// Newton's iteration on the return map from a rough cycle; none when it does not converge.
pub(super) fn refine<R: Scalar, M: Stepper<R> + Clone>(
    map: &mut ReturnMap<'_, R, M>,
    derivative: &Derivative,
    rough: [R; 2],
    accuracy: Accuracy,
) -> Result<Option<Refined<R>>, Failure> {
    let Accuracy { coarse, fine, requested, .. } = accuracy;
    let Some((coarse, rate)) = approach(map, derivative, rough, coarse, (requested, 0.5))? else {
        return Ok(None);
    };
    let first = map.apply(&coarse.from, fine)?;
    // The returns err alike from crossings as close as these, so one pair from the same crossing tells for all.
    let differences = Observables::differences(&first.orbit, &coarse.orbit);
    let image_difference: [f64; 2] =
        std::array::from_fn(|i| (first.image[i].clone() - &coarse.image[i]).to_f64());
    // The derivative is the same, and so is what a correction leaves.
    let Some((mapped, rate)) = approach(map, derivative, first.from.clone(), fine, (requested, rate))? else {
        return Ok(None);
    };
    let correction = derivative.correction(mapped.residual());
    let left = derivative.moved(correction).map(|change| change.abs() / (1.0 - rate));
    let gains = derivative.moved([1.0; 2]);
    let of_return = return_errors(differences, &mapped.orbit, gains, accuracy.floor);
    let (units, shown) = (rounding(&mapped), rounding_shown(&mapped, gains));
    let displaced = derivative.worst(image_difference.map(|d| OF_DIFFERENCE * d), units);
    let errors = with_inertia(left + of_return + displaced + shown, &mapped.orbit, map.model.groups());
    let distance = correction.iter().fold(0.0f64, |size, c| size.max(c.abs())) / mapped.size();
    Ok(Some(Refined { mapped, errors, distance, measured_over: derivative.width }))
}

/// Corrects the crossing until the way left shows in no observable, or shrinks no more; with the rate at which it shrank. The way left may
/// be a tenth of the requested error. `rate` is the least at which the way is taken to shrink.
fn approach<R: Scalar, M: Stepper<R> + Clone>(
    map: &mut ReturnMap<'_, R, M>,
    derivative: &Derivative,
    mut from: [R; 2],
    local_tolerance: f64,
    (requested, mut rate): (f64, f64),
) -> Result<Option<(MappedReturn<R>, f64)>, Failure> {
    let (mut last, mut before) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..MOST_CORRECTIONS {
        let mapped = map.apply(&from, local_tolerance)?;
        let correction = derivative.correction(mapped.residual());
        let change = derivative.moved(correction);
        let size = correction.iter().fold(0.0f64, |size, c| size.max(c.abs()));
        if !size.is_finite() || size > mapped.size() {
            return Ok(None);
        }
        if last.is_finite() {
            // Away from where the derivative was taken the rate still grows.
            let ratio = size / last;
            rate = (ratio + (ratio - before).max(0.0)).clamp(rate, 0.9);
            before = ratio;
        }
        let noise = derivative.correction([rounding(&mapped); 2]);
        let resolved = size <= noise[0].abs().max(noise[1].abs());
        if change.map(|part| part.abs()).peak_or_duration() <= 0.1 * requested || resolved {
            return Ok(Some((mapped, rate)));
        }
        // The map has steps of the size of its errors; nearer than that no correction leads.
        if size > 0.5 * last {
            return Ok(Some((mapped, rate)));
        }
        last = size;
        from = derivative.corrected(&mapped.from, correction);
    }
    Ok(None)
}

/// How far two returns from one crossing may end apart, over the looser one's tolerance.
const RETURN_ERROR_IN_TOLERANCES: f64 = 0.5;

/// Returns from a rough cycle until one closes.
const MOST_RETURNS: usize = 30;

/// Follows the map where it contracts fast; none when it does not.
///
/// The reported return begins where the one before ended. When its error at the finer tolerance is at most half as large and the state comes at
/// least twice as near in a return, then the difference of the two is more than the error of the second.
pub(super) fn follow<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    rough: &Cycle<f64>,
    rough_tolerance: f64,
    accuracy: Accuracy,
) -> Result<Option<Refined<f64>>, Failure> {
    let Spread { part, shrunk, gains } = spread(map, rough, rough_tolerance)?;
    if shrunk > SLOW {
        return Ok(None);
    }
    let section = |state: &State<f64>| [state[1], state[2]];
    let (mut orbit, mut at) = (rough.orbit.clone(), rough_tolerance);
    let mut crossing = section(&orbit.end);
    let mut change = size(difference(crossing, section(&rough.from))) / size(crossing);
    let mut carried: Option<Observables<f64>> = None;
    for _ in 0..MOST_RETURNS {
        let ready = at <= accuracy.coarse && SLOW * change <= accuracy.requested;
        let tolerance = if ready {
            accuracy.fine
        } else {
            libm::cbrt(libm::pow(0.01 * change, 2.0)).min(rough_tolerance).max(accuracy.coarse)
        };
        let mapped = map.apply(&crossing, tolerance)?;
        let left = size(mapped.residual()) / mapped.size();
        // Beyond the errors of the two returns a deviation that stays belongs to a slow direction.
        if left > 0.5 * change && left > RETURN_ERROR_IN_TOLERANCES * at {
            return Ok(None);
        }
        if ready {
            let differences = Observables::differences(&mapped.orbit, &orbit);
            let of_return = return_errors(differences, &mapped.orbit, gains, accuracy.floor);
            let units = rounding_shown(&mapped, gains);
            // The fixed points of the two maps differ as well, and this return began on the coarser one's.
            let way = size(mapped.residual()) / (1.0 - SLOW);
            let errors =
                of_return + carried.unwrap_or(Observables::all(0.0)) + gains.map(|gain| gain * way) + units;
            let errors = with_inertia(errors, &mapped.orbit, map.model.groups());
            if errors.peak_or_duration() <= accuracy.requested || carried.is_some() {
                return Ok(Some(Refined { mapped, errors, distance: left, measured_over: part }));
            }
            // The next return is compared with one that errs like itself: a third of what this pair showed stays.
            carried = Some(of_return.map(|error| error / 3.0));
        }
        (crossing, orbit, change, at) = (mapped.image, mapped.orbit, left, tolerance);
    }
    Ok(None)
}

/// What became of a deviation from a cycle's crossing after one return.
struct Spread {
    /// Its size as a part of the crossing.
    part: f64,
    /// What is left of it, as a part of it.
    shrunk: f64,
    /// How much of it is seen.
    gains: Observables<f64>,
}

/// By how much a cycle shrinks a deviation from its crossing, in a direction that nothing distinguishes, and how much of it is seen.
///
/// The approach of a trajectory does not tell: what is left of it may lie along a direction in which a return changes next to nothing.
fn spread<M: Stepper<f64> + Clone>(
    map: &mut ReturnMap<'_, f64, M>,
    cycle: &Cycle<f64>,
    local_tolerance: f64,
) -> Result<Spread, Failure> {
    let from = [cycle.from[1], cycle.from[2]];
    let effect_ratio = map.model.groups().effect_ratio;
    let part = (DEVIATION_IN_TOLERANCES * local_tolerance / size(from)).clamp(LEAST_DEVIATION, DEVIATION);
    let by = [part * effect_ratio * from[0], part * map.model.imbalance(&cycle.from)];
    let moved = shifted(&from, by, effect_ratio);
    let mapped = map.apply(&moved, local_tolerance)?;
    let deviation = size(difference(moved, from));
    let shrunk = size(difference(mapped.image, [cycle.orbit.end[1], cycle.orbit.end[2]])) / deviation;
    let gains = Observables::differences(&mapped.orbit, &cycle.orbit).map(|change| change.abs() / deviation);
    Ok(Spread { part, shrunk, gains })
}
