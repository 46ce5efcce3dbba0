//! Late behaviour: a limit cycle, or decay to steady sliding, decided on the Poincaré section x = 0 (upward).
//!
//! Deep stick-slip is superattracting: two or three laps settle it. Near K = K_c a lap changes the state by a part in
//! 10^4, so the laps are extrapolated along the slow direction (the secant step of a fixed-point iteration), each jump limited to a
//! part of the state and followed by laps of the true map; nothing is accepted on extrapolation alone.

use super::lap::{Lap, LapEnd, run_lap};
use super::stepper::Stepper;
use super::{Failure, Integrator, Scalar, State};

/// Size of the state on the section below which the equations are linear to about this relative accuracy.
const LINEAR: f64 = 1e-7;

/// Laps between two jumps: one to return to the slow direction, three to measure it.
const LAPS_BEFORE_JUMP: usize = 4;

/// The largest part of the state that one jump may change.
const LARGEST_JUMP: f64 = 0.3;

/// Relative changes of a lap below this multiple of the local tolerance may be the integrator's errors rather than the map's.
const NOISE_IN_TOLERANCES: f64 = 0.01;

/// The farthest from its cycle that a trajectory may be called periodic, when the integrator's errors hide the rest of the way.
const FARTHEST: f64 = 1e-3;

/// Most laps per cycle that are looked for.
const MOST_LAPS_PER_CYCLE: usize = 4;

/// A limit cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle<R> {
    /// The whole cycle.
    pub lap: Lap<R>,
    /// Upward passages of V = V_l in one cycle.
    pub laps_per_cycle: usize,
    /// Factor by which the last measurable deviation shrank in one lap: the leading Floquet multiplier, an upper bound when superattracting.
    pub contraction: Option<f64>,
    /// Estimated relative distance between the cycle and the state with which the reported lap began.
    pub distance: f64,
}

/// A return to steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub struct Decay<R> {
    /// All that happened before it was called linear, as one lap.
    pub transient: Lap<R>,
    /// Period and growth rate (negative) of the late oscillation in units of D_c/V_l; none when there is no oscillation.
    pub oscillation: Option<(R, R)>,
    /// Rate at which the state shrank at the very end, when it does not oscillate.
    pub rate: Option<R>,
}

/// Where a trajectory ends up.
#[derive(Debug, Clone, PartialEq)]
pub enum Late<R> {
    /// On a limit cycle.
    Cycle(Cycle<R>),
    /// In steady sliding.
    Decay(Decay<R>),
}

/// A point of the section with the lap that led to it.
type Passage = [f64; 2];

/// The laps since the last jump.
struct History<R> {
    passages: Vec<Passage>,
    laps: Vec<Lap<R>>,
}

fn size(v: Passage) -> f64 {
    v[0].abs().max(v[1].abs())
}

fn difference(a: Passage, b: Passage) -> Passage {
    [a[0] - b[0], a[1] - b[1]]
}

impl<R: Scalar> History<R> {
    const fn new() -> Self {
        Self { passages: Vec::new(), laps: Vec::new() }
    }

    fn push(&mut self, lap: Lap<R>) {
        self.passages.push([lap.end[1].to_f64(), lap.end[2].to_f64()]);
        self.laps.push(lap);
    }

    fn back(&self, n: usize) -> Option<Passage> {
        self.passages.len().checked_sub(n + 1).map(|index| self.passages[index])
    }

    /// The change over the last `m` laps, relative to the state.
    fn change(&self, m: usize) -> Option<f64> {
        let (last, before) = (self.back(0)?, self.back(m)?);
        Some(size(difference(last, before)) / size(last))
    }

    /// Whether the last three changes are so small that they may be the integrator's errors, which no lap can improve on.
    fn within(&self, noise: f64) -> bool {
        (0..3).all(|n| {
            let (Some(last), Some(before)) = (self.back(n), self.back(n + 1)) else { return false };
            size(difference(last, before)) < noise * size(last)
        })
    }

    /// The factor by which the last lap shrank the change: along the slow direction, or any when it is small.
    fn multiplier(&self) -> Option<f64> {
        if let Some((multiplier, _)) = self.slow_direction() {
            return Some(multiplier.abs());
        }
        let (last, before) =
            (self.change(1)?, size(difference(self.back(1)?, self.back(2)?)) / size(self.back(0)?));
        (last < 0.1 * before).then(|| last / before)
    }

