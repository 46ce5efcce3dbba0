//! Radau IIA with S stages: order 2S − 1, L-stable, stiffly accurate; simplified Newton in the modes of A^{-1}.
//!
//! The stage increments Z satisfy A^{-1} Z = h F(y + Z). In the modes W = T^{-1} Z this splits into one real and (S − 1)/2 complex
//! systems (λ − hJ) ΔW = T^{-1} h F − ΛW, each solved by the arrowhead elimination. Newton stops on the update: the
//! residual of x' is rounding noise magnified by e^{−x}/η in stick phases and says nothing.

use super::arrow::{Arrow, Factors};
use super::collocation::Collocation;
use super::stepper::{Stepper, Trial, Weight, increment};
use super::{Model, Scalar, State};
use crate::number::dispatch::{Kernel, run_on_widest_unit};
use crate::number::{Complex, Dd};

/// Newton iterations before a step is given up.
const MOST_ITERATIONS: u32 = 12;

/// Newton's update must fall below a part of the step's permitted error τ: at most this, and this many times √τ, because the
/// error of the method is that much smaller than its estimate.
const LARGEST_UPDATE_FRACTION: f64 = 1e-2;
const UPDATE_FRACTION_OF_ROOT: f64 = 0.1;

/// The method and the workspace of its last step.
#[derive(Debug, Clone)]
pub struct Radau<R, const S: usize> {
    constants: Collocation<R, S>,
    stages: [State<R>; S],
    /// Coefficients of the last trial's polynomial, and the step it belongs to.
    polynomial: [State<R>; S],
    step: R,
    /// The same for the last accepted step.
    previous: Option<([State<R>; S], R)>,
    rewound: bool,
    evaluations: u64,
    iterations: u32,
}

impl<R: Scalar, const S: usize> Radau<R, S> {
    /// The method with its constants in the number type R.
    #[must_use]
    pub fn new() -> Self {
        let zero = || std::array::from_fn(|_| std::array::from_fn(|_| R::from(0)));
        Self {
            constants: Collocation::new(),
            stages: zero(),
            polynomial: zero(),
            step: R::from(0),
            previous: None,
            rewound: false,
            evaluations: 0,
            iterations: 0,
        }
    }

    /// The increments of the stages of the last trial, and the constants of the method.
    pub(super) const fn last_stages(&self) -> (&[State<R>; S], &Collocation<R, S>) {
        (&self.stages, &self.constants)
    }

    /// Starts Newton's iteration on the last polynomial: extrapolated over a new step, interpolated for a repeated one.
    #[inline(always)]
    fn predict(&mut self, h: &R) {
        let rewound = std::mem::take(&mut self.rewound);
        let source = if rewound {
            Some((&self.polynomial, &self.step))
        } else {
            self.previous.as_ref().map(|p| (&p.0, &p.1))
        };
        let Some((polynomial, step)) = source else {
            self.stages = std::array::from_fn(|_| std::array::from_fn(|_| R::from(0)));
            return;
        };
        let offset = R::from(i32::from(!rewound));
        let origin = increment(polynomial, &offset);
        let ratio = h.clone() / step;
        for i in 0..S {
            let value = increment(polynomial, &(offset.clone() + ratio.clone() * &self.constants.nodes[i]));
            for c in 0..3 {
                self.stages[i][c] = value[c].clone() - &origin[c];
            }
        }
    }

