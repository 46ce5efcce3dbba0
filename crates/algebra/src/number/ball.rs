//! Balls: an MPFR centre of any precision and a 32-bit radius, always rounded so that the true value stays inside.

use std::cmp::Ordering;

use rug::float::{Constant, Round};
use rug::{Float, Integer, Rational};

use super::magnitude::{MAGNITUDE_BITS, Magnitude};

/// The set of reals within `radius` of `centre`.
///
/// Every operation returns a ball that contains the result for every choice of points in its operands.
/// A result that cannot be bounded (a division by a ball that contains zero) has an infinite radius and centre zero.
///
/// ```
/// use slipmode_algebra::number::{Ball, Real};
/// use slipmode_algebra::number::Rational;
///
/// let root = Ball::from_rational(&Rational::from(2), 100).sqrt();
/// let square = root.clone() * &root;
/// assert!(square.contains(&Rational::from(2)) && root.relative_radius_log2() < -90.0);
/// ```
#[derive(Debug, Clone)]
pub struct Ball {
    pub(super) centre: Float,
    pub(super) radius: Magnitude,
}

/// Bits of significand that hold `digits` decimal digits: ⌈digits·log2 10⌉ and one more.
#[must_use]
pub const fn bits_for_digits(digits: u32) -> u32 {
    (digits as u64 * 3_321_928_095 / 1_000_000_000) as u32 + 2
}

impl Ball {
    /// The ball of this centre and radius; the radius is rounded up to 32 bits.
    ///
    /// A centre that is not finite, or a radius that is negative or not a number, gives the ball of infinite radius.
    #[must_use]
    pub fn new(centre: Float, radius: Float) -> Self {
        Self { centre, radius: Magnitude::of_radius(&radius) }.made_valid()
    }

    /// The ball of radius zero around a float.
    #[must_use]
    pub fn exact(centre: Float) -> Self {
        Self { centre, radius: Magnitude::ZERO }.made_valid()
    }

    /// The rational rounded to this precision, with its rounding error as radius.
    #[must_use]
    pub fn from_rational(value: &Rational, precision_bits: u32) -> Self {
        let (centre, rounding) = Float::with_val_round(precision_bits, value, Round::Nearest);
        Self::rounded(centre, rounding, Magnitude::ZERO)
    }

    /// π to this precision.
    #[must_use]
    pub fn pi(precision_bits: u32) -> Self {
        let (centre, rounding) = Float::with_val_round(precision_bits, Constant::Pi, Round::Nearest);
        Self::rounded(centre, rounding, Magnitude::ZERO)
    }

    /// The integer rounded to this precision, with its rounding error as radius.
    #[must_use]
    pub fn from_integer(value: &Integer, precision_bits: u32) -> Self {
        let (centre, rounding) = Float::with_val_round(precision_bits, value, Round::Nearest);
        Self::rounded(centre, rounding, Magnitude::ZERO)
    }

    /// The integer at its own length, at most this many bits: a short factor costs less than one filled up with zeros.
    ///
    /// For operations with balls of full precision, to which the result then has it too.
    #[must_use]
    pub fn from_short_integer(value: &Integer, most_bits: u32) -> Self {
        Self::from_integer(value, value.significant_bits().clamp(2, most_bits.max(2)))
    }

    /// A centre just rounded to nearest, with the radius known so far: adds half a unit in the last place if inexact.
    #[inline]
    pub(super) fn rounded(centre: Float, rounding: Ordering, radius: Magnitude) -> Self {
        let radius = if rounding == Ordering::Equal { radius } else { radius.plus(half_unit(&centre)) };
        Self { centre, radius }.made_valid()
    }

    /// The ball of infinite radius: nothing is known.
    #[must_use]
    pub fn unbounded(precision_bits: u32) -> Self {
        Self { centre: Float::new(precision_bits), radius: Magnitude::INFINITE }
    }

    #[inline]
    fn made_valid(self) -> Self {
        let usable = self.centre.is_finite() && !self.radius.is_infinite();
        if usable { self } else { Self::unbounded(self.centre.prec()) }
    }

    /// The centre.
    #[must_use]
    pub const fn centre(&self) -> &Float {
        &self.centre
    }

    /// The radius, an upper bound of the distance of the true value from the centre.
    #[must_use]
    pub fn radius(&self) -> Float {
        self.radius.to_float()
    }

    /// Whether anything is known: false for the ball of infinite radius.
    #[must_use]
    pub const fn is_bounded(&self) -> bool {
        !self.radius.is_infinite()
    }