    /// The slow multiplier and the last change, when the last three passages lie on a line.
    fn slow_direction(&self) -> Option<(f64, Passage)> {
        let (a, b, c) = (self.back(2)?, self.back(1)?, self.back(0)?);
        let (first, second) = (difference(b, a), difference(c, b));
        let norm = first[0] * first[0] + first[1] * first[1];
        let multiplier = (first[0] * second[0] + first[1] * second[1]) / norm;
        let rest = difference(second, [multiplier * first[0], multiplier * first[1]]);
        (size(rest) <= 0.1 * size(second)).then_some((multiplier, second))
    }
}

/// Follows a run to its late behaviour; `target` is the permitted relative distance from the limit cycle.
///
/// # Errors
/// Those of the integrator, and [`Failure::Undecided`] after `most_laps`.
pub fn settle<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    target: f64,
    most_laps: u64,
) -> Result<Late<R>, Failure> {
    let mut transient: Option<Lap<R>> = None;
    let mut history = History::new();
    let mut contraction = None;
    let noise = NOISE_IN_TOLERANCES * run.local_tolerance();
    let mut jumped = false;
    let mut reach = LARGEST_JUMP;
    let mut retreat: Option<State<R>> = None;
    for _ in 0..most_laps {
        let (lap, end) = match (run_lap(run), &retreat) {
            (Ok(lap), _) => lap,
            // The jump led where no trajectory goes: back to where it came from, and less far the next time.
            (Err(Failure::StepVanished { .. }), Some(origin)) => {
                run.resume_from(origin.clone());
                (reach, retreat, history) = (0.25 * reach, None, History::new());
                continue;
            }
            (Err(failure), _) => return Err(failure),
        };
        if !jumped {
            transient = Some(transient.map_or_else(|| lap.clone(), |so_far| so_far.joined(lap.clone())));
        }
        if end == LapEnd::Quiet {
            let rate = final_rate(run);
            return Ok(Late::Decay(Decay {
                oscillation: sparse_oscillation(&history),
                transient: transient.unwrap_or(lap),
                rate,
            }));
        }
        history.push(lap);
        let amplitude = history.back(0).map_or(0.0, size);
        let shrinking = history.back(1).is_some_and(|before| size(before) > amplitude);
        if amplitude < LINEAR
            && shrinking
            && let Some(transient) = transient.clone()
        {
            return measure_decay(run, history, transient);
        }
        let Some(change) = history.change(1) else { continue };
        if change > noise {
            contraction = history.multiplier().or(contraction);
        }
        // Where no contraction could be measured the first laps already were on the cycle.
        let known = contraction.filter(|&known| known < 1.0).unwrap_or(0.5);
        // The lap's peak and duration belong to the state that it began with.
        let distance = change / (1.0 - known);
        let measured = contraction.is_some_and(|known| known < 1.0) && distance <= target;
        if measured || history.within(noise) && distance <= FARTHEST {
            return Ok(Late::Cycle(cycle(&history, 1, contraction, distance)));
        }
        if let Some(m) = laps_per_cycle(&history, target, noise) {
            let distance = history.change(m).unwrap_or(change);
            return Ok(Late::Cycle(cycle(&history, m, None, distance)));
        }
        let may_jump = history.passages.len() >= LAPS_BEFORE_JUMP && change > noise;
        if may_jump && let Some(to) = jump(&history, reach) {
            retreat = Some(run.state().clone());
            run.resume_from([R::from(0), R::from_f64(to[0]), R::from_f64(to[1])]);
            history = History::new();
            jumped = true;
        }
    }
    Err(Failure::Undecided { cycles: most_laps, change: history.change(1).unwrap_or(f64::INFINITY) })
}

fn cycle<R: Scalar>(
    history: &History<R>,
    laps_per_cycle: usize,
    contraction: Option<f64>,
    distance: f64,
) -> Cycle<R> {
    let laps = &history.laps[history.laps.len() - laps_per_cycle..];
    let joined = laps[1..].iter().fold(laps[0].clone(), |sum, lap| sum.joined(lap.clone()));
    Cycle { lap: joined, laps_per_cycle, contraction, distance }
}

