//! The three roots in double-double without a branch, so that a loop over many cubics runs in vector units.
//!
//! A real root comes from a 64-bit one by one Newton step on the cubic in double-double. The other two solve the quadratic that
//! is left. [`BoundedCubic::roots_by_deflation`] divides by the root's factor; it serves roots many decades apart.
//! [`BoundedCubic::roots_by_shift`] works on the depressed cubic y³ + Py + Q; it serves next to a triple root, where all roots
//! have one modulus and P and Q are small differences of the coefficients.
//!
//! # The bound of the Newton step
//! Let F(x) be known to ε, F'(x) = s to ε', |F''| ≤ C within ρ of x, and δ = −F(x)/s rounded to 64-bit. By Taylor's theorem
//! |F(x + δ)| ≤ ε + 2·2^-53·|F(x)| + (ε' + Cδ)|δ| =: B, because the part of F(x) that δ removes is known to two roundings. Within ρ,
//! |F'| ≥ L := |s| − ε' − Cρ. If L ≥ |s|/2 and ρ ≥ 3|δ| + 4ε/|s|, then |δ| + B/L ≤ ρ; so F changes its sign within B/L of
//! x + δ, and a root lies there.

use super::super::kahan::kahan_root_without_branches;
use super::{Bounded, BoundedCubic, SLACK, Working, is_small};
use crate::number::{Dd, Field, Real, select};

/// Bound on the relative error of one operation in double-double.
const UNIT: f64 = Dd::UNIT;

/// The three roots of a cubic, all as numbers: without a branch there is no enumeration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BranchlessRoots {
    /// A real root.
    pub real: Bounded<Dd>,
    /// One of the other two roots when they are real; their common real part when they are a pair.
    pub first: Bounded<Dd>,
    /// The other one when they are real; the positive imaginary part when they are a pair.
    pub second: Bounded<Dd>,
    /// +1 when all roots are real, −1 when two are a pair, 0 when it is not certain.
    pub sign: f64,
}

impl BranchlessRoots {
    /// Whether the error of every root is at most this part of its modulus; false where a bound is not a number.
    #[inline(always)]
    pub fn are_within(&self, relative_error: f64) -> bool {
        let within = |bounded: &Bounded<Dd>| bounded.error <= relative_error * bounded.value.hi().abs();
        let (x, y) = (self.first.value.hi(), self.second.value.hi());
        let as_pair = self.first.error + self.second.error <= relative_error * (x * x + y * y).sqrt();
        let as_real = within(&self.first) & within(&self.second);
        within(&self.real) & ((self.sign > 0.0) & as_real | (self.sign < 0.0) & as_pair)
    }
}

/// What is known of a function at a 64-bit number.
struct AtStart {
    value: Dd,
    value_error: f64,
    slope: f64,
    slope_error: f64,
}

/// The Newton step of this module's header; `curvature` bounds |F''| within a distance.
#[inline(always)]
fn newton_step(x: f64, start: &AtStart, curvature: impl Fn(f64) -> f64) -> Bounded<Dd> {
    let AtStart { value, value_error, slope, slope_error } = start;
    let step = -(value.hi() / slope);
    let size = slope.abs();
    let reach = (3.0 * step.abs() + 4.0 * value_error / size) * SLACK;
    let curvature = curvature(reach);
    let least = size - slope_error - curvature * reach;
    let left =
        value_error + f64::EPSILON * value.hi().abs() + (slope_error + curvature * step.abs()) * step.abs();
    let error = select(least >= 0.5 * size, left / least * SLACK, f64::INFINITY);
    Bounded { value: Dd::exact_sum(x, step), error }
}

/// √|D| with its bound, as |√x − √y| ≤ |x − y|/√x.
#[inline(always)]
fn root_of_magnitude(discriminant: Dd, error: f64) -> Bounded<Dd> {
    let value = discriminant.abs().sqrt();
    Bounded { value, error: (error / value.hi() + 2.0 * UNIT * value.hi()) * SLACK }
}