    /// Solves for Newton's update of the modes.
    #[inline(always)]
    fn update(
        &mut self,
        model: &Model<R>,
        from: &State<R>,
        h: &R,
        factors: &StepFactors<R, S>,
        modes: &[State<R>; S],
    ) -> [State<R>; S] {
        let eigenvalues = &self.constants.eigenvalues;
        let pivot = eigenvalues[0].clone() + &factors.jacobian.xz;
        let mut derivatives = self.stages.clone();
        for (i, derivative) in derivatives.iter_mut().enumerate() {
            let state = sum(from, &self.stages[i]);
            let (rate, stiffness) = model.rate_and_stiffness(&state);
            // The row of x as a residual, scaled from the stiffness of its stage to that of the Jacobian.
            let mut residual = rate[0].clone() * h;
            for j in 0..S {
                residual = residual - self.constants.inverse[i][j].clone() * &self.stages[j][0];
            }
            let scale = pivot.clone() / (eigenvalues[0].clone() + stiffness * h);
            *derivative = [residual * scale, rate[1].clone() * h, rate[2].clone() * h];
        }
        self.evaluations += S as u64;
        let mut right = transform(&self.constants.to_modes, &derivatives);
        let rest = |c: usize| right[0][c].clone() - eigenvalues[0].clone() * &modes[0][c];
        let real = [right[0][0].clone(), rest(1), rest(2)];
        right[0] = factors.real.solve(&factors.jacobian, real);
        for m in (1..S).step_by(2) {
            let (re, im) = (&eigenvalues[m], &eigenvalues[m + 1]);
            // The pair (a, b) of modes acts as a − ib, on which A^{-1} is multiplication by λ.
            let rest = |c: usize| {
                let (a, b) = (&modes[m][c], &modes[m + 1][c]);
                Complex {
                    re: right[m][c].clone() - re.clone() * a - im.clone() * b,
                    im: re.clone() * b - im.clone() * a - &right[m + 1][c],
                }
            };
            let first = Complex { re: right[m][0].clone(), im: -right[m + 1][0].clone() };
            let residual = [first, rest(1), rest(2)];
            let solution = factors.pairs[m / 2].solve(&factors.jacobian, residual);
            for (c, d) in solution.into_iter().enumerate() {
                right[m][c] = d.re;
                right[m + 1][c] = -d.im;
            }
        }
        right
    }

    /// Newton's iteration on the stages; false when it does not converge.
    #[inline(always)]
    fn solve_stages(
        &mut self,
        model: &Model<R>,
        from: &State<R>,
        h: &R,
        factors: &StepFactors<R, S>,
        weight: Weight,
    ) -> bool {
        // Sums over the stages magnify the rounding errors of the state.
        let noise = weight.noise * (2 * S) as f64;
        let fraction = LARGEST_UPDATE_FRACTION.min(UPDATE_FRACTION_OF_ROOT * weight.absolute.sqrt());
        let target = (fraction * weight.absolute).max(noise);
        let mut modes = transform(&self.constants.to_modes, &self.stages);
        let mut last_size = f64::INFINITY;
        for iteration in 1..=MOST_ITERATIONS {
            self.iterations = iteration;
            let update = self.update(model, from, h, factors, &modes);
            let mut size = 0.0f64;
            for i in 0..S {
                let sum = weighted(&self.constants.from_modes[i], &update);
                for (c, d) in sum.into_iter().enumerate() {
                    size = larger(size, d.to_f64().abs());
                    self.stages[i][c] = self.stages[i][c].clone() + d;
                    modes[i][c] = modes[i][c].clone() + &update[i][c];
                }
            }
            let ratio = size / last_size;
            // With a contraction `ratio` the remaining error is size·ratio/(1 − ratio).
            let remaining = if iteration == 1 { size } else { size * ratio / (1.0 - ratio) };
            if ratio < 1.0 && remaining <= target || size <= noise {
                return true;
            }
            if !size.is_finite() || iteration > 1 && ratio >= 0.9 {
                // Updates that neither shrink nor matter are rounding errors of the rate.
                return size <= target;
            }
            last_size = size;
        }
        false
    }

    /// The estimated error, filtered by (λ0 − hJ)^{-1} so that it stays bounded for stiff components.
    #[inline(always)]
    fn estimate(
        &mut self,
        model: &Model<R>,
        from: &State<R>,
        h: &R,
        factors: &StepFactors<R, S>,
    ) -> State<R> {
        let real = self.constants.eigenvalues[0].clone();
        let weights = &self.constants.error_weights;
        let [x, y, zeta] = weighted(weights, &self.stages);
        let from_stages = [x * &real, y * &real, zeta * &real];
        let [x, y, zeta] = model.rate(from);
        self.evaluations += 1;
        let raw = sum(&[x * h, y * h, zeta * h], &from_stages);
        factors.real.solve(&factors.jacobian, raw)
    }
}

impl<R: Scalar, const S: usize> Default for Radau<R, S> {
    fn default() -> Self {
        Self::new()
    }
}

/// hJ and its factorisations for all eigenvalues of A^{-1}.
struct StepFactors<R, const S: usize> {
    jacobian: Arrow<R>,
    real: Factors<R>,
    /// One per pair; the rest of the array is never read.
    pairs: [Factors<Complex<R>>; S],
}

