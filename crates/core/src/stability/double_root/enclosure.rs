//! A certain enclosure of the root of F next to an approximate one.
//!
//! Newton steps without bounds double the bits up to half of the goal; one interval Newton step proves the rest.

use rug::Float;

use super::start::Start;
use crate::number::Ball;
use slipmode_algebra::{derivative, horner};

/// Bits of an arithmetic beyond those that a result has to have.
const SPARE_BITS: u32 = 8;

/// Bits that hold a double-double number of ordinary size.
const DOUBLE_DOUBLE_BITS: u32 = 107;

/// What the last step loses against the square of the error, for the ball around the root.
const LOST_BITS: u32 = 8;

/// What the steps before lose.
const LOST_BITS_BEFORE: u32 = 2;

/// Relative bits that a root is known to at least, so that its ball stays small.
const FEWEST_BITS: u32 = 40;

/// More doublings than this need more digits than MPFR has.
const MOST_STEPS: usize = 64;

/// A ball that contains exactly one root of F.
#[derive(Debug, Clone)]
pub(super) struct Enclosure {
    pub(super) root: Ball,
    /// F′ on a ball around `root`.
    pub(super) slope: Ball,
    /// The precision of each step that was taken, bits.
    pub(super) precisions: Vec<u32>,
}

/// How many bits of x a value of F, a value of F′ and a change of F′ cost, from 64-bit numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loss {
    /// log2 of Σ|c_k x^k|/|x F′|.
    value: u32,
    /// log2 of Σ|k c_k x^(k−1)|/|F′|.
    slope: u32,
    /// log2 of |x F″/F′|: x is this much larger than the distance to the next root.
    curvature: u32,
}

impl Loss {
    pub(super) fn of(start: &Start) -> Self {
        let (x, at) = (start.root.hi(), &start.values);
        Self {
            value: bits_of(at.terms / (x * at.slope).abs()),
            slope: bits_of(at.slope_terms / at.slope.abs()),
            curvature: bits_of((x * at.curvature / at.slope).abs()),
        }
    }
}

/// ⌈log2⌉ of a ratio, at least zero; what is not finite is many.
fn bits_of(ratio: f64) -> u32 {
    if ratio.is_finite() { libm::frexp(ratio).1.max(0).unsigned_abs() } else { u32::MAX / 16 }
}

impl Enclosure {
    /// The enclosure of the root next to `start` with a relative radius of about 2^−goal; none when the proof fails.
    pub(super) fn around(start: &Start, loss: Loss, coefficients: &[Ball], goal: u32) -> Option<Self> {
        let x = start.root.hi();
        let goal = goal.max(FEWEST_BITS).max(loss.curvature + 2 * LOST_BITS);
        let mut known = bits_known(4.0 * start.error / x.abs())?;
        let goals = schedule(known, goal, loss.curvature)?;
        let (last, before) = goals.split_first()?;
        let mut precisions = Vec::with_capacity(goals.len());
        let mut root = Float::with_val(DOUBLE_DOUBLE_BITS, start.root.hi()) + start.root.lo();
        for goal in before.iter().rev() {
            let precision = Precision::of(loss, known, *goal);
            root = improved(&root, coefficients, precision);
            precisions.push(precision.value);
            known = *goal;
        }
        // The rounding of the value must not reach beyond the ball.
        let known = known.min(last + 1);
        let radius_log2 = i64::from(libm::frexp(x).1) - i64::from(known);
        let root = Ball::exact(root).with_precision(last + loss.value + SPARE_BITS).widened(radius_log2);
        let mut found = Self { root, slope: Ball::from(0), precisions };
        found.step(coefficients, Precision::of(loss, known, *last))?;
        Some(found)
    }

    /// The same root to 2^−goal.
    pub(super) fn refined(mut self, loss: Loss, coefficients: &[Ball], goal: u32) -> Option<Ball> {
        let mut known = (-self.root.relative_radius_log2()).max(0.0) as u32;
        if known >= goal {
            return Some(self.root);
        }
        for goal in schedule(known, goal, loss.curvature)?.iter().rev() {
            self.step(coefficients, Precision::of(loss, known, *goal))?;
            known = *goal;
        }
        Some(self.root)
    }

