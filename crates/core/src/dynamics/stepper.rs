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

    /// The longest step whose error is permitted, where the method knows it before it tries; it may be infinite.
    fn foresee(&mut self, _model: &Model<R>, _from: &State<R>, _weight: Weight) -> Option<f64> {
        None
    }

    /// Tries one step; nothing when the nonlinear equations did not converge or a value left the number range.
    fn attempt(&mut self, model: &Model<R>, from: &State<R>, h: &R, weight: Weight) -> Option<Trial<R>>;

    /// Tells the method that the last trial was taken, so that the next may start from its polynomial. Methods without memory need not know.
    fn accept(&mut self) {}

    /// Forgets earlier steps, where there is a memory of them: the next one starts elsewhere.
    fn restart(&mut self) {}

    /// Prepares a repetition of the last trial with another length: its polynomial then starts the iteration.
    fn rewind(&mut self) {}

    /// The step polynomial of the last trial as an increment over its start: coefficients of θ, θ², …
    fn polynomial(&self) -> &[State<R>];

    /// The unit of ζ in which its errors count like those of x and y.
    fn stress_unit(&self) -> f64 {
        1.0
    }

    /// Right-hand sides evaluated so far.
    fn evaluations(&self) -> u64;

    /// Iterations that the last trial needed, over the number it is allowed: slow convergence calls for shorter steps. None without iteration.
    fn effort(&self) -> f64 {
        0.0
    }
}

/// Evaluates Σ c_k θ^{k+1}, the increment at θ (0 = start of the step, 1 = end).
#[must_use]
#[inline(always)]
pub fn increment<R: Scalar>(coefficients: &[State<R>], theta: &R) -> State<R> {
    let mut sum = [R::from(0), R::from(0), R::from(0)];
    for coefficient in coefficients.iter().rev() {
        for c in 0..3 {
            sum[c] = (sum[c].clone() + &coefficient[c]) * theta;
        }
    }
    sum
}

/// First and second derivative by θ of the increment of x.
pub(crate) fn velocity_slopes<R: Scalar>(coefficients: &[State<R>], theta: &R) -> (R, R) {
    let (mut slope, mut curvature) = (R::from(0), R::from(0));
    for (k, c) in coefficients.iter().enumerate().rev() {
        curvature = curvature * theta + &slope;
        slope = slope * theta + c[0].clone() * R::from(k as i32 + 1);
    }
    (slope, curvature)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slopes_of_a_cubic_are_its_derivatives() {
        // x = 2θ − 3θ² + θ³ at θ = 0.5.
        let polynomial = [[2.0, 0.0, 0.0], [-3.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
        assert_eq!(increment(&polynomial, &0.5), [0.375, 0.25, 0.0]);
        assert_eq!(velocity_slopes(&polynomial, &0.5), (-0.25, -3.0));
    }
}
