//! The Taylor coefficients of the solution through a state, by recurrences that a machine need not wait for.
//!
//! With u = e^x = u_0 U, v = e^{−y} and q = ζ − x − βy every equation is a product or a linear combination, so all coefficients follow from
//! Cauchy products. V itself obeys a linear equation, u' = q/η, so that two products are enough: U x' = U' = q/(ηu_0), solved for the
//! newest coefficient of x' because U_0 = 1, and y' = −u_0 U(x + y), or y' = v − u_0 U with v' = −y'v; ζ' = κ(1 − u_0 U).

use super::{Balance, Model, Scalar, State};
use crate::friction::EvolutionLaw;

/// The recurrences of at most so many coefficients are written out.
const WRITTEN_OUT: usize = 24;

/// Σ_{i=1..=k} a_i b_{k−i} of two pairs of series at once, lane by lane, in two sums that do not wait for each other; the newest
/// coefficients of b, which the machine has to wait for, come last.
#[inline(always)]
fn products<R: Scalar>(a: &[[R; 2]], b: &[[R; 2]], k: usize) -> [R; 2] {
    let zero = || [R::from(0), R::from(0)];
    let (mut even, mut odd) = (zero(), zero());
    let (a, b) = (&a[1..=k], &b[..k]);
    let plus = |sum: &mut [R; 2], a: &[R; 2], b: &[R; 2]| {
        *sum = std::array::from_fn(|lane| sum[lane].clone() + a[lane].clone() * &b[lane]);
    };
    let (single, pairs) = a.as_rchunks::<2>();
    let (reversed, last) = b.as_chunks::<2>();
    for (a, b) in pairs.iter().rev().zip(reversed) {
        plus(&mut even, &a[1], &b[0]);
        plus(&mut odd, &a[0], &b[1]);
    }
    for (a, b) in single.iter().zip(last) {
        plus(&mut even, a, b);
    }
    let ([e0, e1], [o0, o1]) = (even, odd);
    [e0 + o0, e1 + o1]
}

/// The recurrences between two orders.
struct Recurrence<'m, R, const N: usize> {
    model: &'m Model<R>,
    /// e^x, e^{−x}/η and −κe^x of the state.
    velocity: R,
    stiffness: R,
    loading: R,
    /// (U, U) or (U, v one order earlier), and (x', x + y) or (x', y').
    left: [[R; 2]; N],
    right: [[R; 2]; N],
    /// The newest coefficients: of the slopes, q, x + y and v.
    slopes: State<R>,
    imbalance: R,
    sum: R,
    healing: R,
}

impl<'m, R: Scalar, const N: usize> Recurrence<'m, R, N> {
    /// Order zero comes from the model, which forms differences from 1 without cancellation.
    #[inline(always)]
    fn new(model: &'m Model<R>, from: &State<R>) -> Self {
        let blank = || -> [[R; 2]; N] { std::array::from_fn(|_| std::array::from_fn(|_| R::from(0))) };
        let (slopes, stiffness) = model.rate_and_stiffness(from);
        let velocity = from[0].exponentials().0;
        Self {
            model,
            loading: -(model.groups().stiffness_group.clone() * &velocity),
            velocity,
            stiffness,
            left: blank(),
            right: blank(),
            slopes,
            imbalance: model.imbalance(from),
            sum: from[0].clone() + &from[1],
            healing: (-from[1].clone()).exponentials().0,
        }
    }

    /// Coefficient k of the solution, from all below; makes those of the slopes.
    #[inline(always)]
    fn order(&mut self, k: usize) -> State<R> {
        let is_aging = self.model.law() == EvolutionLaw::Aging;
        let part = R::from(1) / R::from(k as i32);
        let [dx, dy, dz] = self.slopes.clone();
        let [x, y, z] = [dx.clone() * &part, dy.clone() * &part, dz * &part];
        let u = self.stiffness.clone() * &self.imbalance * &part;
        self.right[k - 1] = [dx, if is_aging { dy } else { self.sum.clone() }];
        self.left[k] = [u.clone(), if is_aging { self.healing.clone() } else { u.clone() }];
        let [of_velocity, of_state] = products(&self.left, &self.right, k);
        self.imbalance = z.clone() - &x - self.model.groups().effect_ratio.clone() * &y;
        self.sum = x.clone() + &y;
        let state_slope = if is_aging {
            self.healing = -(of_state * &part);
            self.healing.clone() - self.velocity.clone() * &u
        } else {
            -(self.velocity.clone() * (self.sum.clone() + of_state))
        };
        let velocity_slope = self.stiffness.clone() * &self.imbalance - of_velocity;
        self.slopes = [velocity_slope, state_slope, self.loading.clone() * &u];
        [x, y, z]
    }
}

/// Makes each of these coefficients below N, written out one after the other.
macro_rules! written_out {
    ($out:ident, $recurrence:ident: $($k:literal)+) => {
        $(if $k < N { $out[$k - 1] = $recurrence.order($k); })+
    };
}

/// Coefficients 1 … N − 1 of the solution through a state, and e^{−x}/η, the fastest rate when it is large; `None` for another friction.
pub(super) fn series<R: Scalar, const N: usize>(
    model: &Model<R>,
    from: &State<R>,
    out: &mut [State<R>; N],
) -> Option<f64> {
    if model.balance != Balance::Inertial {
        return None;
    }
    let mut recurrence = Recurrence::<R, N>::new(model, from);
    let stiffness = recurrence.stiffness.to_f64();
    if N <= WRITTEN_OUT {
        // A machine guesses the ends of loops of one, two, three … terms wrongly, which costs as much as the terms.
        written_out!(out, recurrence: 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
    } else {
        (1..N).for_each(|k| out[k - 1] = recurrence.order(k));
    }
    Some(stiffness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Groups;

    #[test]
    fn the_series_solves_the_equations_to_its_order() {
        let groups = Groups { inertial_parameter: 3.0, stiffness_group: 2.0, effect_ratio: 1.5 };
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups.clone(), law);
            let from = [0.3, -0.2, 0.1];
            let mut terms = [[0.0; 3]; 16];
            series(&model, &from, &mut terms).unwrap();
            // At t = 0.05 the derivative of the series and the rate of its value differ by the sixteenth power of t.
            let t = 0.05;
            let value: State<f64> = std::array::from_fn(|c| {
                terms.iter().rev().fold(0.0, |sum, term| (sum + term[c]) * t) + from[c]
            });
            let rate = model.rate(&value);
            for c in 0..3 {
                let slope = terms
                    .iter()
                    .enumerate()
                    .rev()
                    .fold(0.0, |sum, (k, term)| sum * t + (k + 1) as f64 * term[c]);
                assert!((slope - rate[c]).abs() < 1e-14, "{law:?} {c}: {slope} {}", rate[c]);
            }
        }
    }

    #[test]
    fn the_regularised_friction_is_declined() {
        let groups = Groups { inertial_parameter: 3.0, stiffness_group: 2.0, effect_ratio: 1.5 };
        let model = Model::with_balance(groups, EvolutionLaw::Slip, Balance::Regularised(60.0));
        assert!(series(&model, &[0.1, 0.0, 0.1], &mut [[0.0; 3]; 8]).is_none());
    }
}
