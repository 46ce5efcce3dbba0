//! Decays in which the forces balance slowly: the transient, the oscillation of small deviations, and nothing between them.
//!
//! A decay shows its extremes in its first returns and its oscillation in the limit of small deviations. What lies between them
//! is not reported, so it is not followed return by return: it only has to be shown that the trajectory gets there. Three computations do this:
//!
//! 1. The transient, until three crossings lie on a line and returns only repeat at a smaller size, or until it is near steady sliding.
//! 2. The propagator of small deviations, whose pair and real mode must both die out.
//! 3. Returns at falling amplitudes A of V/V_l − 1, unless the transient came near enough by itself. Their rates r(A) = d ln A/dt are compared with
//!    the rate r_0 of small deviations. The tests end where r(A) = r(0) + c A² through the last two gives r(0) = r_0.
//!
//! In the normal form r(A)/r_0 = 1 + aX + bX² with X = (A/A_1)² ≤ 1, amplitudes A_1 and A_2 = f A_1 give r(0)/r_0 = 1 − f²b. With f = 0.6 the
//! permitted difference of 0.2 means |b| ≤ 0.56. A cycle below A_1 is a zero of r there. With r(A_1)/r_0 > 0 there would be two zeros, which need b > 1.
//! The Taylor series follows what is nowhere stiff, Radau IIA what relaxes within a small part of a period.
//!
//! A pair that grows or dies by less in a return than f64 resolves (`slow_pair`) is known from eq 8, however fast the forces balance, and what a
//! return takes from the amplitude is the work of friction. Near K = K_c the tests end where the rates are those of the normal form. They then show a
//! decay, or a run that ends on the small cycle (`small_cycle`).
//!
//! The search decides every other trajectory: one whose forces balance fast, that has no pair, takes too many steps, or fails a test.

use super::deviations::{Modes, inertial_modes};
use super::history::History;
use super::integrator::{Control, Integrator, Work, tightest};
use super::long_term::LongTerm;
use super::outcome::Outcome;
use super::search::decay_errors;
use super::section_return::{FAINT, Return, ReturnEnd, return_above};
use super::slow_pair::{NearTransition, SlowPair};
use super::small_cycle::{LOCAL_TOLERANCE, small_cycle};
use super::{Balance, Decay, Model, Options, Radau, State, Stepper, Taylor, friction_work};

/// The largest rate e^{−x}/η of the balance of forces at the start, in units of √(K/M).
const FASTEST_BALANCE: f64 = 100.0;

/// The largest such rate, and the largest rate V_l/D_c of the friction's state, for which the series takes less time than Radau IIA.
const BALANCE_OF_SERIES: f64 = 20.0;
const STATE_OF_SERIES: f64 = 60.0;

/// The second bound for a slow pair: the error of Radau IIA is in units of ζ, of which a vibration at η ≫ 1 has too many.
const STATE_OF_SLOW: f64 = 1e3;

/// Coefficients of the series.
const TERMS: usize = 20;

/// Most steps of one run: a trajectory that needs more of them sticks. The second bound is for a slow pair, which the search does not resolve.
const MOST_STEPS: u64 = 600;
const MOST_STEPS_OF_SLOW: u64 = 20_000;
/// Most returns until crossings lie on a line.
const MOST_RETURNS: usize = 60;
/// Size of a state that small deviations describe.
const NEAR: f64 = 1e-4;

/// Bounds of the coarser local tolerance.
const TIGHTEST: f64 = 1e-12;
const LOOSEST: f64 = 1e-3;

/// The part of the requested error that the rounding errors of ζ may take from the error of a step. Above it ζ is in units of its swing.
const LARGEST_ROUNDING: f64 = 0.01;

/// The most that `Route::units` may be.
const MOST_UNITS: f64 = 32.0;

/// The tolerance of the finer of two transients over that of the coarser.
const FINER: f64 = 0.01;

/// The tolerances of each attempt over those of the one before, and the number of attempts.
const TIGHTER: f64 = 0.1;
const ATTEMPTS: usize = 3;

/// Factor f between two amplitudes.
const SMALLER: f64 = 0.6;

