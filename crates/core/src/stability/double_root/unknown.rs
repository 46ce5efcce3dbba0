//! The unknown group at the double root, from the double root to half its digits.
//!
//! With h(r) = r(e − r)/(1 + r) eq 8 is κ(1 + gr²) = h(r). As functions of r at the given group,
//!
//! * ∂ ln κ/∂r = −F(r)/(r(e − r)(1 + r)(1 + gr²)) at given g,
//! * ∂g/∂r = −F(r)/(κr³(1 + r)²) at given κ,
//!
//! up to the sign of F on the lower arc. F is zero at the double root. Between the centre of a ball of radius ϱ around the root and the root
//! itself |F| ≤ ϱ·max|F′|, so that the unknown at the centre is off by at most ϱ²·max|F′| over the smallest denominator.

use super::GivenGroup;
use super::enclosure::Enclosure;
use crate::number::{Ball, Field};
use crate::stability::Arc;

/// The factors of h at the centre of a ball around the double root; those that may be negative are so in pairs.
pub(super) struct Factors {
    /// r.
    root: Ball,
    /// 1 + r.
    next: Ball,
    /// e − r.
    rest: Ball,
}

impl Factors {
    /// On the lower arc, x = −1 − r, with the signs of all three turned: h keeps its sign, −r, −(1 + r) and β + x are positive.
    pub(super) fn of(arc: Arc, x: Ball, effect_ratio: &Ball, excess: &Ball) -> Self {
        let one = Ball::from(1);
        match arc {
            Arc::Upper => Self { next: x.clone() + one, rest: excess.clone() - &x, root: x },
            Arc::Lower => Self { root: x.clone() + one, rest: effect_ratio.clone() + &x, next: x },
        }
    }

    /// g at given κ; 1/κ at given g: eq 8 at this r.
    pub(super) fn unknown(self, given: GivenGroup, value: &Ball) -> Ball {
        let square = self.root.square();
        match given {
            GivenGroup::StiffnessGroup => {
                (self.root * &self.rest / (self.next * value) - Ball::from(1)) / square
            }
            GivenGroup::VelocitySquared => {
                (value.clone() * square + Ball::from(1)) * &self.next / (self.root * &self.rest)
            }
        }
    }

    /// Lower bounds of log2 of the magnitudes of r, 1 + r and e − r within a distance of the centre.
    fn exponents_within(&self, distance_log2: i64) -> Option<[i64; 3]> {
        let below = |factor: &Ball| factor.clone().widened(distance_log2).exponent_below();
        Some([below(&self.root)?, below(&self.next)?, below(&self.rest)?])
    }
}

/// g at given κ; 1/κ at given g.
pub(super) fn unknown(
    (arc, given): (Arc, GivenGroup),
    value: &Ball,
    (effect_ratio, excess): (&Ball, &Ball),
    found: &Enclosure,
) -> Option<Ball> {
    let centre = Ball::exact(found.root.centre().clone()).with_precision(value.precision_bits());
    let factors = Factors::of(arc, centre, effect_ratio, excess);
    let distance_log2 = found.root.radius_exponent();
    let [root, next, rest] = factors.exponents_within(distance_log2)?;
    let error_log2 = 2 * distance_log2 + found.slope.exponent_above();
    let group = factors.unknown(given, value);
    match given {
        GivenGroup::StiffnessGroup => {
            Some(group.widened(error_log2 - value.exponent_below()? - 3 * root - 2 * next))
        }
        GivenGroup::VelocitySquared => {
            // 1 + gr² is at least 1. A relative change of κ below 1/2 is doubled at most by exp and the inverse.
            let relative_log2 = error_log2 - root - next - rest + 2;
            let error_log2 = relative_log2 + group.exponent_above();
            (relative_log2 < -1).then(|| group.widened(error_log2))
        }
    }
}