    /// Whether the ball is a single point.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.radius.is_zero()
    }

    /// The precision of the centre in bits.
    #[must_use]
    pub fn precision_bits(&self) -> u32 {
        self.centre.prec()
    }

    /// A lower bound of the true value.
    #[must_use]
    pub fn lower(&self) -> Float {
        Float::with_val_round(self.centre.prec(), &self.centre - &self.radius(), Round::Down).0
    }

    /// An upper bound of the true value.
    #[must_use]
    pub fn upper(&self) -> Float {
        Float::with_val_round(self.centre.prec(), &self.centre + &self.radius(), Round::Up).0
    }

    /// The natural logarithm; unbounded unless every point of the ball is positive.
    #[must_use]
    pub fn ln(&self) -> Self {
        if self.sign() != Some(Ordering::Greater) {
            return Self::unbounded(self.precision_bits());
        }
        self.rising(Float::ln_round)
    }

    /// The exponential.
    #[must_use]
    pub fn exp(&self) -> Self {
        self.rising(Float::exp_round)
    }

    /// The inverse hyperbolic sine.
    #[must_use]
    pub fn asinh(&self) -> Self {
        self.rising(Float::asinh_round)
    }

    /// The sine: its slope is at most 1, so that the radius stays.
    #[must_use]
    pub fn sin(&self) -> Self {
        self.of_angle(Float::sin)
    }

    /// The cosine, with the radius of the angle.
    #[must_use]
    pub fn cos(&self) -> Self {
        self.of_angle(Float::cos)
    }

    fn of_angle(&self, function: fn(Float) -> Float) -> Self {
        let precision = self.precision_bits();
        if !self.is_bounded() {
            return Self::new(Float::new(precision), Float::with_val(precision, 1));
        }
        // Half a unit of the last place of a number up to 1 is the error of rounding.
        let rounding =
            Float::with_val(precision, Float::i_exp(1, -i32::try_from(precision).unwrap_or(i32::MAX)));
        let radius = Float::with_val_round(precision, self.radius() + rounding, Round::Up).0;
        Self::new(function(self.centre.clone()), radius)
    }

    /// The image under a function that rises, from its values at both ends.
    fn rising(&self, function: fn(&mut Float, Round) -> Ordering) -> Self {
        if !self.is_bounded() {
            return self.clone();
        }
        let (mut low, mut high) = (self.lower(), self.upper());
        function(&mut low, Round::Down);
        function(&mut high, Round::Up);
        let precision = self.precision_bits();
        let centre = Float::with_val(precision, &low + &high) / 2_u32;
        let above = Float::with_val_round(precision, &high - &centre, Round::Up).0;
        let below = Float::with_val_round(precision, &centre - &low, Round::Up).0;
        Self::new(centre, above.max(&below))
    }

    /// The sign of every point of the ball against zero; `None` when they differ.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        if !self.radius.is_zero() && self.contains_zero() { None } else { self.centre.cmp0() }
    }

    /// Whether zero lies in the ball.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        Magnitude::above(&self.centre).compare(self.radius) != Ordering::Greater
    }

    /// Whether the rational lies in the ball, decided exactly.
    #[must_use]
    pub fn contains(&self, value: &Rational) -> bool {
        match (self.centre.to_rational(), self.radius().to_rational()) {
            (Some(centre), Some(radius)) => (centre - value).abs() <= radius,
            _ => true,
        }
    }

    /// Whether two balls have a point in common (may say yes for balls apart by a rounding error, never no wrongly).
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        if self.radius.is_infinite() || other.radius.is_infinite() {
            return true;
        }
        self.lower() <= other.upper() && other.lower() <= self.upper()
    }

    /// log2(radius/|centre|): minus the number of certain bits. −∞ for an exact ball, +∞ when the centre is zero.
    #[must_use]
    pub fn relative_radius_log2(&self) -> f64 {
        if self.radius.is_zero() {
            return f64::NEG_INFINITY;
        }
        if self.centre.is_zero() || self.radius.is_infinite() {
            return f64::INFINITY;
        }
        self.radius.binary_logarithm() - log2(&self.centre)
    }

    /// k such that every point is at most 2^k in magnitude; very large for the ball of infinite radius.
    pub fn exponent_above(&self) -> i64 {
        Magnitude::above(&self.centre).plus(self.radius).exponent()
    }

    /// k such that every point is at least 2^k in magnitude; none when zero lies in the ball.
    pub fn exponent_below(&self) -> Option<i64> {
        let least = Magnitude::below(&self.centre).minus_down(self.radius);
        (!least.is_zero() && self.is_bounded()).then(|| least.exponent() - 1)
    }

    /// k such that the radius is at most 2^k; very small for an exact ball.
    pub fn radius_exponent(&self) -> i64 {
        self.radius.exponent()
    }

    /// The ball with a radius that is larger by 2^exponent.
    pub fn widened(self, exponent: i64) -> Self {
        Self { radius: self.radius.plus(Magnitude::power_of_two(exponent)), ..self }.made_valid()
    }

    /// The same set with the centre rounded to another precision; the rounding error goes into the radius.
    #[must_use]
    pub fn with_precision(&self, precision_bits: u32) -> Self {
        let (centre, rounding) = Float::with_val_round(precision_bits, &self.centre, Round::Nearest);
        Self::rounded(centre, rounding, self.radius)
    }

    /// The f64 nearest to the centre (infinite or zero when it lies beyond f64's range).
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.centre.to_f64()
    }
}

/// Half a unit in the last place of a float rounded to nearest: 2^(exponent − precision − 1).
pub(super) fn half_unit(value: &Float) -> Magnitude {
    // Zero by underflow of MPFR's exponent, or not finite: nothing is known.
    value.get_exp().map_or(Magnitude::INFINITE, |exponent| {
        Magnitude::power_of_two(i64::from(exponent) - i64::from(value.prec()) - 1)
    })
}

/// log2 of the magnitude of a finite non-zero float, whatever its exponent.
fn log2(value: &Float) -> f64 {
    let (mantissa, exponent) = value.to_f64_exp();
    libm::log2(mantissa.abs()) + f64::from(exponent)
}

impl From<i32> for Ball {
    fn from(value: i32) -> Self {
        Self::exact(Float::with_val(MAGNITUDE_BITS, value))
    }
}

impl From<f64> for Ball {
    fn from(value: f64) -> Self {
        Self::exact(Float::with_val(53, value))
    }
}
