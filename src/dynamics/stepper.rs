//! What the adaptive driver asks of a one-step method.

use super::{Model, Scalar, State};

/// A trial step: where it ends, and the estimate of its error in units of the permitted one.
#[derive(Debug, Clone)]
pub struct Trial<R> {
    /// The state at the end of the step.
    pub to: State<R>,
    /// Largest component of the estimated error over the weight; at most 1 when the step is good.
    pub error: f64,
}

/// How exact a step must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// Permitted local error of x, y and ζ, absolute.
    pub absolute: f64,
    /// Rounding noise in the state: no update below it carries information.
    pub noise: f64,
}

/// A one-step method with an error estimate and a step polynomial.
pub trait Stepper<R: Scalar> {
    /// The estimated local error is proportional to this power of the step.
    const ERROR_EXPONENT: u32;

    /// Tries one step; nothing when the nonlinear equations did not converge or a value left the number range.
    fn attempt(&mut self, model: &Model<R>, from: &State<R>, h: &R, weight: Weight) -> Option<Trial<R>>;

    /// Tells the method that the last trial was taken, so that the next may start from its polynomial.
    fn accept(&mut self);

    /// Forgets earlier steps: the next one starts elsewhere.
    fn restart(&mut self);

    /// The step polynomial of the last trial at θ (0 = start, 1 = end), as the increment over the start.
    fn increment(&self, theta: &R) -> State<R>;

    /// Derivative of the increment of x by θ.
    fn velocity_slope(&self, theta: &R) -> R;

    /// Right-hand sides evaluated so far.
    fn evaluations(&self) -> u64;

    /// Iterations that the last trial needed, over the number it is allowed: slow convergence calls for shorter steps.
    fn effort(&self) -> f64;
}

/// Evaluates Σ c_k θ^{k+1} of a polynomial without constant term.
pub(super) fn without_constant<R: Scalar>(coefficients: &[State<R>], theta: &R) -> State<R> {
    std::array::from_fn(|i| coefficients.iter().rev().fold(R::from(0), |sum, c| (sum + &c[i]) * theta))
}

/// Derivative of component 0 of such a polynomial.
pub(super) fn slope_of_first<R: Scalar>(coefficients: &[State<R>], theta: &R) -> R {
    let terms = coefficients.iter().enumerate().rev();
    terms.fold(R::from(0), |sum, (k, c)| sum * theta + c[0].clone() * R::from(k as i32 + 1))
}