/// The sign of a number beyond its error, else 0.
#[inline(always)]
fn sign_beyond(value: f64, error: f64) -> f64 {
    select(value.abs() > error, select(value < 0.0, -1.0, 1.0), 0.0)
}

impl BoundedCubic<Dd> {
    /// The cubic in 64-bit, with the rounding of its coefficients in the bound.
    #[inline(always)]
    fn leading(&self) -> BoundedCubic<f64> {
        let coefficients = self.coefficients.map(|coefficient| coefficient.hi());
        BoundedCubic {
            coefficients,
            magnitudes: self.magnitudes,
            relative_error: self.relative_error + f64::UNIT,
        }
    }

    /// The roots by division: −c0/t and the better of two linear coefficients give the quadratic c3x² + ux + w.
    #[inline(always)]
    pub fn roots_by_deflation(&self) -> BranchlessRoots {
        let leading = self.leading();
        let x = kahan_root_without_branches(leading.coefficients);
        let [value_error, ..] = self.evaluation_errors(x, 0.0);
        let [_, slope_error, _] = leading.evaluation_errors(x, 0.0);
        let start =
            AtStart { value: self.value(Dd::from(x)), value_error, slope: leading.slope(x), slope_error };
        let real = newton_step(x, &start, |reach| leading.evaluation_errors(x, reach)[2]);
        let relative = real.error / real.value.hi().abs();
        let (linear, constant) = self.deflate(real.value, relative);
        let (first, second, sign) = self.roots_of_quadratic(&linear, &constant);
        BranchlessRoots { real, first, second, sign: select(is_small(relative), sign, 0.0) }
    }

    /// The roots of c3x² + ux + w, without cancellation, and the sign of u² − 4c3w.
    #[inline(always)]
    fn roots_of_quadratic(
        &self,
        linear: &Bounded<Dd>,
        constant: &Bounded<Dd>,
    ) -> (Bounded<Dd>, Bounded<Dd>, f64) {
        let [_, _, _, c3] = self.coefficients;
        let [_, _, _, m3] = self.magnitudes;
        let (u, w) = (linear.value, constant.value);
        let product = (c3 * w).scale(4.0);
        let square = u.square();
        let discriminant = square - product;
        let of_square = (2.0 * u.hi().abs() + linear.error) * linear.error + UNIT * square.hi();
        let of_product =
            4.0 * m3 * ((1.0 + self.relative_error) * constant.error + w.hi().abs() * self.relative_error)
                + UNIT * product.hi().abs();
        let error = (of_square + of_product + UNIT * discriminant.hi().abs()) * SLACK;
        let is_pair = discriminant.hi() < 0.0;
        let width = root_of_magnitude(discriminant, error);
        let outward = u + Dd::select(u.hi() < 0.0, -width.value, width.value);
        let outward_error = linear.error + width.error + UNIT * outward.hi().abs();
        let outward_relative = outward_error / outward.hi().abs();
        let twice = c3.scale(2.0);
        let size = twice.hi().abs();
        let lead_error = self.relative_error * m3 / c3.hi().abs() + 3.0 * UNIT;

        let first = Dd::select(is_pair, -u, -outward) / twice;
        let first_error = select(is_pair, linear.error, outward_error) / size + first.hi().abs() * lead_error;
        // The imaginary part, or the other real root by the product of both.
        let second =
            Dd::select(is_pair, width.value, -w.scale(2.0)) / Dd::select(is_pair, twice.abs(), outward);
        let of_inner =
            second.hi().abs() * (outward_relative + 3.0 * UNIT) + 2.0 * constant.error / outward.hi().abs();
        let of_width = width.error / size + second.hi().abs() * lead_error;
        let inner_error = select(is_small(outward_relative), of_inner, f64::INFINITY);
        let second_error = select(is_pair, of_width, inner_error);
        (
            Bounded { value: first, error: first_error * SLACK },
            Bounded { value: second, error: second_error * SLACK },
            sign_beyond(discriminant.hi(), error),
        )
    }

