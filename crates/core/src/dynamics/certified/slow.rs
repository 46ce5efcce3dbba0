//! The slider while it sticks: the equations of x and y on the slow manifold.
//!
//! On an invariant manifold x' = ξ(x, y), y' = g, the equations require ξ = ξ_0 − εN(ξ) with ε = ηe^x, ξ_0 = κ(1 − e^x) − βg and
//! N(ξ) = ξ² + ξξ_x + gξ_y. The iterates ξ_{m+1} = ξ_0 − εN(ξ_m) end with ξ_n, n = [`CORRECTIONS`]. The slow equations are x' = ξ_n, y' = g.

use super::Constants;
use super::interval::Interval;
use super::jet::{exponents, inverse_factorial, place};
use super::lanes::{Lanes, product};
use super::step::{ORDER, Series, System};
use crate::friction::EvolutionLaw;

/// n, how often the slow manifold is corrected for inertia.
pub(super) const CORRECTIONS: usize = 3;

/// The slow equations of x and y in t.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slow<'c>(pub &'c Constants);

/// The Taylor coefficients in time of a function's derivatives by x and y, over factorials: one series for each [`place`].
type Field<const M: usize> = [[Lanes<M>; ORDER + 1]; (CORRECTIONS + 1) * (CORRECTIONS + 2) / 2];

/// Coefficient k of the product of two fields, at (i, j).
fn field_product<const M: usize>(a: &Field<M>, b: &Field<M>, (i, j): (usize, usize), k: usize) -> Lanes<M> {
    let mut sum = Lanes::ZERO;
    for p in 0..i + 1 {
        for q in 0..j + 1 {
            sum = sum + product(&a[place(p, q)], &b[place(i - p, j - q)], k);
        }
    }
    sum
}

/// The fields that the iterates are made of.
struct Fields<const M: usize> {
    velocity: Field<M>,
    inertia: Field<M>,
    state_rate: Field<M>,
    /// ξ_0, ξ_1, …
    rates: [Field<M>; CORRECTIONS + 1],
    /// ξ + ξ_x and ξ_y of each.
    growths: [Field<M>; CORRECTIONS],
    by_y: [Field<M>; CORRECTIONS],
    /// N of each.
    bends: [Field<M>; CORRECTIONS],
}

impl<const M: usize> Fields<M> {
    const fn new() -> Self {
        let blank: Field<M> = [[Lanes::ZERO; ORDER + 1]; (CORRECTIONS + 1) * (CORRECTIONS + 2) / 2];
        Self {
            velocity: blank,
            inertia: blank,
            state_rate: blank,
            rates: [blank; CORRECTIONS + 1],
            growths: [blank; CORRECTIONS],
            by_y: [blank; CORRECTIONS],
            bends: [blank; CORRECTIONS],
        }
    }

    /// Coefficient k of g, ξ_0, e^x and ε, from those of e^x, g and, for the aging law, e^{−y}.
    fn begin(&mut self, constants: &Constants, k: usize, [velocity, state_rate, healing]: [Lanes<M>; 3]) {
        for (i, j) in exponents(CORRECTIONS) {
            let index = place(i, j);
            let of_velocity = velocity.scaled(inverse_factorial(i));
            let of_state = match constants.law {
                _ if (i, j) == (0, 0) => state_rate,
                EvolutionLaw::Slip if j == 0 => {
                    state_rate.scaled(inverse_factorial(i)) - velocity.scaled(inverse_factorial(i - 1))
                }
                EvolutionLaw::Slip if j == 1 => -of_velocity,
                EvolutionLaw::Aging if j == 0 => -of_velocity,
                EvolutionLaw::Aging if i == 0 => {
                    let size = healing.scaled(inverse_factorial(j));
                    if j % 2 == 1 { -size } else { size }
                }
                _ => Lanes::ZERO,
            };
            let of_velocity = if j == 0 { of_velocity } else { Lanes::ZERO };
            let excess = if index + k == 0 { (-of_velocity).plus(Interval::ONE) } else { -of_velocity };
            self.velocity[index][k] = of_velocity;
            self.inertia[index][k] = of_velocity.scaled(constants.inertia);
            self.state_rate[index][k] = of_state;
            self.rates[0][index][k] =
                excess.scaled(constants.stiffness) - of_state.scaled(constants.effect_ratio);
        }
    }

    /// Coefficient k of ξ_n.
    fn corrected(&mut self, k: usize) -> Lanes<M> {
        for m in 0..CORRECTIONS {
            let degree = CORRECTIONS - 1 - m;
            for (i, j) in exponents(degree) {
                let rate = &self.rates[m];
                let by_x = rate[place(i + 1, j)][k].scaled(Interval::point((i + 1) as f64));
                self.growths[m][place(i, j)][k] = rate[place(i, j)][k] + by_x;
                self.by_y[m][place(i, j)][k] =
                    rate[place(i, j + 1)][k].scaled(Interval::point((j + 1) as f64));
            }
            for at in exponents(degree) {
                self.bends[m][place(at.0, at.1)][k] = field_product(&self.rates[m], &self.growths[m], at, k)
                    + field_product(&self.state_rate, &self.by_y[m], at, k);
            }
            for (i, j) in exponents(degree) {
                // ε depends on x only.
                let lag = (0..=i).fold(Lanes::ZERO, |sum, p| {
                    sum + product(&self.inertia[place(p, 0)], &self.bends[m][place(i - p, j)], k)
                });
                self.rates[m + 1][place(i, j)][k] = self.rates[0][place(i, j)][k] - lag;
            }
        }
        self.rates[CORRECTIONS][0][k]
    }
}

impl System<2, 3> for Slow<'_> {
    fn series<const M: usize>(&self, start: &[Lanes<M>; 2]) -> Series<M, 3> {
        let is_aging = self.0.law == EvolutionLaw::Aging;
        let mut out: Series<M, 3> = [[Lanes::ZERO; 3]; ORDER + 1];
        let mut fields = Fields::<M>::new();
        let [mut velocity, mut healing, mut sum, mut state_rate, mut rate] =
            [[Lanes::<M>::ZERO; ORDER + 1]; 5];
        out[0][..2].copy_from_slice(start);
        let [exponential, healed] = [start[0].lane(0).exp(), (-start[1].lane(0)).exp()];
        velocity[0] = Lanes::following(exponential, exponential, &start[0]);
        healing[0] = Lanes::following(healed, -healed, &start[1]);
        for k in 0..ORDER {
            let part = Interval::point((k + 1) as f64).reciprocal();
            if k > 0 {
                let part = Interval::point(k as f64).reciprocal();
                velocity[k] = product(&velocity, &rate, k - 1).scaled(part);
                healing[k] = -product(&healing, &state_rate, k - 1).scaled(part);
            }
            sum[k] = out[k][0] + out[k][1];
            state_rate[k] = if is_aging { healing[k] - velocity[k] } else { -product(&velocity, &sum, k) };
            fields.begin(self.0, k, [velocity[k], state_rate[k], healing[k]]);
            rate[k] = fields.corrected(k);
            let clock = if k == 0 { Lanes::ZERO.plus(Interval::ONE) } else { Lanes::ZERO };
            out[k + 1] = [rate[k].scaled(part), state_rate[k].scaled(part), clock];
        }
        out
    }
}
