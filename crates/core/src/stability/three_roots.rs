//! The three roots s of eq 8 in 64-bit numbers, each with a guaranteed error.
//!
//! # Derivation of the bound
//! 1. The inputs are exact, or within a relative u = 2^-102 ([`Dd::UNIT`]) of the exact ones. η, κ and β then have relative
//!    errors of at most 12u, products and quotients included.
//! 2. The coefficients κ, κ + 1 − β, 1 + η and η of eq 8 are known to 26u of the sums of their terms' magnitudes.
//! 3. A 64-bit Newton iteration gives a start, and one Newton step in double-double a real root. Its error follows from the
//!    residual, the slope and the curvature, with the errors of the coefficients in the residual (`roots/forward/branchless.rs`).
//! 4. The other two roots solve the quadratic that is left. Next to a triple root the depressed cubic is solved instead, nearer
//!    still with P and Q from integers.
//! 5. If one of these ways bounds every error by 2^-64 of the root's modulus (`WORKING_ERROR`), the roots are rounded to
//!    64-bit, each part to nearest: that adds 2^-53 of the modulus. Otherwise certified enclosures of 22 digits of the exact
//!    inputs are rounded.
//!
//! The sum is below 2^-53·(1 + 2^-10), which is [`ROOT_ERROR`].

use super::point_values::{PointValues, Route};
use num_complex::Complex;
use rug::Float;
use thiserror::Error;

use super::batch::one_point;
use super::certain_signs::InputError;
use super::integer_cubic::IntegerCubic;
use crate::friction::Parameters;
use crate::number::{Dd, Rational};
use crate::roots::{CertifiedRoot, PrecisionLevel, certified_roots};

/// Bound on the error of every root of [`three_roots`], relative to the root's modulus: 2^-53·(1 + 2^-10) < 1.112e-16.
pub const ROOT_ERROR: f64 = f64::EPSILON / 2.0 * (1.0 + 1.0 / 1024.0);

/// Digits of the enclosures where double-double does not suffice.
const EXACT_DIGITS: u32 = 22;

/// The moduli, in 1/s, that 64-bit numbers hold to full precision with some room.
const MODULI: std::ops::RangeInclusive<f64> = 1e-300..=1e300;

/// The three roots of a point, 1/s.
///
/// ```
/// use slipmode_core::friction::Parameters;
/// use slipmode_core::stability::{ROOT_ERROR, ThreeRoots, three_roots};
///
/// let found: ThreeRoots = three_roots(&Parameters::from([0.004, 0.006, 1e-5, 1e7, 1000.0, 1e6, 1e-5])).unwrap();
/// assert!(found.max_real_per_s > 0.0 && found.max_real_error_per_s <= ROOT_ERROR * found.max_real_per_s);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeRoots {
    /// Real roots first, ascending; then the conjugate pair, negative imaginary part first. Each lies within [`ROOT_ERROR`] of
    /// its modulus of the true root. A double root stands twice.
    pub roots: [Complex<f64>; 3],
    /// The largest real part. It is the growth rate of a small disturbance.
    pub max_real_per_s: f64,
    /// Bound on the error of `max_real_per_s`, rounding included. It is at most [`ROOT_ERROR`] of the modulus of a root with this
    /// real part. Next to K = K_c, where the largest real part vanishes, it may exceed the part itself.
    pub max_real_error_per_s: f64,
    /// The precision level that gave the roots: double-double or exact.
    pub precision_level: PrecisionLevel,
}

/// Why a point has no roots in 64-bit numbers.
///
/// ```
/// use slipmode_core::friction::Parameters;
/// use slipmode_core::stability::{RootsError, three_roots};
///
/// let at_rest = Parameters::from([0.004, 0.006, 1e-5, 1e7, 1000.0, 1e6, 0.0]);
/// assert_eq!(three_roots(&at_rest).unwrap_err(), RootsError::NotPositive);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum RootsError {
    /// An input is not positive, or not finite.
    #[error("an input is not a positive finite number")]
    NotPositive,
    /// A root's modulus lies outside 1e-300 to 1e300 1/s.
    #[error("a root lies outside 1e-300 to 1e300 1/s: certified_roots has it")]
    OutOfRange,
}

/// A number that is an exact input: `f64`, taken as the binary fraction that it is, or [`Rational`].
pub trait ExactInput: Clone {
    const ERROR_IN_DOUBLE_DOUBLE: InputError;
    fn in_double_double(&self) -> Dd;
    fn exactly(&self) -> Option<Rational>;
    /// The number, if it is positive and its type has none but 64-bit ones.
    fn binary_fraction(&self) -> Option<f64>;
}

impl ExactInput for f64 {
    const ERROR_IN_DOUBLE_DOUBLE: InputError = InputError::None;
    fn in_double_double(&self) -> Dd {
        Dd::from(*self)
    }
    fn exactly(&self) -> Option<Rational> {
        Rational::from_f64(*self)
    }
    fn binary_fraction(&self) -> Option<f64> {
        (*self > 0.0 && self.is_finite()).then_some(*self)
    }
}

impl ExactInput for Rational {
    const ERROR_IN_DOUBLE_DOUBLE: InputError = InputError::Unit;
    fn in_double_double(&self) -> Dd {
        Dd::from_rational(self)
    }
    fn exactly(&self) -> Option<Rational> {
        Some(self.clone())
    }
    fn binary_fraction(&self) -> Option<f64> {
        None
    }
}

