//! The whole slider in a time of its own, in which nothing is stiff and nothing is singular: dt = η e^x ds.
//!
//! With F = ζ − x − βy the equations are, for the slip law and the aging law,
//!
//! ```text
//! x_s = F      y_s = −η V² (x + y)  or  η (V e^{−y} − V²)      F_s = κ η (V − V²) − F − β y_s      V = e^x
//! ```
//!
//! F as a state avoids the cancellation in ζ − x − βy. An arrest, in which V falls by hundreds of decades, is a short motion in s.

use super::Constants;
use super::interval::Interval;
use super::lanes::{Lanes, product};
use super::step::{ORDER, Series, System};
use crate::friction::EvolutionLaw;
use crate::number::dispatch::{Kernel, run_on_widest_unit};

/// The equations of x, y and F in s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inertial<'c>(pub &'c Constants);

impl System<3, 4> for Inertial<'_> {
    fn series<const M: usize>(&self, start: &[Lanes<M>; 3]) -> Series<M, 4> {
        let mut out: Series<M, 4> = [[Lanes::ZERO; 4]; ORDER + 1];
        out[0][..3].copy_from_slice(start);
        run_on_widest_unit(Recursion { constants: self.0, out: &mut out });
        out
    }
}

/// The recursion of the coefficients, from those of order zero.
struct Recursion<'a, const M: usize> {
    constants: &'a Constants,
    out: &'a mut Series<M, 4>,
}

impl<const M: usize> Kernel for Recursion<'_, M> {
    #[inline(always)]
    fn run(self) {
        let Constants { inertia, stiffness, effect_ratio, law } = *self.constants;
        let out = self.out;
        let start = [out[0][0], out[0][1]];
        let blank = [Lanes::<M>::ZERO; ORDER + 1];
        let (mut velocity, mut square, mut sum, mut force, mut healing, mut relative) =
            (blank, blank, blank, blank, blank, blank);
        let exponential = start[0].lane(0).exp();
        velocity[0] = Lanes::following(exponential, exponential, &start[0]);
        let difference = start[0] - start[1];
        let healed = difference.lane(0).exp();
        healing[0] = Lanes::following(healed, healed, &difference);
        let spring = stiffness * inertia;
        for k in 0..ORDER {
            let part = Interval::ONE * Interval::point((k + 1) as f64).reciprocal();
            let [x, y, f, _] = out[k];
            (sum[k], force[k]) = (x + y, f);
            square[k] = product(&velocity, &velocity, k);
            let change = match law {
                EvolutionLaw::Slip => -product(&square, &sum, k),
                EvolutionLaw::Aging => healing[k] - square[k],
            };
            let state_rate = change.scaled(inertia);
            let force_rate = (velocity[k] - square[k]).scaled(spring) - f - state_rate.scaled(effect_ratio);
            out[k + 1] =
                [f, state_rate, force_rate, velocity[k].scaled(inertia)].map(|rate| rate.scaled(part));
            velocity[k + 1] = product(&force, &velocity, k).scaled(part);
            if law == EvolutionLaw::Aging {
                relative[k] = f - state_rate;
                healing[k + 1] = product(&relative, &healing, k).scaled(part);
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

    /// The derivative of these rates over a box.
    pub fn jacobian(&self, [x, y, _]: &[Interval; 3]) -> [[Interval; 3]; 3] {
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
