//! One root finder for 64-bit and double-double, with a forward error bound for every root.
//!
//! A real root t comes from Kahan's iteration (*To solve a real cubic equation*, 1986). The other two solve
//! c3x² + ux + w with w = −c0/t and u from the better of the two deflations. Departing from Kahan, the quadratic's
//! discriminant is not u² − 4c3w, which cancels next to a double root, but Δ/F'(t)², so that it is as good as Δ.
//!
//! Bounds are evaluated in 64-bit; their own rounding (some dozens of operations, 1e-14) is covered by [`SLACK`].

mod branchless;

use super::discriminant::{discriminant, discriminant_of_magnitudes};
use super::kahan::kahan_root;
use crate::number::{Dd, Real};

/// Covers the rounding of the bounds themselves, and the second order of their first-order terms (each below 1/100).
const SLACK: f64 = 1.05;

/// An arithmetic with a known relative error per operation.
pub trait Working: Real + Copy + From<f64> {
    /// Bound on the relative error of one operation.
    const UNIT: f64;
    /// Newton steps that bring a 64-bit root to this precision.
    const POLISHING_STEPS: u32;
    /// The number rounded to 64-bit.
    fn leading(self) -> f64;
}

impl Working for f64 {
    const UNIT: f64 = f64::EPSILON / 2.0;
    const POLISHING_STEPS: u32 = 0;
    #[inline(always)]
    fn leading(self) -> f64 {
        self
    }
}

impl Working for Dd {
    const UNIT: f64 = Dd::UNIT;
    const POLISHING_STEPS: u32 = 2;
    #[inline(always)]
    fn leading(self) -> f64 {
        self.hi()
    }
}

/// A number with a bound on its absolute error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounded<R> {
    /// The computed value.
    pub value: R,
    /// |computed − true| is at most this; infinite when nothing is known.
    pub error: f64,
}

/// The roots besides the first real one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pair<R> {
    /// Two real roots, ascending.
    Real([Bounded<R>; 2]),
    /// A complex pair re ± i·im, im > 0.
    Complex {
        /// The common real part.
        re: Bounded<R>,
        /// The positive imaginary part.
        im: Bounded<R>,
    },
    /// This precision cannot tell a double root, two real roots and a pair apart, or cannot bound them.
    NotSeparated,
}

/// The roots of a cubic with forward error bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spectrum<R> {
    /// A real root: the one farthest from the inflection point.
    pub real: Bounded<R>,
    /// The other two.
    pub pair: Pair<R>,
}

pub use branchless::BranchlessRoots;

/// A cubic whose coefficients are known to `relative_error` of the given magnitudes (which are ≥ |coefficient|).
#[derive(Debug, Clone, Copy)]
pub struct BoundedCubic<R> {
    pub coefficients: [R; 4],
    pub magnitudes: [f64; 4],
    pub relative_error: f64,
}

/// The roots of a cubic whose coefficients are exactly these numbers.
///
/// A coefficient may exceed its leading part by half a unit of it; the relative error has room for that.
#[must_use]
pub fn bounded_roots<R: Working>(coefficients: [R; 4]) -> Spectrum<R> {
    let magnitudes = coefficients.map(|coefficient| coefficient.leading().abs());
    BoundedCubic { coefficients, magnitudes, relative_error: 0.0 }.spectrum()
}

impl<R: Working> BoundedCubic<R> {
    /// Δ with its error bound.
    ///
    /// Each of its five terms is a product of four coefficients, with at most 12 operations on the way of any of them.
    #[inline(always)]
    pub fn discriminant(&self) -> Bounded<R> {
        let terms = discriminant_of_magnitudes(&self.magnitudes);
        let error = terms * (4.0 * self.relative_error + 12.0 * R::UNIT) * SLACK;
        Bounded { value: discriminant(&self.coefficients), error }
    }

    /// All roots with forward error bounds.
    pub fn spectrum(&self) -> Spectrum<R> {
        let real = self.outermost_root();
        let slope = self.slope(real.value);
        let pair = self.pair(&real, slope).unwrap_or(Pair::NotSeparated);
        Spectrum { real, pair }
    }

    /// The real root farthest from the inflection point.
    pub fn outermost_root(&self) -> Bounded<R> {
        let value = self.real_root();
        Bounded { value, error: self.real_root_error(value, self.slope(value)) }
    }

    #[inline(always)]
    fn value(&self, x: R) -> R {
        let [c0, c1, c2, c3] = self.coefficients;
        ((c3 * x + c2) * x + c1) * x + c0
    }

    #[inline(always)]
    fn slope(&self, x: R) -> R {
        let [_, c1, c2, c3] = self.coefficients;
        (c3 * x * R::from(3) + c2 * R::from(2)) * x + c1
    }

    /// Bounds of the errors of F(x) and F'(x), and of |F''| within `reach` of x, by the sums of the terms' magnitudes.
    #[inline(always)]
    fn evaluation_errors(&self, x: f64, reach: f64) -> [f64; 3] {
        let [m0, m1, m2, m3] = self.magnitudes;
        let x = x.abs();
        let unit = (self.relative_error + 7.0 * R::UNIT) * SLACK;
        let value = ((m3 * x + m2) * x + m1) * x + m0;
        let slope = (3.0 * m3 * x + 2.0 * m2) * x + m1;
        [unit * value, unit * slope, (6.0 * m3 * (x + reach) + 2.0 * m2) * SLACK]
    }

