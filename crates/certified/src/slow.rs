//! The slider while it sticks: the equations of x and y on the slow manifold.
//!
//! On an invariant manifold x' = ξ(x, y), y' = g, the equations require ξ = ξ_0 − εN(ξ) with ε = ηe^x, ξ_0 = κ(1 − e^x) − βg and
//! N(ξ) = ξ² + ξξ_x + gξ_y. The iterates ξ_{m+1} = ξ_0 − εN(ξ_m) end with ξ_n, n = [`CORRECTIONS`]. The slow equations are x' = ξ_n, y' = g.

use crate::Constants;
use crate::interval::Interval;
use crate::jet::{CORRECTIONS, exponents, inverse_factorial, place};
use crate::lanes::{Factor, Lanes, product};
use crate::step::{ORDER, Series, System};
use slipmode_core::friction::EvolutionLaw;

/// The slow equations of x and y in t.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slow<'c>(pub &'c Constants);

/// How many derivatives up to a degree are multiplied, and how many ξ_0 has.
const FACTORS: usize = CORRECTIONS * (CORRECTIONS + 1) / 2;
const PLACES: usize = (CORRECTIONS + 1) * (CORRECTIONS + 2) / 2;

/// A function's derivatives by x and y, over factorials, one for each [`place`].
type Derivatives<const M: usize> = [Lanes<M>; PLACES];

/// The Taylor coefficients in time of those that are multiplied.
type Field<const M: usize> = [[Factor<M>; ORDER + 1]; FACTORS];

/// Coefficient k of the product of two fields, at (i, j).
#[inline(always)]
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
    inertia: Field<M>,
    state_rate: Field<M>,
    /// ξ_0, ξ_1, …
    rates: [Field<M>; CORRECTIONS],
    /// ξ + ξ_x and ξ_y of each.
    growths: [Field<M>; CORRECTIONS],
    by_y: [Field<M>; CORRECTIONS],
    /// N of each.
    bends: [Field<M>; CORRECTIONS],
}

impl<const M: usize> Fields<M> {
    const fn new() -> Self {
        let blank: Field<M> = [[Factor::ZERO; ORDER + 1]; FACTORS];
        Self {
            inertia: blank,
            state_rate: blank,
            rates: [blank; CORRECTIONS],
            growths: [blank; CORRECTIONS],
            by_y: [blank; CORRECTIONS],
            bends: [blank; CORRECTIONS],
        }
    }

    /// Coefficient k of g, ε and ξ_0, of which the last is returned, from those of e^x, g and, for the aging law, e^{−y}.
    #[inline(always)]
    fn begin(
        &mut self,
        constants: &Constants,
        k: usize,
        [velocity, state_rate, healing]: [Lanes<M>; 3],
    ) -> Derivatives<M> {
        let mut rate = [Lanes::ZERO; PLACES];
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
            if i + j < CORRECTIONS {
                self.inertia[index][k] = of_velocity.scaled(constants.inertia).into();
                self.state_rate[index][k] = of_state.into();
            }
            rate[index] = excess.scaled(constants.stiffness) - of_state.scaled(constants.effect_ratio);
        }
        rate
    }

    /// Coefficient k of ξ_n, from that of ξ_0.
    #[inline(always)]
    fn corrected(&mut self, k: usize, first: &Derivatives<M>) -> Lanes<M> {
        let mut rate = *first;
        for m in 0..CORRECTIONS {
            let degree = CORRECTIONS - 1 - m;
            for (i, j) in exponents(degree) {
                let at = place(i, j);
                let by_x = rate[place(i + 1, j)].scaled(Interval::point((i + 1) as f64));
                let by_y = rate[place(i, j + 1)].scaled(Interval::point((j + 1) as f64));
                self.rates[m][at][k] = rate[at].into();
                self.growths[m][at][k] = (rate[at] + by_x).into();
                self.by_y[m][at][k] = by_y.into();
            }
            for at in exponents(degree) {
                let bend = field_product(&self.rates[m], &self.growths[m], at, k)
                    + field_product(&self.state_rate, &self.by_y[m], at, k);
                self.bends[m][place(at.0, at.1)][k] = bend.into();
            }
            for (i, j) in exponents(degree) {
                // ε depends on x only.
                let mut lag = Lanes::ZERO;
                for p in 0..i + 1 {
                    lag = lag + product(&self.inertia[place(p, 0)], &self.bends[m][place(i - p, j)], k);
                }
                rate[place(i, j)] = first[place(i, j)] - lag;
            }
        }
        rate[0]
    }
}

