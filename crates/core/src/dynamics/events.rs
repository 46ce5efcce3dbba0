//! Moments that matter within a step, found on its polynomial and refined to the order of the method.
//!
//! x = 0 upward is where the spring stress is largest, x = 0 downward where it is least, exactly: ζ' = κ(1 − e^x).
//! The sign of x' from the equation is rounding noise in quasi-static phases, so extremes of x are sought by the slope
//! of the step polynomial. Each moment is then made the end of a step: the last step is repeated with another length.

use super::stepper::{Stepper, increment, velocity_slopes};
use super::{Integrator, Scalar, State};
use crate::number::search::zero_between;

/// What happens to x = ln(V/V_l) at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// x rises through 0.
    Rise,
    /// x falls through 0.
    Fall,
    /// x has a maximum.
    Peak,
    /// x has a minimum.
    Trough,
}

/// A candidate: a mark and its place θ on the step polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// What happens.
    pub mark: Mark,
    /// Where in the step, in (0, 1].
    pub theta: f64,
}

/// Points of the step at which signs are compared; extremes closer than this stay unseen.
const PIECES: usize = 8;

/// Most candidates of one step: a crossing and an extreme per piece.
pub const MOST_CANDIDATES: usize = 2 * PIECES;

/// Repetitions of a step that bring its end to the moment: each doubles the digits of the polynomial's estimate.
const REPETITIONS: usize = 5;

/// The candidates of the last step in order of time; unused places are `None`.
#[must_use]
pub fn candidates<R: Scalar, M: Stepper<R>>(
    run: &Integrator<'_, R, M>,
) -> [Option<Candidate>; MOST_CANDIDATES] {
    let polynomial = run.method().polynomial();
    let start = &run.step_start[0];
    let mut found = [None; MOST_CANDIDATES];
    let mut count = 0;
    let value = |theta: f64| (increment(polynomial, &R::from_f64(theta))[0].clone() + start).to_f64();
    let slope = |theta: f64| velocity_slopes(polynomial, &R::from_f64(theta)).0.to_f64();
    let (mut left_value, mut left_slope) = (start.to_f64(), slope(0.0));
    for piece in 0..PIECES {
        let [left, right] = [piece, piece + 1].map(|k| k as f64 / PIECES as f64);
        let (right_value, right_slope) = (value(right), slope(right));
        let mut pair = [None; 2];
        if (left_value < 0.0) != (right_value < 0.0) {
            let mark = if left_value < 0.0 { Mark::Rise } else { Mark::Fall };
            pair[0] =
                Some(Candidate { mark, theta: zero(value, [(left, left_value), (right, right_value)]) });
        }
        if (left_slope < 0.0) != (right_slope < 0.0) {
            let mark = if left_slope < 0.0 { Mark::Trough } else { Mark::Peak };
            pair[1] =
                Some(Candidate { mark, theta: zero(slope, [(left, left_slope), (right, right_slope)]) });
        }
        if pair[0].zip(pair[1]).is_some_and(|(a, b)| b.theta < a.theta) {
            pair.swap(0, 1);
        }
        for candidate in pair.into_iter().flatten() {
            found[count] = Some(candidate);
            count += 1;
        }
        (left_value, left_slope) = (right_value, right_slope);
    }
    found
}

/// The zero of a function with different signs at the ends, to half of f64's digits.
fn zero(function: impl Fn(f64) -> f64, ends: [(f64, f64); 2]) -> f64 {
    let [(left, _), (right, _)] = ends;
    let found = zero_between(|theta| Some(function(theta)), ends, 1e-9);
    found.map_or(right, |theta| theta.clamp(left.max(1e-12), right))
}

/// Repeats the last step so that it ends at a candidate; the run then stands there. False when a repetition failed.
pub fn move_to<R: Scalar, M: Stepper<R>>(run: &mut Integrator<'_, R, M>, candidate: Candidate) -> bool {
    let mut h = run.step().clone() * R::from_f64(candidate.theta);
    for _ in 0..REPETITIONS {
        if run.redo(&h).is_none() {
            return false;
        }
        let (slope, curvature) = velocity_slopes(run.method().polynomial(), &R::from(1));
        let correction = match candidate.mark {
            Mark::Rise | Mark::Fall => -(run.state()[0].clone() / slope),
            Mark::Peak | Mark::Trough => -(slope / curvature),
        };
        let size = correction.to_f64().abs();
        // At an extreme the value errs by the square of the place's error.
        let good = match candidate.mark {
            Mark::Rise | Mark::Fall => 8.0 * R::UNIT_ROUNDOFF,
            Mark::Peak | Mark::Trough => R::UNIT_ROUNDOFF.sqrt(),
        };
        if size <= good || !size.is_finite() {
            break;
        }
        h = h.clone() + h * R::from_f64(correction.to_f64().clamp(-0.5, 0.5));
    }
    true
}

/// Tries of [`state_at`] with ever shorter steps, before it takes the value of the step polynomial.
const SHORTER_STEPS: usize = 12;

/// The state at a candidate, leaving the run where it is.
#[must_use]
pub fn state_at<R: Scalar, M: Stepper<R> + Clone>(
    run: &Integrator<'_, R, M>,
    candidate: Candidate,
) -> State<R> {
    let mut aside = run.clone();
    if move_to(&mut aside, candidate) {
        return aside.state().clone();
    }
    let mut aside = run.clone();
    aside.take_back();
    for _ in 0..SHORTER_STEPS {
        if aside.advance(None).is_err() {
            break;
        }
        let same = candidates(&aside).into_iter().flatten().find(|found| found.mark == candidate.mark);
        if same.is_some_and(|found| move_to(&mut aside, found)) {
            return aside.state().clone();
        }
    }
    run.state_within(&R::from_f64(candidate.theta))
}