    /// Kahan's root, polished by Newton steps whose slope needs no more than 64 bits.
    fn real_root(&self) -> R {
        let [c0, c1, c2, c3] = self.coefficients.map(R::leading);
        let start = kahan_root([c0, c1, c2, c3]);
        let mut root = R::from(start);
        let slope = (3.0 * c3 * start + 2.0 * c2) * start + c1;
        for _ in 0..R::POLISHING_STEPS {
            let step = self.value(root).leading() / slope;
            // At a triple root this is 0/0: the start is as good as it gets, and its bound says so.
            if !step.is_finite() {
                break;
            }
            root = root - R::from(step);
        }
        root
    }

    /// If |F'| stays above half of |F'(x)| within d = 2|F(x)|/|F'(x)|, a root lies there, and by the mean value theorem
    /// no farther than |F(x)| over the least |F'|.
    fn real_root_error(&self, x: R, slope: R) -> f64 {
        let value = self.value(x);
        let x = x.leading();
        let [value_error, slope_error, _] = self.evaluation_errors(x, 0.0);
        let value = (value.leading().abs() + value_error) * SLACK;
        let slope = slope.leading().abs() - slope_error;
        let reach = 2.0 * value / slope * SLACK;
        let [_, _, curvature] = self.evaluation_errors(x, reach);
        let least_slope = slope - curvature * reach;
        if slope > 0.0 && least_slope >= slope / 2.0 { value / least_slope * SLACK } else { f64::INFINITY }
    }

    fn pair(&self, real: &Bounded<R>, slope: R) -> Option<Pair<R>> {
        let [_, _, _, c3] = self.coefficients;
        let t = real.value;
        let relative = real.error / t.leading().abs();
        if !is_small(relative) {
            return None;
        }
        let delta = self.discriminant();
        let width = self.quadratic_discriminant_root(real, slope, &delta)?;
        let (linear, constant) = self.deflate(t, relative);
        let lead_error = self.relative_error * self.magnitudes[3] / c3.leading().abs() + 3.0 * R::UNIT;
        let twice = c3 * R::from(2);
        let divide = |numerator: R, error: f64| {
            let value = numerator / twice;
            let error = error / twice.leading().abs() + value.leading().abs() * lead_error;
            Bounded { value, error: error * SLACK }
        };
        if delta.value.leading() < 0.0 {
            let positive = if twice.leading() < 0.0 { -width.value } else { width.value };
            let re = divide(-linear.value, linear.error);
            return Some(Pair::Complex { re, im: divide(positive, width.error) });
        }
        // −u ∓ √ without cancellation; the other root by the product of both, w/c3.
        let outward = if linear.value.leading() < 0.0 { -width.value } else { width.value };
        let sum = linear.value + outward;
        let sum_error = linear.error + width.error + R::UNIT * sum.leading().abs();
        let relative = sum_error / sum.leading().abs();
        if !is_small(relative) {
            return None;
        }
        let outer = divide(-sum, sum_error);
        let inner = -(constant.value * R::from(2)) / sum;
        let inner_error =
            inner.leading().abs() * (relative + 3.0 * R::UNIT) + 2.0 * constant.error / sum.leading().abs();
        let inner = Bounded { value: inner, error: inner_error * SLACK };
        let ascending = outer.value.leading() < inner.value.leading();
        Some(Pair::Real(if ascending { [outer, inner] } else { [inner, outer] }))
    }

    /// √|u² − 4c3w| = √|Δ|/|F'(t)|, or nothing when the sign of Δ or F' is not certain.
    fn quadratic_discriminant_root(
        &self,
        real: &Bounded<R>,
        slope: R,
        delta: &Bounded<R>,
    ) -> Option<Bounded<R>> {
        let [_, slope_error, curvature] = self.evaluation_errors(real.value.leading(), real.error);
        let slope_error = slope_error + curvature * real.error;
        let slope_relative = slope_error / slope.leading().abs();
        let delta_relative = delta.error / delta.value.leading().abs();
        if !(is_small(delta_relative) && is_small(slope_relative)) {
            return None;
        }
        let magnitude = if delta.value.leading() < 0.0 { -delta.value } else { delta.value };
        let slope = if slope.leading() < 0.0 { -slope } else { slope };
        let value = magnitude.sqrt() / slope;
        let relative = (delta_relative / 2.0 + slope_relative + 3.0 * R::UNIT) * SLACK;
        Some(Bounded { value, error: value.leading() * relative })
    }

    /// u and w of F(x) = (x − t)(c3x² + ux + w): w = −c0/t; u = c2 + c3t or (w − c1)/t, whichever is better.
    #[inline(always)]
    fn deflate(&self, t: R, t_relative: f64) -> (Bounded<R>, Bounded<R>) {
        let [c0, c1, c2, c3] = self.coefficients;
        let [m0, m1, m2, m3] = self.magnitudes;
        let size = t.leading().abs();
        let data = self.relative_error + 2.0 * R::UNIT;
        let constant = -c0 / t;
        let constant_size = constant.leading().abs();
        let constant_error = (m0 / size * data + constant_size * (t_relative + R::UNIT)) * SLACK;
        let above = c2 + c3 * t;
        let above_error = (data * (m2 + m3 * size) + m3 * size * t_relative) * SLACK;
        let below = (constant - c1) / t;
        let below_error = ((constant_error + data * (constant_size + m1)) / size
            + below.leading().abs() * (t_relative + R::UNIT))
            * SLACK;
        let linear = if above_error < below_error {
            Bounded { value: above, error: above_error }
        } else {
            Bounded { value: below, error: below_error }
        };
        (linear, Bounded { value: constant, error: constant_error })
    }
}

/// Whether a relative error is small enough for first-order bounds; what is not a number is not.
#[inline(always)]
fn is_small(relative: f64) -> bool {
    relative < 0.01
}

#[cfg(test)]
mod data_error_tests;

#[cfg(test)]
mod tests;
