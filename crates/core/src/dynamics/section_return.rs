//! One return: from one upward crossing of V = V_l to the next.

use super::events::{Mark, candidates, move_to, state_at};
use super::stepper::{Stepper, velocity_slopes};
use super::{Failure, Integrator, Scalar, State};

/// Below this size of (x, y, ζ) a trajectory that no longer crosses V = V_l has come to rest in steady sliding.
///
/// The equations keep relative accuracy down to here, so a long-term oscillation is seen unless it loses 150 decades in a few turns.
pub const QUIET: f64 = 1e-150;

/// Below this size the equations are linear beyond all digits, and the extremes of the trajectory lie far behind: what is left to be
/// seen is how the end goes, and a pair of modes that dies as fast as to have hidden until here is sought among small deviations.
pub(super) const FAINT: f64 = 1e-30;

/// The local tolerance that is enough there.
const FAINT_TOLERANCE: f64 = 1e-2;

/// From here on the run's own tolerance holds again: steps as long as the loose ones leave the state in any direction, of which the slowest
/// mode has to become the only one.
const LAST_STRETCH: f64 = 1e-100;

/// What one return showed.
#[derive(Debug, Clone, PartialEq)]
pub struct Return<R> {
    /// Duration in D_c/V_l.
    pub duration: R,
    /// Largest x = ln(V/V_l), the start included.
    pub peak: R,
    /// Least x, the start included.
    pub trough: R,
    /// Largest ζ at a crossing of V = V_l, the start included.
    pub highest_stress: R,
    /// Least ζ at a crossing of V = V_l.
    pub lowest_stress: R,
    /// The state at the end.
    pub end: State<R>,
}

/// How a return ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReturnEnd {
    /// At the next upward crossing.
    Crossing,
    /// In steady sliding, without another crossing.
    AtRest,
}

/// Runs to the next upward crossing of V = V_l, and leaves the run standing on it with its clock at zero.
///
/// # Errors
/// Those of the integrator.
pub fn next_return<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
) -> Result<(Return<R>, ReturnEnd), Failure> {
    let (orbit, end) = return_above(run, FAINT)?;
    if end == ReturnEnd::Crossing {
        return Ok((orbit, end));
    }
    fade(run)?;
    Ok((orbit.finish(run, end), end))
}

/// The same, but a trajectory whose x, y and ζ fall below a size without a crossing ends there.
///
/// # Errors
/// Those of the integrator.
pub(super) fn return_above<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    least_size: f64,
) -> Result<(Return<R>, ReturnEnd), Failure> {
    let start = run.state().clone();
    let mut orbit = Return {
        duration: R::from(0),
        peak: start[0].clone(),
        trough: start[0].clone(),
        highest_stress: start[2].clone(),
        lowest_stress: start[2].clone(),
        end: start,
    };
    let mut last_slope = None;
    'steps: loop {
        if run.arrest() {
            // The velocity is least where the slow motion begins, or later.
            orbit.note(Mark::Trough, run.state());
            last_slope = None;
        }
        run.advance(None)?;
        let slope = |theta| velocity_slopes(run.method().polynomial(), &R::from(theta)).0.to_f64();
        let [first, last] = [0, 1].map(slope).map(Some);
        // The polynomials of two long steps may differ so much in slope that neither has the extreme between them.
        match (last_slope, first) {
            (Some(..0.0), Some(0.0..)) => orbit.note(Mark::Trough, &run.step_start),
            (Some(0.0..), Some(..0.0)) => orbit.note(Mark::Peak, &run.step_start),
            _ => {}
        }
        for candidate in candidates(run).into_iter().flatten() {
            if candidate.mark != Mark::Rise {
                orbit.note(candidate.mark, &state_at(run, candidate));
                continue;
            }
            if move_to(run, candidate) {
                return Ok((orbit.finish(run, ReturnEnd::Crossing), ReturnEnd::Crossing));
            }
            run.take_back();
            continue 'steps;
        }
        last_slope = last;
        if size_of(run.state()) < least_size {
            return Ok((orbit.finish(run, ReturnEnd::AtRest), ReturnEnd::AtRest));
        }
    }
}

fn size_of<R: Scalar>(state: &State<R>) -> f64 {
    state.iter().fold(0.0f64, |size, c| size.max(c.to_f64().abs()))
}

/// Follows the end of a decay until it is quiet; a few zeros more or less change nothing then, but the last stretch is as
/// good as the rest of the run, because the rate of the decay is read off at its end.
fn fade<R: Scalar, M: Stepper<R>>(run: &mut Integrator<'_, R, M>) -> Result<(), Failure> {
    let local_tolerance = run.control.local_tolerance;
    run.control.local_tolerance = local_tolerance.max(FAINT_TOLERANCE);
    let loosely = follow_down_to(run, LAST_STRETCH);
    run.control.local_tolerance = local_tolerance;
    loosely.and_then(|()| follow_down_to(run, QUIET))
}

fn follow_down_to<R: Scalar, M: Stepper<R>>(
    run: &mut Integrator<'_, R, M>,
    size: f64,
) -> Result<(), Failure> {
    while size_of(run.state()) >= size {
        run.advance(None)?;
    }
    Ok(())
}

impl<R: Scalar> Return<R> {
    fn note(&mut self, mark: Mark, state: &State<R>) {
        let (record, value, is_largest) = match mark {
            Mark::Peak => (&mut self.peak, &state[0], true),
            Mark::Trough => (&mut self.trough, &state[0], false),
            Mark::Fall => (&mut self.lowest_stress, &state[2], false),
            Mark::Rise => (&mut self.highest_stress, &state[2], true),
        };
        let is_new = if is_largest { value > record } else { value < record };
        if is_new {
            *record = value.clone();
        }
    }

    fn finish<M: Stepper<R>>(mut self, run: &mut Integrator<'_, R, M>, end: ReturnEnd) -> Self {
        self.duration = run.time();
        if end == ReturnEnd::Crossing {
            self.note(Mark::Rise, run.state());
            run.begin_cycle();
        }
        self.end = run.state().clone();
        self
    }

    /// The same, and what every decay ends with: the stress of steady sliding, ζ = 0.
    pub(super) fn and_steady_sliding(mut self) -> Self {
        let steady = [R::from(0), R::from(0), R::from(0)];
        self.note(Mark::Rise, &steady);
        self.note(Mark::Fall, &steady);
        self
    }

    /// The same in f64.
    pub(crate) fn rounded(&self) -> Return<f64> {
        Return {
            duration: self.duration.to_f64(),
            peak: self.peak.to_f64(),
            trough: self.trough.to_f64(),
            highest_stress: self.highest_stress.to_f64(),
            lowest_stress: self.lowest_stress.to_f64(),
            end: std::array::from_fn(|i| self.end[i].to_f64()),
        }
    }

    /// Two returns as one: durations add, extremes are compared.
    #[must_use]
    pub fn joined(mut self, next: Self) -> Self {
        self.duration = self.duration + next.duration;
        for (mark, value) in [(Mark::Peak, next.peak), (Mark::Trough, next.trough)] {
            self.note(mark, &[value, R::from(0), R::from(0)]);
        }
        for (mark, value) in [(Mark::Rise, next.highest_stress), (Mark::Fall, next.lowest_stress)] {
            self.note(mark, &[R::from(0), R::from(0), value]);
        }
        self.end = next.end;
        self
    }
}
