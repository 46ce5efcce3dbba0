//! The whole slider in a time of its own, in which nothing is stiff and nothing is singular: dt = η e^x ds.
//!
//! With F = ζ − x − βy the equations are, for the slip law and the aging law,
//!
//! ```text
//! x_s = F      y_s = −η V² (x + y)  or  η (V e^{−y} − V²)      F_s = κ η (V − V²) − F − β y_s      V = e^x
//! ```
//!
//! F as a state avoids the cancellation in ζ − x − βy. An arrest, in which V falls by hundreds of decades, is a short motion in s.

use crate::Constants;
use crate::interval::Interval;
use crate::lanes::{Factor, Lanes, product};
use crate::linear::Square;
use crate::step::{ORDER, Series, System};
use slipmode_core::friction::EvolutionLaw;

/// The equations of x, y and F in s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inertial<'c>(pub &'c Constants);

impl System<3, 4> for Inertial<'_> {
    #[inline(always)]
    fn expand<const M: usize>(&self, out: &mut Series<M, 4>) {
        let Constants { inertia, stiffness, effect_ratio, law } = *self.0;
        let start = [out[0][0], out[0][1]];
        let [mut velocities, mut forces, mut firsts, mut seconds] = [[Factor::<M>::ZERO; ORDER + 1]; 4];
        let exponential = start[0].lane(0).exp();
        let mut velocity = Lanes::following(exponential, exponential, &start[0]);
        let difference = start[0] - start[1];
        let healed = difference.lane(0).exp();
        let mut healing = Lanes::following(healed, healed, &difference);
        let spring = stiffness * inertia;
        for k in 0..ORDER {
            let part = Interval::ONE * Interval::point((k + 1) as f64).reciprocal();
            let [x, y, f, _] = out[k];
            (velocities[k], forces[k]) = (velocity.into(), f.into());
            let square = product(&velocities, &velocities, k);
            let change = match law {
                EvolutionLaw::Slip => {
                    (firsts[k], seconds[k]) = (square.into(), (x + y).into());
                    -product(&firsts, &seconds, k)
                }
                EvolutionLaw::Aging => healing - square,
            };
            let state_rate = change.scaled(inertia);
            let force_rate = (velocity - square).scaled(spring) - f - state_rate.scaled(effect_ratio);
            let clock_rate = velocity.scaled(inertia);
            out[k + 1] =
                [f.scaled(part), state_rate.scaled(part), force_rate.scaled(part), clock_rate.scaled(part)];
            velocity = product(&forces, &velocities, k).scaled(part);
            if law == EvolutionLaw::Aging {
                (firsts[k], seconds[k]) = ((f - state_rate).into(), healing.into());
                healing = product(&firsts, &seconds, k).scaled(part);
            }
        }
    }
}

impl Inertial<'_> {
    /// The rates of x, y and F in s over a box.
    pub fn rates(&self, [x, y, f]: &[Interval; 3]) -> [Interval; 3] {
        let Constants { inertia, stiffness, effect_ratio, law } = *self.0;
        let velocity = x.exp();
        let square = velocity * velocity;
        let change = match law {
            EvolutionLaw::Slip => -(square * (*x + *y)),
            EvolutionLaw::Aging => (*x - *y).exp() - square,
        };
        let state_rate = inertia * change;
        [*f, state_rate, stiffness * inertia * (velocity - square) - *f - effect_ratio * state_rate]
    }

    /// The rates over a box, and their derivative.
    pub fn over(&self, at: &[Interval; 3]) -> ([Interval; 3], Square<3>) {
        (self.rates(at), self.jacobian(at))
    }

    /// The derivative of the rates over a box.
    pub fn jacobian(&self, [x, y, _]: &[Interval; 3]) -> Square<3> {
        let Constants { inertia, stiffness, effect_ratio, law } = *self.0;
        let velocity = x.exp();
        let square = velocity * velocity;
        let two = Interval::point(2.0);
        let [by_x, by_y] = match law {
            EvolutionLaw::Slip => [-(square * (two * (*x + *y) + Interval::ONE)), -square],
            EvolutionLaw::Aging => {
                let healing = (*x - *y).exp();
                [healing - two * square, -healing]
            }
        };
        let [by_x, by_y] = [inertia * by_x, inertia * by_y];
        let loading = stiffness * inertia * (velocity - two * square);
        let zero = Interval::ZERO;
        [
            [zero, zero, Interval::ONE],
            [by_x, by_y, zero],
            [loading - effect_ratio * by_x, -(effect_ratio * by_y), -Interval::ONE],
        ]
    }
}
