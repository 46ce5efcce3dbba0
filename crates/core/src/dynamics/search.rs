//! The search for a long-term behaviour whose stated errors meet the request.
//!
//! A rough run follows the trajectory to its limit cycle; [`refine`](super::refine) then brings one cycle to its accuracy with few returns. A decay is run
//! twice from the start, at two tolerances. A result that misses the requested accuracy is computed anew, tighter, from the cycle already
//! known; where f64 allows no tighter run, Newton's iteration goes on in double-double. When that does not do either, the
//! answer is a failure that says what was reached.

use super::barely_stops::{Confirmed, confirm, may_stop_or_not};
use super::deviations::{oscillation, oscillation_of_small_deviations};
use super::history::size;
use super::integrator::{Control, Integrator, Work};
use super::long_term::{Cycle, LongTerm, PermittedDistance, SLOW, long_term_within};
use super::observables::Observables;
use super::outcome::{Errors, Outcome, extremes, peak_and_period};
use super::refine::{Accuracy, Refined, derivative, follow, refine};
use super::return_errors::{OF_DIFFERENCE, OF_LARGEST};
use super::return_map::{Derivative, ReturnMap};
use super::stepper::Stepper;
use super::{Decay, Failure, Model, Options, Radau, Return};
use crate::friction::Groups;
use crate::number::{Dd, Rational};

/// The tightest local tolerance in f64.
const TIGHTEST: f64 = 2e-13;

/// The tolerance of the finer of two runs over that of the coarser.
pub(super) const FINER: f64 = 0.01;

/// The tolerances of an attempt over those of one that came out larger than requested; [`FINER`] where it decided nothing.
const TIGHTER: f64 = 0.1;

/// The requested error from which on a run that is not cut short comes no less near to its cycle: a slow decay changes by as little in a return.
const LOOSEST_FOLLOWED: f64 = 1e-3;

/// Crossings from which Newton's iteration is tried.
const MOST_CROSSINGS: usize = 3;

/// How near to a slowly contracting cycle the rough run has to come before Newton's iteration takes over.
pub(super) const NEWTON_FROM: f64 = 1e-2;

/// The same for one that contracts fast, over the requested error: true returns follow, and their errors are measured.
pub(super) const FOLLOW_FROM: f64 = 0.3;

/// Change of a second return over that of the first, when the cycle closes in one.
const CLOSED: f64 = 0.3;

/// Local tolerances of one attempt.
#[derive(Debug, Clone, Copy)]
struct Levels {
    /// Of the run that finds the long-term behaviour.
    rough: f64,
    /// Of the two returns that are compared.
    coarse: f64,
    /// The tightest in use.
    tightest: f64,
}

impl Levels {
    /// For the method of order 9: its global error is about the 3/2nd power of the local tolerance.
    fn for_error(requested: f64) -> Self {
        let coarse = (30.0 * requested).clamp(TIGHTEST / FINER, 1e-3);
        Self { rough: coarse.max(1e-4), coarse, tightest: TIGHTEST / FINER }
    }

    fn tighter(self, by: f64) -> Option<Self> {
        let by = by.max(self.tightest / self.coarse);
        let finer = Self { rough: by * self.rough, coarse: by * self.coarse, ..self };
        (by <= 1.01 * TIGHTER).then_some(finer)
    }
}

/// Leading multiplier, but for the error of the differences, from which on a cycle repels.
const REPELLING: f64 = 1.0 + 1e-7;

/// What a search with a cheaper method leaves to the next one.
#[derive(Debug, Default)]
pub(super) struct Leftover {
    /// The cycle that it found, and the local tolerance that it was found with.
    pub known: Option<(Cycle<f64>, f64)>,
    /// What it cost.
    pub work: Work,
}

/// A search with one method.
pub(super) struct Search<'m, 'o, M> {
    model: &'m Model<f64>,
    /// The same with the groups as they are: next to K = K_c and to double roots, results magnify what rounding changes in them.
    unrounded: Model<Dd>,
    method: M,
    options: &'o Options,
    levels: Levels,
    /// The last cycle found, and the local tolerance that it was found with.
    known: Option<(Cycle<f64>, f64)>,
    work: Work,
}