    /// m − F(m)/F′(X) for a ball X around m that is two to six times as large as the root's: contains every root of F in X.
    ///
    /// When it lies inside X, which is required, there is exactly one; and its centre lies in X, where F′ is known.
    fn step(&mut self, coefficients: &[Ball], precision: Precision) -> Option<()> {
        let rounded = |bits: u32| coefficients.iter().map(|c| c.with_precision(bits)).collect::<Vec<Ball>>();
        let middle = Ball::exact(Float::with_val(precision.value, self.root.centre()));
        let reach_log2 = self.root.radius_exponent() + 1;
        let around = middle.with_precision(precision.slope).widened(reach_log2);
        self.slope = horner(derivative(rounded(precision.slope)), &around);
        let value = horner(rounded(precision.value), &middle).with_precision(precision.slope);
        let change = value / &self.slope;
        let inside = change.exponent_above() < reach_log2;
        self.root = middle - change;
        self.precisions.push(precision.value);
        inside.then_some(())
    }
}

/// Bits of the two parts of a Newton step.
#[derive(Debug, Clone, Copy)]
struct Precision {
    /// For F.
    value: u32,
    /// For F′ and the quotient.
    slope: u32,
}

impl Precision {
    /// For a root known to 2^−known that is wanted to 2^−goal.
    fn of(loss: Loss, known: u32, goal: u32) -> Self {
        let gain = goal.saturating_sub(known).max(SPARE_BITS);
        Self { value: goal + loss.value + SPARE_BITS, slope: gain + loss.slope + loss.curvature + SPARE_BITS }
    }
}

/// A Newton step without bounds.
fn improved(root: &Float, coefficients: &[Ball], precision: Precision) -> Float {
    let x = Float::with_val(precision.value, root);
    let short = Float::with_val(precision.slope, root);
    let mut value = Float::new(precision.value);
    let mut slope = Float::new(precision.slope);
    for (index, coefficient) in coefficients.iter().enumerate().rev() {
        let power = index as u32;
        value *= &x;
        value += coefficient.centre();
        if power > 0 {
            slope *= &short;
            slope += Float::with_val(precision.slope, coefficient.centre() * power);
        }
    }
    x - Float::with_val(precision.slope, &value) / slope
}

/// −log2 of a relative error, rounded down; none when nothing is known.
fn bits_known(relative_error: f64) -> Option<u32> {
    let exponent = libm::frexp(relative_error).1;
    (relative_error > 0.0 && exponent < 0).then_some(exponent.unsigned_abs())
}

/// Bits after each step, from the last step to the first: each step doubles the bits but for the curvature's.
fn schedule(known: u32, goal: u32, curvature: u32) -> Option<Vec<u32>> {
    let mut goals = Vec::with_capacity(4);
    let (mut next, mut lost) = (goal, LOST_BITS);
    loop {
        goals.push(next);
        let before = (next + curvature + lost).div_ceil(2);
        if before <= known {
            return Some(goals);
        }
        if before >= next || goals.len() > MOST_STEPS {
            return None;
        }
        (next, lost) = (before, LOST_BITS_BEFORE);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Dd, Field};

    fn enclosed(polynomial: [i32; 3], x: f64, goal: u32) -> Option<Enclosure> {
        let start = Start::polished(&polynomial.map(Dd::from), x)?;
        let coefficients = polynomial.map(|c| Ball::from(c).with_precision(2 * goal + 100));
        Enclosure::around(&start, Loss::of(&start), &coefficients, goal)
    }

    #[test]
    fn the_square_root_of_two_takes_one_step_for_each_doubling_from_ninety_bits() {
        for (goal, steps) in [(30, 1), (90, 1), (170, 1), (330, 2), (690, 3)] {
            let found = enclosed([-2, 0, 1], 1.4, goal).unwrap();
            assert!((found.root.square() - Ball::from(2)).contains_zero());
            assert!(found.root.relative_radius_log2() <= -f64::from(goal), "{goal} {:?}", found.root);
            assert_eq!(found.precisions.len(), steps, "{goal}");
            assert!(found.precisions.last().is_some_and(|bits| *bits <= goal.max(FEWEST_BITS) + 16));
        }
    }

    #[test]
    fn without_a_simple_root_there_is_no_proof() {
        assert!(enclosed([1, 0, 1], 1.0, 100).is_none());
        assert!(enclosed([1, -2, 1], 1.01, 100).is_none());
    }

    #[test]
    fn precisions_end_at_the_goal_and_none_is_more_than_half_of_the_next_and_the_curvature() {
        assert_eq!(schedule(92, 345, 2), Some(vec![345, 178]));
        assert_eq!(schedule(92, 60, 2), Some(vec![60]));
        assert_eq!(schedule(3, 345, 20), None);
    }
}