impl System<2, 3> for Slow<'_> {
    #[inline(always)]
    fn expand<const M: usize>(&self, out: &mut Series<M, 3>) {
        let is_aging = self.0.law == EvolutionLaw::Aging;
        let mut fields = Fields::<M>::new();
        let [mut velocities, mut healings, mut sums, mut state_rates, mut rates] =
            [[Factor::<M>::ZERO; ORDER + 1]; 5];
        let [x, y] = [out[0][0], out[0][1]];
        let [exponential, healed] = [x.lane(0).exp(), (-y.lane(0)).exp()];
        let mut velocity = Lanes::following(exponential, exponential, &x);
        let mut healing = Lanes::following(healed, -healed, &y);
        for k in 0..ORDER {
            let part = Interval::point((k + 1) as f64).reciprocal();
            if k > 0 {
                let part = Interval::point(k as f64).reciprocal();
                velocity = product(&velocities, &rates, k - 1).scaled(part);
                healing = -product(&healings, &state_rates, k - 1).scaled(part);
            }
            let sum = out[k][0] + out[k][1];
            (velocities[k], healings[k], sums[k]) = (velocity.into(), healing.into(), sum.into());
            let state_rate = if is_aging { healing - velocity } else { -product(&velocities, &sums, k) };
            let first = fields.begin(self.0, k, [velocity, state_rate, healing]);
            let rate = fields.corrected(k, &first);
            (state_rates[k], rates[k]) = (state_rate.into(), rate.into());
            let clock = if k == 0 { Lanes::ZERO.plus(Interval::ONE) } else { Lanes::ZERO };
            out[k + 1] = [rate.scaled(part), state_rate.scaled(part), clock];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifold::Manifold;
    use crate::tests::members::Slider;

    const SLIDERS: [Slider; 2] = [
        Slider { inertia: 0.05, stiffness: 0.3, effect_ratio: 1.5, law: EvolutionLaw::Slip },
        Slider { inertia: 0.05, stiffness: 0.3, effect_ratio: 1.5, law: EvolutionLaw::Aging },
    ];

    const STATES: [[f64; 2]; 3] = [[-1.0, 1.3], [-0.5, 0.2], [-2.0, 1.5]];

    /// x' = ξ_n, which the manifold computes by polynomials in x and y, and y' = g.
    fn rates(slider: Slider, [x, y]: [f64; 2]) -> [f64; 2] {
        [Manifold::over(&slider.constants(), &[x, y].map(Interval::point)).rate.mid, slider.state_rate(x, y)]
    }

    fn series(slider: Slider, state: [f64; 2]) -> Series<4, 3> {
        let start = std::array::from_fn(|i| {
            Lanes::new(std::array::from_fn(|l| match l {
                0 => Interval::point(state[i]),
                _ if l == i + 1 => Interval::ONE,
                _ => Interval::ZERO,
            }))
        });
        Slow(&slider.constants()).series(&start)
    }

    /// The series over a time, without a remainder: it is small there.
    fn sum(series: &Series<4, 3>, component: usize, time: f64) -> f64 {
        series.iter().rev().fold(0.0, |sum, term| sum * time + term[component].lane(0).mid)
    }

    /// The first terms are the rates, and the sum of the series is the motion by Runge and Kutta's method; the clock runs evenly.
    #[test]
    fn the_series_is_the_motion_on_the_slow_manifold() {
        const PARTS: usize = 400;
        const TIME: f64 = 0.1;
        for (slider, state) in SLIDERS.into_iter().flat_map(|slider| STATES.map(|state| (slider, state))) {
            let series = series(slider, state);
            let first = rates(slider, state);
            assert!((0..2).all(|i| series[1][i].lane(0).widened(1e-12).may_contain(first[i])), "{first:?}");
            let (mut moved, h) = (state, TIME / PARTS as f64);
            for _ in 0..PARTS {
                let at = |rates: [f64; 2], h: f64| [moved[0] + h * rates[0], moved[1] + h * rates[1]];
                let first = rates(slider, moved);
                let second = rates(slider, at(first, 0.5 * h));
                let third = rates(slider, at(second, 0.5 * h));
                let fourth = rates(slider, at(third, h));
                let mean = |i: usize| (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]) / 6.0;
                moved = [moved[0] + h * mean(0), moved[1] + h * mean(1)];
            }
            for (i, moved) in moved.into_iter().enumerate() {
                let found = sum(&series, i, TIME);
                assert!((found - moved).abs() < 1e-11, "{slider:?} {state:?} {i} {found} {moved}");
            }
            assert!((sum(&series, 2, TIME) - TIME).abs() < 1e-15);
        }
    }

    /// The derivatives of each term by the initial state are limits of differences of the terms.
    #[test]
    fn the_derivatives_of_the_series_are_those_of_its_terms() {
        const BY: f64 = 1e-5;
        for (slider, state) in SLIDERS.into_iter().flat_map(|slider| STATES.map(|state| (slider, state))) {
            let middle = series(slider, state);
            for j in 0..2 {
                let moved = |by: f64| {
                    series(slider, std::array::from_fn(|i| state[i] + if i == j { by } else { 0.0 }))
                };
                let (before, after) = (moved(-BY), moved(BY));
                for k in 1..=6 {
                    for i in 0..2 {
                        let slope = (after[k][i].lane(0).mid - before[k][i].lane(0).mid) / (2.0 * BY);
                        let found = middle[k][i].lane(j + 1).mid;
                        let scale = 1.0 + slope.abs() + middle[k][i].lane(0).mid.abs();
                        assert!(
                            (found - slope).abs() < 1e-5 * scale,
                            "{slider:?} {state:?} {k} {i} {j} {found} {slope}"
                        );
                    }
                }
            }
        }
    }
}