impl<R: Scalar, const S: usize> StepFactors<R, S> {
    #[inline(always)]
    fn new(eigenvalues: &[R; S], jacobian: Arrow<R>) -> Self {
        let real = Factors::new(&eigenvalues[0], &jacobian);
        let mut pairs = std::array::from_fn(|_| Factors::blank());
        for k in 0..S / 2 {
            let (re, im) = (eigenvalues[2 * k + 1].clone(), eigenvalues[2 * k + 2].clone());
            pairs[k] = Factors::new(&Complex { re, im }, &jacobian);
        }
        Self { jacobian, real, pairs }
    }
}

/// The larger of two sizes, or the second when one is not a number: such a one spreads to the last of the updates.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn transform<R: Scalar, const S: usize>(matrix: &[[R; S]; S], values: &[State<R>; S]) -> [State<R>; S] {
    let mut out = values.clone();
    for i in 0..S {
        out[i] = weighted(&matrix[i], values);
    }
    out
}

/// The sum of two states.
#[inline(always)]
fn sum<R: Scalar>(one: &State<R>, other: &State<R>) -> State<R> {
    let of = |c: usize| one[c].clone() + &other[c];
    [of(0), of(1), of(2)]
}

/// Σ m_i v_i; loops rather than closures, which the compiler leaves as calls.
#[inline(always)]
fn weighted<R: Scalar, const S: usize>(weights: &[R; S], values: &[State<R>; S]) -> State<R> {
    let [x, y, zeta] = &values[0];
    let mut sum = [weights[0].clone() * x, weights[0].clone() * y, weights[0].clone() * zeta];
    for i in 1..S {
        for c in 0..3 {
            sum[c] = sum[c].clone() + weights[i].clone() * &values[i][c];
        }
    }
    sum
}

/// One step, tried.
struct Attempt<'a, R, const S: usize> {
    method: &'a mut Radau<R, S>,
    model: &'a Model<R>,
    from: &'a State<R>,
    h: &'a R,
    weight: Weight,
    trial: &'a mut Option<Trial<R>>,
}

impl<R: Scalar, const S: usize> Kernel for Attempt<'_, R, S> {
    #[inline(always)]
    fn run(self) {
        let Self { method, model, from, h, weight, trial } = self;
        method.predict(h);
        // The Jacobian of the predicted middle of the step: in half the iterations of the one at its start.
        let centre = sum(from, &method.stages[S / 2]);
        let factors = StepFactors::new(
            &method.constants.eigenvalues,
            model.jacobian(&centre).map(|entry| entry.clone() * h),
        );
        if !method.solve_stages(model, from, h, &factors, weight) {
            return;
        }
        method.polynomial = transform(&method.constants.dense, &method.stages);
        method.step = h.clone();
        let estimate = method.estimate(model, from, h, &factors);
        let largest = estimate.iter().fold(0.0f64, |largest, e| largest.max(e.to_f64().abs()));
        let to = sum(from, &method.stages[S - 1]);
        let finite = to.iter().all(Scalar::is_finite) && largest.is_finite();
        *trial = finite.then(|| Trial { to, error: largest / weight.absolute });
    }
}

/// One copy for each method in use, compiled here: a generic one would be compiled again in each crate that runs it, as well as that crate is.
macro_rules! steppers {
    ($($number:ty, $stages:literal;)+) => {$(
        impl Stepper<$number> for Radau<$number, $stages> {
            const ERROR_EXPONENT: u32 = $stages + 1;

            fn attempt(&mut self, model: &Model<$number>, from: &State<$number>, h: &$number, weight: Weight) -> Option<Trial<$number>> {
                let mut trial = None;
                run_on_widest_unit(Attempt { method: self, model, from, h, weight, trial: &mut trial });
                trial
            }

            fn accept(&mut self) {
                self.previous = Some((self.polynomial.clone(), self.step.clone()));
            }

            fn restart(&mut self) {
                self.previous = None;
            }

            fn rewind(&mut self) {
                self.rewound = true;
            }

            fn polynomial(&self) -> &[State<$number>] {
                &self.polynomial
            }

            fn evaluations(&self) -> u64 {
                self.evaluations
            }

            fn effort(&self) -> f64 {
                f64::from(self.iterations) / f64::from(MOST_ITERATIONS)
            }
        }
    )+};
}

steppers!(f64, 3; f64, 5; f64, 7; Dd, 7;);