    /// The roots by y = 3c3x + c2, with P = 3(3c3c1 − c2²) and Q = 2c2³ − 9c3c2c1 + 27c3²c0.
    #[inline(always)]
    pub fn roots_by_shift(&self) -> BranchlessRoots {
        let [c0, c1, c2, c3] = self.coefficients;
        let [m0, m1, m2, m3] = self.magnitudes;
        let outer = c3 * c1;
        let square = c2.square();
        let p = (outer * Dd::from(3.0) - square) * Dd::from(3.0);
        let q = (square.scale(2.0) - outer * Dd::from(9.0)) * c2 + c3.square() * c0 * Dd::from(27.0);
        let p_error = 3.0 * (3.0 * m3 * m1 + m2 * m2) * (2.0 * self.relative_error + 6.0 * UNIT) * SLACK;
        let q_terms = (2.0 * m2 * m2 + 9.0 * m3 * m1) * m2 + 27.0 * m3 * m3 * m0;
        let q_error = q_terms * (3.0 * self.relative_error + 8.0 * UNIT) * SLACK;
        self.roots_of_depressed(&Bounded { value: p, error: p_error }, &Bounded { value: q, error: q_error })
    }

    /// The roots by those of y³ + Py + Q: one is y, the other two are −y/2 ± √−(3y² + 4P)/2.
    #[inline(always)]
    pub fn roots_of_depressed(&self, linear: &Bounded<Dd>, constant: &Bounded<Dd>) -> BranchlessRoots {
        let [_, _, c2, c3] = self.coefficients;
        let [_, _, m2, m3] = self.magnitudes;
        let (p, p_error, q, q_error) = (linear.value, linear.error, constant.value, constant.error);
        let x = kahan_root_without_branches([q.hi(), p.hi(), 0.0, 1.0]);
        let (size, p_size) = (x.abs(), p.hi().abs());
        let start = AtStart {
            value: (Dd::from(x).square() + p) * Dd::from(x) + q,
            value_error: (q_error
                + p_error * size
                + 7.0 * UNIT * ((size * size + p_size) * size + q.hi().abs()))
                * SLACK,
            slope: 3.0 * x * x + p.hi(),
            slope_error: (p_error + 7.0 * f64::UNIT * (3.0 * size * size + p_size)) * SLACK,
        };
        let root = newton_step(x, &start, |reach| 6.0 * (size + reach) * SLACK);

        let (y, size) = (root.value, root.value.hi().abs());
        let tripled = y.square() * Dd::from(3.0);
        let discriminant = -(tripled + p.scale(4.0));
        let error = ((6.0 * size + 3.0 * root.error) * root.error
            + 4.0 * p_error
            + 4.0 * UNIT * (tripled.hi() + 4.0 * p_size))
            * SLACK;
        let is_pair = discriminant.hi() < 0.0;
        let width = root_of_magnitude(discriminant, error);

        let divisor = c3 * Dd::from(6.0);
        let lead_error = self.relative_error * m3 / c3.hi().abs() + 4.0 * UNIT;
        let divide = |numerator: Dd, error: f64| {
            let value = numerator / divisor;
            let error = error / divisor.hi().abs() + value.hi().abs() * lead_error;
            Bounded { value, error: error * SLACK }
        };
        let c2_error = self.relative_error * m2 + UNIT * c2.hi().abs();
        let real_error = 2.0 * (root.error + c2_error + UNIT * size);
        let centre = -(y + c2.scale(2.0));
        let centre_error = root.error + 2.0 * c2_error + UNIT * (size + 2.0 * c2.hi().abs());
        let (low, high) = (centre - width.value, centre + width.value);
        let either_error = |end: Dd| centre_error + width.error + UNIT * end.hi().abs();
        let imaginary = Dd::select(c3.hi() < 0.0, -width.value, width.value);
        BranchlessRoots {
            real: divide((y - c2).scale(2.0), real_error),
            first: divide(Dd::select(is_pair, centre, low), select(is_pair, centre_error, either_error(low))),
            second: divide(
                Dd::select(is_pair, imaginary, high),
                select(is_pair, width.error, either_error(high)),
            ),
            sign: sign_beyond(discriminant.hi(), error),
        }
    }
}