/// The least part of the rate of small deviations at any amplitude.
const LEAST_PART: f64 = 0.3;

/// The largest amplitude A_1 from which the rate is extrapolated to zero, and the relative difference that is permitted there.
const LARGEST: f64 = 0.95;
const AGREEMENT: f64 = 0.2;

/// Most amplitudes.
const MOST_AMPLITUDES: usize = 20;

/// Local tolerance of returns whose rates are measured over the part by which small deviations shrink in a period; the loosest.
const OF_RATE: f64 = 1e-2;
const LOOSEST_OF_RATE: f64 = 1e-4;

/// Relative difference between two rates of small deviations that are known.
const KNOWN: f64 = 1e-3;

/// The least relative change of amplitude in a return that is measured: ten local tolerances. The work of friction over the energy of the
/// oscillation is measured to a part 1/(1 + η) of it.
const LEAST_CHANGE: f64 = 1e-11;

/// Relative difference between the changes of amplitude of two returns from which on nothing but the amplitude changes.
const EVEN: f64 = 0.1;

/// A method and its tolerances.
struct Route<M> {
    method: M,
    /// Local tolerance of the coarser transient.
    coarse: f64,
    /// What the steps of a transient may add up to, in local tolerances.
    bad_steps: f64,
    /// The factor by which ζ may err more than ln V: an oscillation at √(K/M) moves it √(κη) times as far.
    units: f64,
    /// Local tolerances of small deviations.
    of_deviations: [f64; 2],
}

/// The outcome of a decay whose forces balance slowly; none when the search has to decide.
pub(super) fn smooth_decay(model: &Model<f64>, options: &Options) -> Option<Outcome> {
    let start = options.start.state(model, &libm::log(options.velocity_ratio));
    let balance = balance_rate(model, &start);
    let is_slow = balance > 0.0 && balance <= FASTEST_BALANCE && model.balance == Balance::Inertial;
    is_slow.then(|| by_cheapest_route(model, options, None)).flatten()
}

/// The outcome of a run whose small deviations grow or die slowly: a decay, or a small cycle near K = K_c. Its errors may be larger than requested.
/// None when the search has to decide.
pub(super) fn slow_oscillation(model: &Model<f64>, options: &Options, pair: SlowPair) -> Option<Outcome> {
    by_cheapest_route(model, options, Some(pair))
}

/// The rate e^{−x}/η of the balance of forces, in units of √(K/M).
fn balance_rate(model: &Model<f64>, state: &State<f64>) -> f64 {
    libm::exp(-state[0]) / model.stress_swing()
}

fn by_cheapest_route(model: &Model<f64>, options: &Options, slow: Option<SlowPair>) -> Option<Outcome> {
    let groups = model.groups();
    let start = options.start.state(model, &libm::log(options.velocity_ratio));
    let work = Work::default();
    let state = (groups.inertial_parameter / groups.stiffness_group).sqrt();
    let oscillation_units = model.stress_swing().max(1.0);
    let fastest = if slow.is_some() { STATE_OF_SLOW } else { STATE_OF_SERIES };
    if balance_rate(model, &start) <= BALANCE_OF_SERIES && state <= fastest {
        let method = Taylor::<f64, TERMS>::new();
        let is_rounded = tightest::<f64>(oscillation_units) > LARGEST_ROUNDING * options.tolerance;
        let method =
            if is_rounded || slow.is_some() { method.with_stress_unit(oscillation_units) } else { method };
        let coarse = (0.5 * options.tolerance).clamp(TIGHTEST, LOOSEST);
        let route = Route { method, coarse, bad_steps: 20.0, units: 1.0, of_deviations: [1e-10, 1e-13] };
        SmoothDecay { model, options, start, route, slow, by_work: slow.is_some(), work }.outcome()
    } else {
        let method = Radau::<f64, 5>::new();
        let (units, loose) =
            (oscillation_units.min(MOST_UNITS), (1e3 * options.tolerance).clamp(1e-10, 1e-5));
        let coarse = (units * 35.0 * options.tolerance).clamp(TIGHTEST, LOOSEST);
        let route = Route { method, coarse, bad_steps: 0.5, units, of_deviations: [loose, FINER * loose] };
        SmoothDecay { model, options, start, route, slow, by_work: false, work }.outcome()
    }
}

