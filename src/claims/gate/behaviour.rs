//! How a side behaves as one variable moves: pairs of points, and sequences of points towards a limit.

use std::cmp::Ordering;

use slipmode_algebra::{Comparison, Toward};
use slipmode_core::number::{Ball, Rational};

use super::book::Term;
use super::claim::{At, Base, Claim, Goal};
use super::evaluate::AtPoint;
use super::number::Number;
use super::points::power_of_two;

/// The precisions at which two values are compared.
const BITS: [u32; 2] = [96, 512];

/// How many powers of 2^8 a limit is followed.
const FAR: i32 = 32;

/// How many of the last steps have to shrink, or to grow, for a tail to be clear.
const LAST: usize = 12;

/// Where the values of a side tend along a sequence of points, if that is clear.
pub(super) enum Tail {
    /// To the value.
    There,
    /// To another one, or beyond all bounds.
    Elsewhere(String),
    /// It is not clear, or the conditions do not allow the sequence.
    Unclear,
}

impl Claim {
    /// The point with another value of a variable.
    pub fn moved(base: &Base, variable: usize, value: Rational) -> Base {
        let mut moved = base.clone();
        moved.insert(variable, value);
        moved
    }

    pub fn is_inside(&self, base: &Base) -> bool {
        self.at(base, &|_: &mut AtPoint| Ok(true)) == At::Says(true)
    }

    /// How the value of a term at one point compares with that at another one.
    pub fn compared(&self, term: &Term, one: &Base, other: &Base) -> Option<Ordering> {
        BITS.into_iter().find_map(|bits| {
            let value = |base: &Base| self.place(base, bits)?.number(term).ok();
            value(one)?.minus(&value(other)?).ok()?.sign()
        })
    }

    /// Whether two points, which differ in one variable, show that the side does not rise (or fall) strictly. Points between them have
    /// to meet the conditions too: two ranges apart have nothing to do with each other.
    pub fn refutes_monotone(
        &self,
        side: &Term,
        comparison: Comparison,
        variable: usize,
        [one, other]: [&Base; 2],
    ) -> bool {
        let (low, high) = if one[&variable] < other[&variable] { (one, other) } else { (other, one) };
        let wanted = if comparison == Comparison::Less { Ordering::Greater } else { Ordering::Less };
        let is_refuted = self.compared(side, low, high).is_some_and(|order| order != wanted);
        is_refuted && low[&variable] != high[&variable] && self.is_one_range([low, high], variable)
    }

    fn is_one_range(&self, [low, high]: [&Base; 2], variable: usize) -> bool {
        let share = |part: u32| {
            let width = Rational::from(&high[&variable] - &low[&variable]);
            Self::moved(low, variable, width * part / 8_u32 + &low[&variable])
        };
        (0..=8).all(|part| self.is_inside(&share(part)))
    }

    /// Where a side tends as a variable goes to its end.
    pub fn tail(&self, side: &Term, goal: &Goal, variable: usize, toward: Toward, base: &Base) -> Tail {
        let sign = if toward == Toward::Zero { -1 } else { 1 };
        let mut distances: Vec<Ball> = Vec::new();
        let mut scale = Ball::from(1);
        for step in 1..=FAR {
            let far = Self::moved(base, variable, power_of_two(sign * 8 * step));
            if !self.is_inside(&far) {
                distances.clear();
                continue;
            }
            let Some(mut place) = self.place(&far, BITS[1]) else { return Tail::Unclear };
            let from = match goal {
                Goal::Value(value) => place.number(value),
                Goal::Infinity(_) => Ok(Number::whole(0)),
            };
            let (Ok(there), Ok(from)) = (place.number(side), from) else { return Tail::Unclear };
            let Ok(distance) = there.minus(&from) else { return Tail::Unclear };
            scale = from.ball(BITS[1]);
            distances.push(distance.ball(BITS[1]));
        }
        course(&distances, &scale, goal)
    }
}

/// What the last distances from a value show: they go to zero, to another number, or beyond all bounds.
fn course(distances: &[Ball], value: &Ball, goal: &Goal) -> Tail {
    if distances.len() <= LAST {
        return Tail::Unclear;
    }
    let last = &distances[distances.len() - LAST - 1..];
    let size = |ball: &Ball| [ball.lower().abs(), ball.upper().abs()];
    let largest = |ball: &Ball| {
        let [low, high] = size(ball);
        low.max(&high)
    };
    let smallest = |ball: &Ball| {
        if ball.contains_zero() {
            return rug::Float::new(53);
        }
        let [low, high] = size(ball);
        low.min(&high)
    };
    let steps: Vec<Ball> = last.windows(2).map(|pair| pair[1].clone() - &pair[0]).collect();
    let end = &last[LAST];
    let shrink = steps.windows(2).all(|pair| largest(&pair[1]) * 4_u32 <= largest(&pair[0]) * 3_u32);
    let final_step = largest(&steps[LAST - 1]);
    let bounded = || Tail::Elsewhere("stays bounded".into());
    // Steps that shrink by 3/4 or more sum to at most four times the last one.
    if shrink && smallest(end) > final_step.clone() * 8_u32 {
        let away = end.centre().to_string_radix(10, Some(6));
        let stays = || Tail::Elsewhere(format!("stays {away} away from it"));
        return if matches!(goal, Goal::Value(_)) { stays() } else { bounded() };
    }
    let grow = last.windows(2).all(|pair| smallest(&pair[1]) * 2_u32 >= largest(&pair[0]) * 3_u32);
    let bound = (largest(value) + 1_u32) << 64_u32;
    if grow && smallest(end) > bound {
        return match (end.sign(), goal) {
            (None, _) => Tail::Unclear,
            (Some(order), Goal::Infinity(wanted)) if order == *wanted => Tail::There,
            _ => Tail::Elsewhere("grows beyond all bounds".into()),
        };
    }
    let falls = last.windows(2).all(|pair| largest(&pair[1]) * 4_u32 <= largest(&pair[0]) * 3_u32);
    let near = (largest(value) + rug::Float::with_val(53, 1)) >> 40_u32;
    match goal {
        Goal::Value(_) if falls && largest(end) < near => Tail::There,
        Goal::Infinity(_) if falls && largest(end) < near => bounded(),
        _ => Tail::Unclear,
    }
}
