//! The Taylor series of the solution, for times when nothing is stiff (η e^x ≫ the step).
//!
//! With u = e^x, w = e^{−x}, v = e^{−y} and q = ζ − x − βy every equation is a product or a linear combination, so all coefficients
//! follow from Cauchy products: u' = x'u, w' = −x'w, v' = −y'v, x' = qw/η, ζ' = κ(1 − u), y' = −u(x + y) or v − u.
//! (Jorba & Zou, *A software package for the numerical integration of ODEs by means of high-order Taylor methods*, 2005.)

use super::stepper::{Stepper, Trial, Weight};
use super::{Balance, Model, Scalar, State};
use crate::friction::EvolutionLaw;

/// The series of degree N − 1 of the last step; N is at least 4.
#[derive(Debug, Clone)]
pub struct Taylor<R, const N: usize> {
    polynomial: [State<R>; N],
    /// The series in time, and the state that it belongs to: a repeated or refused step needs no new one.
    series: [State<R>; N],
    origin: Option<State<R>>,
    evaluations: u64,
}

impl<R: Scalar, const N: usize> Taylor<R, N> {
    /// The method.
    #[must_use]
    pub fn new() -> Self {
        const { assert!(N >= 4) };
        let zero = || std::array::from_fn(|_| std::array::from_fn(|_| R::from(0)));
        Self { polynomial: zero(), series: zero(), origin: None, evaluations: 0 }
    }
}

impl<R: Scalar, const N: usize> Default for Taylor<R, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Σ_{i=0..=k} a_i b_{k−i}, in four sums that do not wait for each other.
#[inline(always)]
fn product<R: Scalar>(a: &[R], b: &[R], k: usize) -> R {
    let (a, b) = (&a[..=k], &b[..=k]);
    let mut sums = [R::from(0), R::from(0), R::from(0), R::from(0)];
    let (whole, rest) = a.as_chunks::<4>();
    let (_, reversed) = b.as_rchunks::<4>();
    for (four, back) in whole.iter().zip(reversed.iter().rev()) {
        for i in 0..4 {
            sums[i] = sums[i].clone() + four[i].clone() * &back[3 - i];
        }
    }
    for (sum, (a, b)) in sums.iter_mut().zip(rest.iter().zip(b[..rest.len()].iter().rev())) {
        *sum = sum.clone() + a.clone() * b;
    }
    let [first, second, third, fourth] = sums;
    (first + second) + (third + fourth)
}

/// Coefficients 1 … N of the solution through a state; `None` for models with another friction or without inertia.
fn series<R: Scalar, const N: usize>(model: &Model<R>, from: &State<R>) -> Option<[State<R>; N]> {
    if *model.balance() != Balance::Inertial {
        return None;
    }
    let groups = model.groups();
    let aging = model.law() == EvolutionLaw::Aging;
    let blank = || -> [R; N] { std::array::from_fn(|_| R::from(0)) };
    let (mut x, mut y, mut u, mut w, mut v, mut q, mut s) =
        (blank(), blank(), blank(), blank(), blank(), blank(), blank());
    // Coefficients of the derivatives x' and y'.
    let (mut x_slope, mut y_slope) = (blank(), blank());
    let rate = model.rate(from);
    (x[0], y[0]) = (from[0].clone(), from[1].clone());
    (u[0], w[0]) = (from[0].exponentials().0, (-from[0].clone()).exponentials().0);
    v[0] = (-from[1].clone()).exponentials().0;
    q[0] = model.imbalance(from);
    s[0] = x[0].clone() + &y[0];
    let mut out: [State<R>; N] = std::array::from_fn(|_| std::array::from_fn(|_| R::from(0)));
    for k in 0..N - 1 {
        let part = R::from(1) / R::from(k as i32 + 1);
        // Order zero comes from the model, which forms differences from 1 without cancellation.
        let [dx, dy, dz] = if k == 0 {
            rate.clone()
        } else {
            let dy = if aging { v[k].clone() - &u[k] } else { -product(&u, &s, k) };
            [product(&q, &w, k) * model.inverse_inertia(), dy, -(groups.stiffness_group.clone() * &u[k])]
        };
        x[k + 1] = dx.clone() * &part;
        y[k + 1] = dy.clone() * &part;
        let zeta = dz * &part;
        (x_slope[k], y_slope[k]) = (dx, dy);
        u[k + 1] = product(&x_slope, &u, k) * &part;
        w[k + 1] = -(product(&x_slope, &w, k) * &part);
        if aging {
            v[k + 1] = -(product(&y_slope, &v, k) * &part);
        }
        s[k + 1] = x[k + 1].clone() + &y[k + 1];
        q[k + 1] = zeta.clone() - &x[k + 1] - groups.effect_ratio.clone() * &y[k + 1];
        out[k] = [x[k + 1].clone(), y[k + 1].clone(), zeta];
    }
    Some(out)
}

impl<R: Scalar, const N: usize> Stepper<R> for Taylor<R, N> {
    const ERROR_EXPONENT: u32 = N as u32 - 2;

    fn attempt(&mut self, model: &Model<R>, from: &State<R>, h: &R, weight: Weight) -> Option<Trial<R>> {
        if self.origin.as_ref() != Some(from) {
            self.series = series(model, from)?;
            self.origin = Some(from.clone());
            self.evaluations += N as u64 - 1;
        }
        let mut power = R::from(1);
        for k in 0..N - 1 {
            power = power * h;
            self.polynomial[k] = std::array::from_fn(|c| self.series[k][c].clone() * &power);
        }
        // The last two terms bound the rest of a series that converges.
        let last =
            |k: usize| self.polynomial[k].iter().fold(0.0f64, |largest, e| largest.max(e.to_f64().abs()));
        let largest = last(N - 2).max(last(N - 3));
        let to: State<R> = std::array::from_fn(|c| {
            self.polynomial.iter().rev().fold(R::from(0), |sum, term| sum + &term[c]) + &from[c]
        });
        let finite = to.iter().all(Scalar::is_finite) && largest.is_finite();
        finite.then(|| Trial { to, error: largest / weight.absolute })
    }

    fn polynomial(&self) -> &[State<R>] {
        &self.polynomial
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
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
            let terms = series::<f64, 16>(&model, &from).unwrap();
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
    fn a_model_without_inertia_is_declined() {
        let groups = Groups { inertial_parameter: 3.0, stiffness_group: 2.0, effect_ratio: 1.5 };
        let model = Model::with_balance(groups, EvolutionLaw::Slip, Balance::QuasiStatic);
        assert!(series::<f64, 8>(&model, &[0.1, 0.0, 0.1]).is_none());
    }
}