/// A long-term behaviour with its errors.
type LongTermFound = (LongTerm<f64>, Errors);

impl<'m, 'o, M: Stepper<f64> + Clone> Search<'m, 'o, M> {
    /// A search that goes on from what a cheaper method left.
    pub fn new(
        model: &'m Model<f64>,
        exact: &Groups<Rational>,
        method: M,
        options: &'o Options,
        Leftover { known, work }: Leftover,
    ) -> Self {
        let (unrounded, levels) = (model.in_double_double(exact), Levels::for_error(options.tolerance));
        Self { model, unrounded, method, options, levels, known, work }
    }

    /// Tightens until the stated errors of peak and period are no larger than requested.
    pub fn answer(mut self) -> Result<Outcome, Failure> {
        let requested = self.options.tolerance;
        let (mut reached, mut last_failure) = (f64::INFINITY, None);
        loop {
            let mut by = TIGHTER;
            match self.attempt() {
                Ok((long_term, errors)) => {
                    let local_tolerance = FINER * self.levels.coarse;
                    let outcome = Outcome::new(self.model, long_term, errors, self.work, local_tolerance);
                    reached = outcome.largest_error().min(reached);
                    if outcome.largest_error() <= requested {
                        return Ok(outcome);
                    }
                }
                Err(failure @ (Failure::Undecided { .. } | Failure::StepVanished { .. })) => {
                    last_failure = Some(failure);
                    self.known = None;
                    by = FINER;
                }
                Err(failure) => return Err(failure),
            }
            let Some(levels) = self.levels.tighter(by) else { break };
            self.levels = levels;
        }
        let missed = Failure::UnreachableTolerance { requested, reached };
        Err(last_failure.filter(|_| reached.is_infinite()).unwrap_or(missed))
    }

    fn attempt(&mut self) -> Result<LongTermFound, Failure> {
        if let Some((cycle, tolerance)) = self.known.clone() {
            match self.refined(cycle, tolerance) {
                // A cycle that another method found need not be one of this method's map.
                Err(Failure::Undecided { .. } | Failure::StepVanished { .. })
                    if tolerance > self.levels.coarse => {}
                found => return found,
            }
        }
        let rough = self.levels.rough;
        let fast = FOLLOW_FROM * self.options.tolerance.max(1e-2);
        let permitted = PermittedDistance { fast, slow: NEWTON_FROM };
        match self.run(rough, permitted)? {
            LongTerm::Cycle(cycle) => match self.refined(cycle, rough) {
                // A slow decay looks like the approach to a cycle that is not there: it is followed to its end.
                Err(Failure::Undecided { .. }) => self.followed(),
                found => found,
            },
            LongTerm::Decay(decay) if rough <= self.levels.coarse => self.decay(decay),
            LongTerm::Decay(_) => self.followed(),
        }
    }

    /// A run that is not cut short by Newton's iteration.
    fn followed(&mut self) -> Result<LongTermFound, Failure> {
        match self.long_term_at(self.levels.coarse)? {
            LongTerm::Decay(decay) => self.decay(decay),
            LongTerm::Cycle(cycle) => self.refined(cycle, self.levels.coarse),
        }
    }

    fn long_term_at(&mut self, local_tolerance: f64) -> Result<LongTerm<f64>, Failure> {
        let permitted =
            PermittedDistance { fast: 0.01 * self.options.tolerance.min(LOOSEST_FOLLOWED), slow: 0.0 };
        self.run(local_tolerance, permitted)
    }

    /// A run from the start.
    fn run(&mut self, local_tolerance: f64, permitted: PermittedDistance) -> Result<LongTerm<f64>, Failure> {
        let start = self.options.start.state(self.model, &libm::log(self.options.velocity_ratio));
        let control = Control { local_tolerance, most_steps: self.options.most_steps };
        let mut run = Integrator::new(self.model, self.method.clone(), start, control)?;
        let long_term = long_term_within(&mut run, permitted, self.options.most_returns);
        self.work += run.work();
        long_term
    }

