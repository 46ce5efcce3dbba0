//! Long-term behaviour: a limit cycle, or decay to steady sliding, decided on the Poincaré section x = 0 (upward).
//!
//! Deep stick-slip is superattracting: it is reached in two or three returns. Near K = K_c a return changes the state by a part in
//! 10^4, so the returns are extrapolated along the slow direction (the secant step of a fixed-point iteration), each jump limited to a
//! part of the state and followed by returns of the true map; nothing is accepted on extrapolation alone.

use super::decay::{Decay, final_rate, measure_decay};
use super::history::{History, jump, returns_per_cycle, size};
use super::section_return::{Return, ReturnEnd, next_return};
use super::stepper::Stepper;
use super::{Failure, Integrator, Scalar, State};

/// Size of the state on the section below which the equations are linear to about this relative accuracy.
const LINEAR: f64 = 1e-7;

/// Returns between two jumps: one to return to the slow direction, three to measure it.
const RETURNS_BEFORE_JUMP: usize = 4;

/// The largest part of the state that one jump may change.
const LARGEST_JUMP: f64 = 0.3;

/// Relative changes of a return below this multiple of the local tolerance may be the integrator's errors rather than the map's.
const NOISE_IN_TOLERANCES: f64 = 0.01;

/// Relative changes of a return below this may be rounding errors of its steps.
const ROUNDING_OF_RETURNS: f64 = 1e-14;

/// The farthest from its cycle that a trajectory may be called periodic, when the integrator's errors hide the rest of the way.
const FARTHEST: f64 = 1e-3;

/// Contraction of a return assumed where none could be measured, because the returns closed at once.
const UNMEASURED: f64 = 0.5;

/// Changes of a return below this multiple of the local tolerance are the integrator's errors when they do not shrink.
const ERRATIC_IN_TOLERANCES: f64 = 0.3;

/// Returns in which such changes must shrink.
const MOST_ERRATIC_RETURNS: u32 = 40;

/// A return that leaves more than this part of a deviation contracts slowly.
pub(super) const SLOW: f64 = 0.3;

/// Returns since the change of a return last fell by a tenth, or the state by a half: one on its way to zero changes by the same part in every return.
struct Standstill {
    least: f64,
    least_amplitude: f64,
    returns: u32,
}

impl Standstill {
    const fn new() -> Self {
        Self { least: f64::INFINITY, least_amplitude: f64::INFINITY, returns: 0 }
    }

    /// Notes one change; true when the last many did not fall.
    fn lasts(&mut self, change: f64, amplitude: f64) -> bool {
        self.returns += 1;
        if change < 0.9 * self.least {
            (self.least, self.returns) = (change, 0);
        }
        if amplitude < 0.5 * self.least_amplitude {
            (self.least_amplitude, self.returns) = (amplitude, 0);
        }
        self.returns >= MOST_ERRATIC_RETURNS
    }
}

/// A limit cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle<R> {
    /// The whole cycle.
    pub orbit: Return<R>,
    /// Upward crossings of V = V_l in one cycle.
    pub returns_per_cycle: usize,
    /// Factor by which the last measurable deviation shrank in one return: the leading Floquet multiplier, an upper bound when superattracting.
    pub contraction: Option<f64>,
    /// Estimated relative distance between the cycle and the state with which the reported return began.
    pub distance: f64,
    /// The state with which the reported cycle began.
    pub from: State<R>,
}

/// Where a trajectory ends up.
#[derive(Debug, Clone, PartialEq)]
pub enum LongTerm<R> {
    /// On a limit cycle.
    Cycle(Cycle<R>),
    /// In steady sliding.
    Decay(Decay<R>),
}

/// Follows a run to its long-term behaviour; `target` is the permitted relative distance from the limit cycle.
///
/// # Errors
/// Those of the integrator, and [`Failure::Undecided`] after `most_returns`.
pub fn long_term_behaviour<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    target: f64,
    most_returns: u64,
) -> Result<LongTerm<R>, Failure> {
    long_term_within(run, PermittedDistance { fast: target, slow: target }, most_returns)
}

/// The permitted relative distance from a limit cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct PermittedDistance {
    /// Where returns contract fast.
    pub fast: f64,
    /// Where returns contract slowly: Newton's iteration may go on from farther away.
    pub slow: f64,
}

/// The same with a permitted distance for either speed of contraction.
pub(super) fn long_term_within<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    permitted: PermittedDistance,
    most_returns: u64,
) -> Result<LongTerm<R>, Failure> {
    let mut approach = Approach::new();
    for done in 1..=most_returns {
        let Some((orbit, end)) = approach.next_return(run)? else { continue };
        if end == ReturnEnd::AtRest {
            let transient = approach.transient.unwrap_or(orbit);
            return Ok(LongTerm::Decay(Decay { oscillation: None, transient, rate: final_rate(run) }));
        }
        approach.history.returns.push(orbit);
        if approach.is_linear()
            && let Some(transient) = approach.transient.take()
        {
            return measure_decay(run, approach.history, transient).map(LongTerm::Decay);
        }
        let Some(change) = approach.history.change(1) else { continue };
        let noise = approach.noise(run.control.local_tolerance);
        if approach.stands_still(change, run.control.local_tolerance) {
            return Err(Failure::Undecided { cycles: done, change });
        }
        if let Some(cycle) = approach.cycle(change, noise, permitted) {
            return Ok(LongTerm::Cycle(cycle));
        }
        if change > noise {
            approach.jump(run);
        }
    }
    let change = approach.history.change(1).unwrap_or(f64::INFINITY);
    Err(Failure::Undecided { cycles: most_returns, change })
}