/// The three roots s of eq 8, 1/s: the exponents of a small disturbance of steady sliding.
///
/// Inputs are `f64` or [`Rational`], and exact either way. Every root has an error of at most [`ROOT_ERROR`] of its modulus, the
/// rounding of the coefficients included; no point is left without an answer because it lies next to a double or triple root.
/// [`batch::three_roots_of_points`](super::batch::three_roots_of_points) gives the same numbers for columns of points.
///
/// # Errors
/// When an input is not positive and finite, or a root's modulus lies outside 1e-300 to 1e300 1/s.
///
/// ```
/// use slipmode_core::stability::{ROOT_ERROR, three_roots};
/// use slipmode_core::{friction::Parameters, roots::certified_roots, number::parse_decimal};
///
/// let decimals = ["0.004", "0.006", "1e-5", "1e7", "1000", "1e6", "0.1"].map(|text| parse_decimal(text).unwrap());
/// let parameters = Parameters::from(decimals);
/// let found = three_roots(&parameters).unwrap();
/// // The last one is that of the pair with the positive imaginary part. Its digits are certified ones, rounded.
/// let certified = certified_roots(&parameters.characteristic_cubic_per_s(), 30).roots;
/// let [re, im] = [&certified[2].re, &certified[2].im].map(|part| part.to_f64());
/// assert!((found.roots[2] - num_complex::Complex::new(re, im)).norm() <= 2.0 * ROOT_ERROR * found.roots[2].norm());
/// ```
pub fn three_roots<R: ExactInput>(parameters: &Parameters<R>) -> Result<ThreeRoots, RootsError> {
    let doubled = parameters.map(R::in_double_double);
    let by = |route| ThreeRoots::of_values(&one_point(&doubled, R::ERROR_IN_DOUBLE_DOUBLE, route));
    let found = by(Route::Deflation).or_else(|| by(Route::Shift));
    found.map_or_else(|| ThreeRoots::beyond_double_double(parameters), Ok)
}

impl ThreeRoots {
    /// The roots that double-double found, if each is within its bound and range.
    pub(super) fn of_values(values: &PointValues<f64>) -> Option<Self> {
        let is_pair = values.sign < 0.0;
        let real = |re: f64| Complex::new(re, 0.0);
        let roots = if is_pair {
            let pair = Complex::new(values.first, values.second);
            [real(values.real), pair.conj(), pair]
        } else {
            let mut roots = [values.real, values.first, values.second];
            roots.sort_by(f64::total_cmp);
            roots.map(real)
        };
        (values.sign != 0.0 && roots.iter().all(in_range)).then_some(Self {
            roots,
            max_real_per_s: values.max_real,
            max_real_error_per_s: values.max_real_error,
            precision_level: PrecisionLevel::DoubleDouble,
        })
    }

    /// The roots where double-double does not bound them: of the cubic in integers, or else by certified enclosures.
    pub(super) fn beyond_double_double<R: ExactInput>(
        parameters: &Parameters<R>,
    ) -> Result<Self, RootsError> {
        let values = <[R; 7]>::from(parameters.clone());
        let fractions = values.each_ref().map(R::binary_fraction);
        if let [Some(a), Some(b), Some(d), Some(k), Some(m), Some(s), Some(v)] = fractions
            && let Some(found) = Self::of_integers(&Parameters::from([a, b, d, k, m, s, v]))
        {
            return Ok(found);
        }
        let exact: Option<Vec<Rational>> =
            values.iter().map(|value| value.exactly().filter(|value| *value > 0)).collect();
        let exact =
            exact.and_then(|values| <[Rational; 7]>::try_from(values).ok()).ok_or(RootsError::NotPositive)?;
        Self::exactly(&Parameters::from(exact))
    }

    /// The roots from P and Q of the depressed cubic in integers.
    fn of_integers(point: &Parameters<f64>) -> Option<Self> {
        let doubled = point.map(|value| Dd::from(*value));
        let found = Self::of_values(&IntegerCubic::of(point)?.values(&doubled))?;
        Some(Self { precision_level: PrecisionLevel::Exact, ..found })
    }

    /// The roots by certified enclosures.
    fn exactly(parameters: &Parameters<Rational>) -> Result<Self, RootsError> {
        let found = certified_roots(&parameters.characteristic_cubic_per_s(), EXACT_DIGITS).roots;
        let rounded = |root: &CertifiedRoot| Complex::new(root.re.to_f64(), root.im.to_f64());
        let each =
            found.iter().flat_map(|root| std::iter::repeat_n(rounded(root), root.multiplicity as usize));
        let roots: Vec<Complex<f64>> = each.collect();
        let largest = found.iter().map(|root| &root.re).max_by(|one, other| one.total_cmp(other));
        let roots = <[Complex<f64>; 3]>::try_from(roots).ok().filter(|roots| roots.iter().all(in_range));
        let (roots, largest) = roots.zip(largest).ok_or(RootsError::OutOfRange)?;
        let max_real_per_s = largest.to_f64();
        Ok(Self {
            roots,
            max_real_per_s,
            max_real_error_per_s: rounding_error(largest, max_real_per_s),
            precision_level: PrecisionLevel::Exact,
        })
    }
}

/// Whether a root is within the range: its modulus lies between its larger part and √2 of it.
fn in_range(root: &Complex<f64>) -> bool {
    MODULI.contains(&root.re.abs().max(root.im.abs()))
}

/// Bound on the error of a part that is known to 22 digits and rounded.
fn rounding_error(part: &Float, rounded: f64) -> f64 {
    // A subnormal number errs by half of the smallest one.
    if part.is_zero() { 0.0 } else { (ROOT_ERROR * rounded.abs()).max(f64::from_bits(1)) }
}

#[cfg(test)]
mod tests;