    /// A decay, run again at a tenth of the tolerance.
    fn decay(&mut self, mut coarse: Decay<f64>) -> Result<LongTermFound, Failure> {
        let finer = FINER * self.levels.coarse;
        let LongTerm::Decay(mut fine) = self.long_term_at(finer)? else {
            return Err(Failure::Undecided { cycles: 0, change: 1.0 });
        };
        // A pair that dies faster than the real mode leaves no clear trace in long-term behaviour, but it is there.
        if coarse.oscillation.is_none() || fine.oscillation.is_none() {
            let [wide, narrow] = [(finer / FINER).min(1e-6), finer.min(FINER * 1e-6)];
            coarse.oscillation = oscillation_of_small_deviations(self.model, wide)?;
            fine.oscillation = oscillation_of_small_deviations(self.model, narrow)?;
            let permitted = 0.5 * self.options.tolerance;
            let unequal = match (coarse.oscillation, fine.oscillation) {
                (Some(a), Some(b)) => OF_DIFFERENCE * libm::log(a.period / b.period).abs() > permitted,
                (a, b) => a != b,
            };
            // Next to a double root the propagator's rounding errors are magnified.
            if unequal {
                let (unrounded, method) = (&self.unrounded, Radau::<Dd, 7>::new());
                coarse.oscillation = oscillation(unrounded, &method, FINER * FINER * wide)?;
                fine.oscillation = oscillation(unrounded, &method, FINER * FINER * narrow)?;
            }
        }
        let [coarse, fine] = [coarse, fine]
            .map(|decay| LongTerm::Decay(Decay { transient: decay.transient.and_steady_sliding(), ..decay }));
        let errors = decay_errors(&coarse, &fine, finer);
        Ok((fine, errors))
    }

    /// A cycle brought to its accuracy.
    fn refined(&mut self, found: Cycle<f64>, tolerance: f64) -> Result<LongTermFound, Failure> {
        let coarse = self.levels.coarse;
        let fine = FINER * coarse;
        let accuracy = Accuracy { coarse, fine, floor: fine, requested: self.options.tolerance };
        let (found, tolerance) = self.with_fewest_returns(found, tolerance, fine)?;
        let returns = found.returns_per_cycle;
        let mut map = ReturnMap::new(self.model, self.method.clone(), returns, self.options.most_steps);
        let mut refined = None;
        let mut contraction = found.contraction.filter(|&known| known < 1.0);
        if contraction.is_none_or(|known| known < SLOW) {
            refined = follow(&mut map, &found, tolerance, accuracy)?;
        }
        let mut crossing = [found.orbit.end[1], found.orbit.end[2]];
        for _ in 0..MOST_CROSSINGS {
            if refined.is_none() {
                let (there, rough) = derivative(&mut map, crossing)?;
                contraction = Some(there.multiplier());
                refined = self.by_newton(&mut map, &there, rough, accuracy)?;
                if there.multiplier() > REPELLING
                    && let Some(cycle) = &refined
                    && derivative(&mut map, cycle.mapped.from)?.0.multiplier() > REPELLING
                {
                    // Newton's iteration finds cycles that no run ends on, too.
                    refined = None;
                    break;
                }
            }
            let Some(cycle) = refined.as_ref().filter(|&cycle| may_stop_or_not(cycle, &map)) else { break };
            match confirm(&mut map, cycle)? {
                Confirmed::Cycle => break,
                Confirmed::Elsewhere(other) => (crossing, refined) = (other, None),
                Confirmed::Nowhere => {
                    refined = None;
                    break;
                }
            }
        }
        self.work += map.work;
        let Some(refined) = refined else {
            return Err(Failure::Undecided { cycles: 0, change: found.distance });
        };
        let (cycle, errors) = refined.cycle(returns, contraction);
        self.known = Some((cycle.clone(), fine));
        Ok((LongTerm::Cycle(cycle), errors))
    }

