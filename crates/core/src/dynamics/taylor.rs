//! The Taylor series of the solution, for times when nothing is stiff (η e^x ≫ the step).
//!
//! The coefficients are those of `taylor_series`; the length of a step follows from the last two before it is tried.
//! (Jorba & Zou, *A software package for the numerical integration of ODEs by means of high-order Taylor methods*, 2005.)

use super::taylor_series::series;
use super::{Model, Scalar, State, Stepper, Trial, Weight};

/// The series of degree N − 1 of the last step; N is at least 4.
#[derive(Debug, Clone)]
pub struct Taylor<R, const N: usize> {
    polynomial: [State<R>; N],
    /// The series in time, and the state that it belongs to: a repeated or refused step needs no new one.
    series: [State<R>; N],
    origin: Option<State<R>>,
    /// e^{−x}/η there.
    stiffness: f64,
    stress_unit: f64,
    evaluations: u64,
}

impl<R: Scalar, const N: usize> Taylor<R, N> {
    /// The method.
    #[must_use]
    pub fn new() -> Self {
        const { assert!(N >= 4) };
        let zero = || std::array::from_fn(|_| std::array::from_fn(|_| R::from(0)));
        Self {
            polynomial: zero(),
            series: zero(),
            origin: None,
            stiffness: 0.0,
            stress_unit: 1.0,
            evaluations: 0,
        }
    }

    /// The same with another unit of ζ for errors. An oscillation at √(K/M) moves ζ √(κη) times as far as ln V: in units of 1 the rounding errors
    /// of a large ζ would be all that is permitted for ln V.
    pub(crate) fn with_stress_unit(self, stress_unit: f64) -> Self {
        Self { stress_unit, ..self }
    }

    /// Makes the series belong to a state.
    fn expand(&mut self, model: &Model<R>, from: &State<R>) -> Option<()> {
        if self.origin.as_ref() != Some(from) {
            self.origin = None;
            self.stiffness = series(model, from, &mut self.series)?;
            self.origin = Some(from.clone());
            self.evaluations += N as u64 - 1;
        }
        Some(())
    }
}

impl<R: Scalar, const N: usize> Default for Taylor<R, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// log2 of a positive number to 0.009: the exponent, and a parabola for the rest. Of zero about −1023, of infinity 1024.
#[inline(always)]
fn rough_log2(value: f64) -> f64 {
    let bits = value.to_bits();
    let exponent = (bits >> 52) as i32 - 1023;
    let excess = f64::from_bits((bits & (u64::MAX >> 12)) | (1023 << 52)) - 1.0;
    f64::from(exponent) + excess + excess * (1.0 - excess) * 0.345
}

/// The largest component of a term, with ζ in its unit.
#[inline(always)]
fn size<R: Scalar>(term: &State<R>, stress_unit: f64) -> f64 {
    let [x, y, stress] = term.each_ref().map(|component| component.to_f64().abs());
    x.max(y).max(stress / stress_unit)
}

impl<R: Scalar, const N: usize> Stepper<R> for Taylor<R, N> {
    const ERROR_EXPONENT: u32 = N as u32 - 2;

    /// Both of the last two terms at a part of what is permitted, or less: no step is tried that would be refused.
    fn foresee(&mut self, model: &Model<R>, from: &State<R>, weight: Weight) -> Option<f64> {
        /// log2 of the part, less twice what the logarithms err by.
        const PART: f64 = -0.15;
        self.expand(model, from)?;
        let permitted = rough_log2(weight.absolute) + PART;
        let [last, second, third] =
            [1, 2, 3].map(|back| rough_log2(size(&self.series[N - 1 - back], self.stress_unit)));
        let [by_last, by_second] = [(last, N - 1), (second, N - 2)].map(|(c, k)| (permitted - c) / k as f64);
        // The last terms bound the rest only where terms fall: by half from each to the next.
        let by_fall = (third - last) / 2.0 - 1.0;
        let length = (by_last.min(by_second).min(by_fall) * std::f64::consts::LN_2).exponentials().0;
        // Σ z^k/k! to degree n decays for real z > −n/3 (n ≥ 3): what a stiff force has damped stays damped.
        Some(length.min((N - 1) as f64 / (3.0 * self.stiffness)))
    }

    fn attempt(&mut self, model: &Model<R>, from: &State<R>, h: &R, weight: Weight) -> Option<Trial<R>> {
        self.expand(model, from)?;
        let mut power = R::from(1);
        // Terms of odd and of even degree in two sums that do not wait for each other.
        let mut sums = [(); 2].map(|()| from.clone().map(|_| R::from(0)));
        for k in 0..N - 1 {
            power = power * h;
            self.polynomial[k] = std::array::from_fn(|c| self.series[k][c].clone() * &power);
        }
        for k in (0..N - 1).rev() {
            for (sum, term) in sums[k % 2].iter_mut().zip(&self.polynomial[k]) {
                *sum = sum.clone() + term;
            }
        }
        // The last two terms bound the rest of a series that converges.
        let [last, second] = [2, 3].map(|back| size(&self.polynomial[N - back], self.stress_unit));
        let largest = last.max(second);
        let [odd, even] = sums;
        let to: State<R> = std::array::from_fn(|c| odd[c].clone() + &even[c] + &from[c]);
        let finite = to.iter().all(Scalar::is_finite) && largest.is_finite();
        finite.then(|| Trial { to, error: largest / weight.absolute })
    }

    fn polynomial(&self) -> &[State<R>] {
        &self.polynomial[..N - 1]
    }

    fn stress_unit(&self) -> f64 {
        self.stress_unit
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{Control, Integrator};
    use crate::friction::{EvolutionLaw, Groups};

    #[test]
    fn a_foreseen_step_is_never_refused_and_twice_as_much_would_be() {
        let groups = Groups { inertial_parameter: 1500.0, stiffness_group: 1.7, effect_ratio: 0.7 };
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups.clone(), law);
            let control = Control { local_tolerance: 1e-8, most_steps: 10_000 };
            let method = Taylor::<f64, 16>::new();
            let mut run = Integrator::new(&model, method, [-2.0, 2.0, -0.7], control).unwrap();
            while run.time() < 500.0 {
                run.advance(None).unwrap();
            }
            assert_eq!(run.step_counts().1, 0);
            let weight = run.weight(run.state());
            let mut method = Taylor::<f64, 16>::new();
            let length = method.foresee(&model, run.state(), weight).unwrap();
            let mut error = |h: f64| method.attempt(&model, run.state(), &h, weight).unwrap().error;
            assert!(error(length) < 1.0 && error(2.0 * length) > 1.0, "{law:?}");
        }
    }

    #[test]
    fn the_rough_logarithm_keeps_its_bound() {
        for i in 0..10_000 {
            let value = libm::exp10(0.06 * f64::from(i) - 300.0);
            assert!((rough_log2(value) - libm::log2(value)).abs() < 0.009, "{value:e}");
        }
    }
}
