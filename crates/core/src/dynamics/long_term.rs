//! Long-term behaviour: a limit cycle, or decay to steady sliding, decided on the Poincaré section x = 0 (upward).
//!
//! Deep stick-slip is superattracting: it is reached in two or three returns. Near K = K_c a return changes the state by a part in
//! 10^4, so the returns are extrapolated along the slow direction (the secant step of a fixed-point iteration), each jump limited to a
//! part of the state and followed by returns of the true map; nothing is accepted on extrapolation alone.

use super::decay::{final_rate, measure_decay};
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

/// A return to steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub struct Decay<R> {
    /// All that happened before it was called linear, as one return.
    pub transient: Return<R>,
    /// Period and growth rate (negative) of the long-term oscillation in units of D_c/V_l; none when there is no oscillation.
    pub oscillation: Option<(R, R)>,
    /// Rate at which the state shrank at the very end, when it does not oscillate.
    pub rate: Option<R>,
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
    long_term_within(run, [target; 2], most_returns)
}

/// The same with a permitted distance of its own where a return contracts slowly: Newton's iteration goes on from there.
pub(super) fn long_term_within<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    [target, slow_target]: [f64; 2],
    most_returns: u64,
) -> Result<LongTerm<R>, Failure> {
    let mut transient: Option<Return<R>> = None;
    let mut history = History::new();
    let mut contraction = None;
    let mut jumped = false;
    let mut reach = LARGEST_JUMP;
    let mut retreat: Option<State<R>> = None;
    let mut standstill = Standstill::new();
    for done in 1..=most_returns {
        let (orbit, end) = match (next_return(run), &retreat) {
            (Ok(orbit), _) => orbit,
            // The jump led where no trajectory goes: back to where it came from, and less far the next time.
            (Err(Failure::StepVanished { .. }), Some(origin)) => {
                run.resume_from(origin.clone());
                (reach, retreat, history) = (0.25 * reach, None, History::new());
                continue;
            }
            (Err(failure), _) => return Err(failure),
        };
        if !jumped {
            transient = Some(transient.map_or_else(|| orbit.clone(), |so_far| so_far.joined(orbit.clone())));
        }
        if end == ReturnEnd::AtRest {
            return Ok(LongTerm::Decay(Decay {
                oscillation: None,
                transient: transient.unwrap_or(orbit),
                rate: final_rate(run),
            }));
        }
        history.push(orbit);
        let amplitude = history.back(0).map_or(0.0, size);
        let shrinking = history.back(1).is_some_and(|before| size(before) > amplitude);
        if amplitude < LINEAR
            && shrinking
            && let Some(transient) = transient.clone()
        {
            return measure_decay(run, history, transient);
        }
        let Some(change) = history.change(1) else { continue };
        // Where the state is above 1 the tolerance is not relative to it.
        let relative_tolerance = run.local_tolerance() / amplitude.max(1.0);
        let noise = (NOISE_IN_TOLERANCES * relative_tolerance).max(ROUNDING_OF_RETURNS);
        if change < ERRATIC_IN_TOLERANCES * relative_tolerance && standstill.lasts(change, amplitude) {
            return Err(Failure::Undecided { cycles: done, change });
        }
        if change > noise {
            contraction = history.multiplier().or(contraction);
        }
        // Where no contraction could be measured the first returns already were on the cycle.
        let known = contraction.filter(|&known| known < 1.0).unwrap_or(UNMEASURED);
        // The return's peak and duration belong to the state that it began with.
        let distance = change / (1.0 - known);
        let permitted = if known < SLOW { target } else { slow_target };
        let measured = contraction.is_some_and(|known| known < 1.0) && distance <= permitted;
        if measured || history.within(noise) && distance <= FARTHEST {
            return Ok(LongTerm::Cycle(cycle(&history, 1, contraction, distance)));
        }
        if let Some(m) = returns_per_cycle(&history, target, noise) {
            let distance = history.change(m).unwrap_or(change);
            return Ok(LongTerm::Cycle(cycle(&history, m, None, distance)));
        }
        let may_jump = history.crossings.len() >= RETURNS_BEFORE_JUMP && change > noise;
        if may_jump && let Some(to) = jump(&history, reach) {
            retreat = Some(run.state().clone());
            run.resume_from([R::from(0), R::from_f64(to[0]), R::from_f64(to[1])]);
            history = History::new();
            jumped = true;
        }
    }
    Err(Failure::Undecided { cycles: most_returns, change: history.change(1).unwrap_or(f64::INFINITY) })
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