    /// A cycle of several returns that the finer map closes in fewer: then the errors of the rough run took it from one return to the next.
    fn with_fewest_returns(
        &mut self,
        found: Cycle<f64>,
        tolerance: f64,
        fine: f64,
    ) -> Result<(Cycle<f64>, f64), Failure> {
        let several = found.returns_per_cycle;
        for returns in (1..several).filter(|returns| several.is_multiple_of(*returns)) {
            let mut map = ReturnMap::new(self.model, self.method.clone(), returns, self.options.most_steps);
            let first = map.apply(&[found.orbit.end[1], found.orbit.end[2]], fine)?;
            let second = map.apply(&first.image, fine)?;
            self.work += map.work;
            let [before, after] = [&first, &second].map(|mapped| size(mapped.residual()));
            if after < CLOSED * before {
                let from = [0.0, second.from[0], second.from[1]];
                let (distance, contraction) = (after / second.size(), Some(after / before));
                let orbit = second.orbit;
                let cycle = Cycle { orbit, returns_per_cycle: returns, contraction, distance, from };
                return Ok((cycle, fine));
            }
        }
        Ok((found, tolerance))
    }

    /// Newton's iteration, in double-double where f64 allows no tighter run: a fixed point may magnify the rounding errors of f64.
    fn by_newton(
        &self,
        map: &mut ReturnMap<'m, f64, M>,
        derivative: &Derivative,
        rough: [f64; 2],
        accuracy: Accuracy,
    ) -> Result<Option<Refined<f64>>, Failure> {
        let refined = refine(map, derivative, rough, accuracy)?;
        let satisfies = |found: &Refined<f64>| found.errors.peak_or_duration() <= 0.9 * accuracy.requested;
        if refined.as_ref().is_some_and(satisfies) || self.levels.tighter(TIGHTER).is_some() {
            return Ok(refined);
        }
        let from = refined.as_ref().map_or(rough, |refined| refined.mapped.from);
        let mut map = ReturnMap::new(&self.unrounded, Radau::<Dd, 7>::new(), map.returns, map.most_steps);
        let accuracy = Accuracy { coarse: 1e-14, fine: 1e-16, floor: 1e-16, ..accuracy };
        let more = refine(&mut map, derivative, from.map(Dd::from), accuracy)?;
        Ok(more.map(Refined::rounded).or(refined))
    }
}

/// Errors of a decay from two runs, a factor ten apart in tolerance.
pub(super) fn decay_errors(coarse: &LongTerm<f64>, fine: &LongTerm<f64>, floor: f64) -> Errors {
    let (coarse_peak, coarse_period) = peak_and_period(coarse);
    let (peak, period) = peak_and_period(fine);
    let (rough, orbit): (&Return<f64>, &Return<f64>) = (extremes(coarse), extremes(fine));
    let difference = |a: f64, b: f64| (a - b).abs() / b.abs().max(1.0);
    let of_period = match (coarse_period, period) {
        (Some(a), Some(b)) => libm::log(a / b).abs(),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    };
    let differences = Observables {
        log_peak: difference(coarse_peak, peak),
        log_duration: of_period,
        log_trough: difference(rough.trough, orbit.trough),
        highest_stress: difference(rough.highest_stress, orbit.highest_stress),
        lowest_stress: difference(rough.lowest_stress, orbit.lowest_stress),
    };
    let largest = differences.largest();
    let units = 100.0 * f64::EPSILON;
    let error = |difference: f64, scale: f64| {
        (OF_DIFFERENCE * difference + OF_LARGEST * largest + units) * f64::abs(scale).max(1.0) + floor
    };
    Errors {
        peak: error(differences.log_peak, peak),
        period: period.map(|_| error(differences.log_duration, 1.0)),
        trough: error(differences.log_trough, orbit.trough),
        drop: error(differences.highest_stress, orbit.highest_stress)
            + error(differences.lowest_stress, orbit.lowest_stress),
    }
}