/// The number of laps after which the state repeats, when it is more than one and the repetition is already exact.
fn laps_per_cycle<R: Scalar>(history: &History<R>, target: f64, noise: f64) -> Option<usize> {
    let single = history.change(1)?;
    if single < 100.0 * noise {
        return None;
    }
    (2..=MOST_LAPS_PER_CYCLE).find(|&m| {
        let twice = history.passages.len() > 2 * m;
        twice && history.change(m).is_some_and(|change| change <= target && change <= 1e-3 * single)
    })
}

/// Where the slow direction leads: the secant's fixed point, or a limited part of the way.
fn jump<R: Scalar>(history: &History<R>, reach: f64) -> Option<Passage> {
    let (multiplier, change) = history.slow_direction()?;
    let here = history.back(0)?;
    let amplitude = size(here);
    // Faster contraction than this converges by itself before a jump pays.
    if multiplier < 0.3 {
        return None;
    }
    let largest = reach * amplitude / size(change);
    let factor = if multiplier < 1.0 { (multiplier / (1.0 - multiplier)).min(largest) } else { largest };
    let to = [here[0] + factor * change[0], here[1] + factor * change[1]];
    let full = multiplier / (1.0 - multiplier);
    let end = [here[0] + full * change[0], here[1] + full * change[1]];
    // A small state on its way to zero: the equations are nearly linear, and a decade is as good as a lap.
    if multiplier < 1.0 && amplitude < 0.05 && size(end) < 0.2 * amplitude {
        return Some([0.1 * here[0], 0.1 * here[1]]);
    }
    Some(to)
}

/// Period and growth rate in the linear regime, when laps agree with one another.
fn measure_decay<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    mut history: History<R>,
    transient: Lap<R>,
) -> Result<Late<R>, Failure> {
    /// Laps until the fast direction has died out; it shrinks by e^{−2π} a lap at least when there is an oscillation.
    const LAPS: usize = 12;
    for _ in 0..LAPS {
        let (lap, end) = run_lap(run)?;
        if end == LapEnd::Quiet {
            let rate = final_rate(run);
            return Ok(Late::Decay(Decay { oscillation: sparse_oscillation(&history), transient, rate }));
        }
        history.push(lap);
        if let Some((period, rate)) = last_oscillation(&history)
            && history.laps.len() >= 4
            && steady(&history)
        {
            return Ok(Late::Decay(Decay { transient, oscillation: Some((period, rate)), rate: None }));
        }
    }
    let oscillation = last_oscillation(&history);
    Ok(Late::Decay(Decay { transient, oscillation, rate: None }))
}

/// Whether the last three laps took the same time to eleven digits.
fn steady<R: Scalar>(history: &History<R>) -> bool {
    let n = history.laps.len();
    let duration = |back: usize| history.laps[n - back].duration.to_f64();
    let last = duration(1);
    (2..=3).all(|back| (duration(back) / last - 1.0).abs() < 1e-11)
}

fn last_oscillation<R: Scalar>(history: &History<R>) -> Option<(R, R)> {
    let n = history.laps.len();
    let (before, last) = (history.laps.get(n.checked_sub(2)?)?, &history.laps[n - 1]);
    // ζ and y shrink by the same factor; the larger one is the better measured.
    let component = if last.end[1].abs() < last.end[2].abs() { 2 } else { 1 };
    let factor = last.end[component].clone() / &before.end[component];
    (factor > R::from(0)).then(|| (last.duration.clone(), factor.ln() / &last.duration))
}

/// An oscillation so damped that only a few passages came before the end: believed when the last two laps agree to 1 %.
fn sparse_oscillation<R: Scalar>(history: &History<R>) -> Option<(R, R)> {
    let n = history.laps.len();
    let linear = history.back(1).is_some_and(|passage| size(passage) < 1e-3);
    let (before, last) = (history.laps.get(n.checked_sub(2)?)?, &history.laps[n - 1]);
    let agree = (before.duration.to_f64() / last.duration.to_f64() - 1.0).abs() < 0.01;
    (linear && agree).then(|| last_oscillation(history)).flatten()
}

/// d ln|state|/dt at the end of a decay without oscillation, from the component that moves.
fn final_rate<R: Scalar, M: Stepper<R>>(run: &Integrator<'_, R, M>) -> Option<R> {
    let state: &State<R> = run.state();
    let rate = run.model().rate(state);
    let largest = (0..3).fold(0, |best, i| if state[i].abs() > state[best].abs() { i } else { best });
    let value = rate[largest].clone() / &state[largest];
    value.is_finite().then_some(value)
}