/// A decay by one method.
struct SmoothDecay<'m, 'o, M> {
    model: &'m Model<f64>,
    options: &'o Options,
    start: State<f64>,
    route: Route<M>,
    /// Known where returns do not show how small deviations grow or die.
    slow: Option<SlowPair>,
    /// Whether changes of amplitude are taken from the work of friction.
    by_work: bool,
    work: Work,
}

/// A transient.
struct Transient {
    /// All returns as one, and how many of them contain the extremes.
    orbit: Return<f64>,
    returns: usize,
    /// The last two crossings; none near steady sliding.
    last: Option<Shrinking>,
}

/// Two successive crossings.
#[derive(Clone, Copy)]
struct Shrinking {
    /// The amplitudes of V/V_l − 1.
    from: f64,
    to: f64,
    /// The time between them, and the two.
    duration: f64,
    start: State<f64>,
    end: State<f64>,
}

impl<'m, M: Stepper<f64> + Clone> SmoothDecay<'m, '_, M> {
    fn outcome(mut self) -> Option<Outcome> {
        if let Some(pair) = self.slow
            && let Some(near) = pair.near_transition
            && near.excess < 0.0
        {
            return self.small_cycle(&pair, near);
        }
        let modes = self.modes()?;
        let requested = self.options.tolerance;
        let Route { units, mut coarse, .. } = self.route;
        // Both runs may have steps no tighter than the rounding errors of ζ permit.
        let least = 0.5 * tightest::<f64>(self.model.stress_swing() / self.route.method.stress_unit());
        let mut decays = false;
        for _ in 0..ATTEMPTS {
            let fine = FINER * coarse;
            let rough = self.transient(coarse, &modes[1])?;
            decays = decays || self.ends_in(&modes[1], &rough, coarse);
            if !decays {
                return None;
            }
            let exact = self.returns(fine, rough.returns)?;
            let [rough, exact] = [(rough.orbit, modes[0]), (exact, modes[1])].map(|(transient, seen)| {
                let transient = transient.and_steady_sliding();
                LongTerm::Decay(Decay { transient, oscillation: Some(seen.oscillation), rate: None })
            });
            let errors = decay_errors(&rough, &exact, self.route.bad_steps * fine.max(least) / units);
            let outcome = Outcome::new(self.model, exact, errors, self.work, fine);
            if outcome.largest_error() <= requested {
                return Some(outcome);
            }
            coarse *= TIGHTER;
        }
        None
    }

    /// The small cycle, when the run ends on it.
    fn small_cycle(mut self, pair: &SlowPair, near: NearTransition) -> Option<Outcome> {
        let transient = self.transient(self.route.coarse, &pair.modes)?;
        let ends_there = transient.last.is_some() && self.ends_in(&pair.modes, &transient, self.route.coarse);
        if !ends_there {
            return None;
        }
        let (cycle, errors, work) = small_cycle(self.model, &near, &pair.modes.oscillation)?;
        self.work += work;
        Some(Outcome::new(self.model, LongTerm::Cycle(cycle), errors, self.work, LOCAL_TOLERANCE))
    }

    /// The modes of small deviations at two tolerances, when none of them grows.
    fn modes(&mut self) -> Option<[Modes; 2]> {
        if let Some(SlowPair { modes, .. }) = self.slow {
            return (modes.oscillation.growth_rate <= 0.0).then_some([modes; 2]);
        }
        let mut seen = |local_tolerance| {
            let modes = inertial_modes(self.model, &self.route.method, local_tolerance).ok()??;
            self.work += modes.work;
            (modes.oscillation.growth_rate < 0.0 && modes.real_rate < 0.0).then_some(modes)
        };
        let [loose, tight] = self.route.of_deviations;
        let [rough, exact] = [seen(loose)?, seen(tight)?];
        let [a, b] = [rough, exact].map(|modes| modes.oscillation.growth_rate);
        ((a - b).abs() <= KNOWN * b.abs()).then_some([rough, exact])
    }

    fn run(&self, start: State<f64>, local_tolerance: f64) -> Option<Integrator<'m, f64, M>> {
        let most_steps = if self.slow.is_some() { MOST_STEPS_OF_SLOW } else { MOST_STEPS };
        let control = Control { local_tolerance, most_steps: self.options.most_steps.min(most_steps) };
        Integrator::new(self.model, self.route.method.clone(), start, control).ok()
    }

    /// The returns until three crossings lie on a line or the state is near steady sliding.
    fn transient(&mut self, local_tolerance: f64, modes: &Modes) -> Option<Transient> {
        let is_led_by_pair = modes.real_rate < modes.oscillation.growth_rate;
        let mut run = self.run(self.start, local_tolerance)?;
        let mut history = History::new();
        let (mut so_far, mut returns, mut amplitude): (Option<Return<f64>>, _, _) = (None, 0, 0.0);
        for done in 1..=MOST_RETURNS {
            let start = *run.state();
            let (next, end) = return_above(&mut run, NEAR).ok()?;
            let seen = so_far.as_ref().map(extremes);
            let orbit = so_far.map_or_else(|| next.clone(), |so_far| so_far.joined(next.clone()));
            if seen != Some(extremes(&orbit)) {
                returns = done;
            }
            let is_near = end == ReturnEnd::AtRest;
            let from = std::mem::replace(&mut amplitude, self.amplitude(run.state(), modes));
            let last = Shrinking { from, to: amplitude, duration: next.duration, start, end: *run.state() };
            history.returns.push(next);
            if is_near || is_led_by_pair && (repeats(&history) || self.by_work && self.falls_evenly(&history))
            {
                self.work += run.work();
                // A slider that no longer crosses V = V_l has its extremes behind it, or the search decides.
                let is_complete = !(is_near && returns == done);
                return is_complete.then_some(Transient { orbit, returns, last: (!is_near).then_some(last) });
            }
            so_far = Some(orbit);
        }
        None
    }

    /// The first returns as one.
    fn returns(&mut self, local_tolerance: f64, returns: usize) -> Option<Return<f64>> {
        let mut run = self.run(self.start, local_tolerance)?;
        let mut whole = crossing(&mut run)?;
        for _ in 1..returns {
            whole = whole.joined(crossing(&mut run)?);
        }
        self.work += run.work();
        Some(whole)
    }

    /// Whether the last two returns took the same small part of the amplitude, so that each is inside the one before.
    fn falls_evenly(&mut self, history: &History<f64>) -> bool {
        let [.., before, last] = history.returns.as_slice() else { return false };
        let (Some(there), Some(here)) = (history.back(2), history.back(1)) else { return false };
        let mut fall = |[y, zeta]: [f64; 2], duration| self.log_ratio_by_work(&[0.0, y, zeta], duration);
        let (Some(first), Some(second)) = (fall(there, before.duration), fall(here, last.duration)) else {
            return false;
        };
        first < 0.0 && second < 0.0 && (first - second).abs() <= EVEN * second.abs()
    }

    fn log_ratio_by_work(&mut self, crossing: &State<f64>, duration: f64) -> Option<f64> {
        let (log_ratio, work) = friction_work::log_ratio(self.model, crossing, duration).ok()?;
        self.work += work;
        Some(log_ratio)
    }

    /// The logarithm of what a return leaves of the amplitude.
    fn log_ratio(&mut self, shrinking: &Shrinking) -> Option<f64> {
        match self.slow {
            None => Some(libm::log(shrinking.to / shrinking.from)),
            Some(_) if self.by_work => self.log_ratio_by_work(&shrinking.start, shrinking.duration),
            // Where η is small the imbalance at a crossing has fewer digits than the stress.
            Some(_) => Some(libm::log(shrinking.end[2] / shrinking.start[2])),
        }
    }

    /// Whether a transient leads to the oscillation of small deviations.
    fn ends_in(&mut self, modes: &Modes, transient: &Transient, local_tolerance: f64) -> bool {
        let near_transition = self.slow.and_then(|pair| pair.near_transition);
        let Some(mut shrinking) = transient.last else {
            // Near K = K_c a state this small may still lie outside an unstable cycle.
            return near_transition.is_none_or(|near| near.attracts());
        };
        let slow = modes.oscillation;
        let inertia = if self.by_work { self.model.groups().inertial_parameter } else { 0.0 };
        let least_change = LEAST_CHANGE / (1.0 + inertia);
        let permitted =
            (-OF_RATE * self.route.units * slow.growth_rate * slow.period).clamp(TIGHTEST, LOOSEST_OF_RATE);
        let mut before: Option<[f64; 2]> = None;
        for _ in 0..MOST_AMPLITUDES {
            if before.is_some() || local_tolerance > permitted {
                let factor = (SMALLER * shrinking.from / shrinking.to).min(1.0);
                let start = shrinking.end.map(|component| factor * component);
                let Some(measured) = self.two_returns(start, permitted, modes) else { return false };
                shrinking = measured;
            }
            let amplitude = shrinking.from;
            let Some(log_ratio) = self.log_ratio(&shrinking) else { return false };
            if let Some(near) = near_transition {
                if log_ratio.is_nan() || log_ratio > -least_change {
                    return false;
                }
                let here = [amplitude, log_ratio / shrinking.duration];
                if before.is_some_and(|before| near.describes(slow.growth_rate, before, here)) {
                    return true;
                }
                before = Some(here);
                continue;
            }
            let part = log_ratio / (shrinking.duration * slow.growth_rate);
            if part.is_nan() || part < LEAST_PART {
                return false;
            }
            if let Some([wide, part_there]) = before
                && wide < LARGEST
            {
                let [at_wide, here] = [wide, amplitude].map(|amplitude| amplitude * amplitude);
                let at_zero = (part * at_wide - part_there * here) / (at_wide - here);
                if (at_zero - 1.0).abs() < AGREEMENT {
                    return true;
                }
            }
            before = Some([amplitude, part]);
        }
        false
    }

    /// The second return from a state: the first one leads back to the slow direction.
    fn two_returns(&mut self, start: State<f64>, local_tolerance: f64, modes: &Modes) -> Option<Shrinking> {
        let mut run = self.run(start, local_tolerance)?;
        crossing(&mut run)?;
        let (from, start) = (self.amplitude(run.state(), modes), *run.state());
        let duration = crossing(&mut run)?.duration;
        self.work += run.work();
        Some(Shrinking { from, to: self.amplitude(run.state(), modes), duration, start, end: *run.state() })
    }

    /// The amplitude of V/V_l − 1 at a crossing, where ηV' = ζ − φ.
    fn amplitude(&self, crossing: &State<f64>, modes: &Modes) -> f64 {
        let acceleration = self.model.imbalance(crossing) / self.model.groups().inertial_parameter;
        acceleration * modes.oscillation.period / std::f64::consts::TAU
    }
}

/// The next return, when it ends on a crossing.
fn crossing<M: Stepper<f64> + Clone>(run: &mut Integrator<'_, f64, M>) -> Option<Return<f64>> {
    let (orbit, end) = return_above(run, FAINT).ok()?;
    (end == ReturnEnd::Crossing).then_some(orbit)
}

const fn extremes(orbit: &Return<f64>) -> [f64; 4] {
    [orbit.peak, orbit.trough, orbit.highest_stress, orbit.lowest_stress]
}

/// Whether the last three crossings shrink along a line, and the last return inside the one before.
///
/// In the linear regime an extreme is a sum of two exponentials. Where it has begun to fall, it stays below what it was, or below steady sliding.
fn repeats(history: &History<f64>) -> bool {
    let [.., before, last] = history.returns.as_slice() else { return false };
    let is_inside = last.peak < before.peak
        && last.trough > before.trough
        && last.end[2] < before.end[2]
        && last.lowest_stress > before.lowest_stress;
    is_inside && history.slow_direction().is_some_and(|(multiplier, _)| (0.0..1.0).contains(&multiplier))
}