/// A trajectory on its way to its long-term behaviour.
struct Approach<R> {
    /// All returns before the first jump, as one.
    transient: Option<Return<R>>,
    history: History<R>,
    /// Factor by which a return last shrank a change.
    contraction: Option<f64>,
    has_jumped: bool,
    /// The largest part of the state that the next jump may change.
    reach: f64,
    /// Where the last jump came from.
    retreat: Option<State<R>>,
    standstill: Standstill,
}

impl<R: Scalar> Approach<R> {
    const fn new() -> Self {
        Self {
            transient: None,
            history: History::new(),
            contraction: None,
            has_jumped: false,
            reach: LARGEST_JUMP,
            retreat: None,
            standstill: Standstill::new(),
        }
    }

    /// The next return; none when the last jump led where no trajectory goes: then the run goes back and jumps less far the next time.
    fn next_return<M: Stepper<R> + Clone>(
        &mut self,
        run: &mut Integrator<'_, R, M>,
    ) -> Result<Option<(Return<R>, ReturnEnd)>, Failure> {
        let (orbit, end) = match (next_return(run), self.retreat.take()) {
            (Ok(found), origin) => {
                self.retreat = origin;
                found
            }
            (Err(Failure::StepVanished { .. }), Some(origin)) => {
                run.resume_from(origin);
                (self.reach, self.history) = (0.25 * self.reach, History::new());
                return Ok(None);
            }
            (Err(failure), _) => return Err(failure),
        };
        if !self.has_jumped {
            let so_far = self.transient.take();
            self.transient =
                Some(so_far.map_or_else(|| orbit.clone(), |so_far| so_far.joined(orbit.clone())));
        }
        Ok(Some((orbit, end)))
    }

    /// Size of the state at the last crossing.
    fn amplitude(&self) -> f64 {
        self.history.back(0).map_or(0.0, size)
    }

    /// Whether the state is small and shrinks.
    fn is_linear(&self) -> bool {
        let amplitude = self.amplitude();
        amplitude < LINEAR && self.history.back(1).is_some_and(|before| size(before) > amplitude)
    }

    /// The local tolerance relative to the state: where the state is above 1 the integrator's is not.
    fn relative_tolerance(&self, local_tolerance: f64) -> f64 {
        local_tolerance / self.amplitude().max(1.0)
    }

    /// Relative changes below this may be errors.
    fn noise(&self, local_tolerance: f64) -> f64 {
        (NOISE_IN_TOLERANCES * self.relative_tolerance(local_tolerance)).max(ROUNDING_OF_RETURNS)
    }

    /// Whether changes of the size of the errors no longer shrink.
    fn stands_still(&mut self, change: f64, local_tolerance: f64) -> bool {
        change < ERRATIC_IN_TOLERANCES * self.relative_tolerance(local_tolerance)
            && self.standstill.lasts(change, self.amplitude())
    }

    /// The limit cycle, when the trajectory is near enough to it.
    fn cycle(&mut self, change: f64, noise: f64, permitted: PermittedDistance) -> Option<Cycle<R>> {
        if change > noise {
            self.contraction = self.history.multiplier().or(self.contraction);
        }
        let contraction = self.contraction.filter(|&known| known < 1.0);
        // Where no contraction could be measured the first returns already were on the cycle.
        let known = contraction.unwrap_or(UNMEASURED);
        // The return's peak and duration belong to the state that it began with.
        let distance = change / (1.0 - known);
        let near = distance <= if known < SLOW { permitted.fast } else { permitted.slow };
        if contraction.is_some() && near || self.history.within(noise) && distance <= FARTHEST {
            return Some(cycle(&self.history, 1, self.contraction, distance));
        }
        let returns = returns_per_cycle(&self.history, permitted.fast, noise)?;
        let distance = self.history.change(returns).unwrap_or(change);
        Some(cycle(&self.history, returns, None, distance))
    }

    /// Jumps along the slow direction, where one shows.
    fn jump<M: Stepper<R>>(&mut self, run: &mut Integrator<'_, R, M>) {
        if self.history.returns.len() < RETURNS_BEFORE_JUMP {
            return;
        }
        if let Some([y, zeta]) = jump(&self.history, self.reach) {
            self.retreat = Some(run.state().clone());
            run.resume_from([R::from(0), R::from_f64(y), R::from_f64(zeta)]);
            self.history = History::new();
            self.has_jumped = true;
        }
    }
}

fn cycle<R: Scalar>(
    history: &History<R>,
    returns_per_cycle: usize,
    contraction: Option<f64>,
    distance: f64,
) -> Cycle<R> {
    let returns = &history.returns[history.returns.len() - returns_per_cycle..];
    let joined = returns[1..].iter().fold(returns[0].clone(), |sum, orbit| sum.joined(orbit.clone()));
    let [y, zeta] = history.back(returns_per_cycle).unwrap_or([0.0; 2]).map(R::from_f64);
    Cycle { orbit: joined, returns_per_cycle, contraction, distance, from: [R::from(0), y, zeta] }
}
