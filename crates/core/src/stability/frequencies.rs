//! The frequency of small disturbances in Hz and in units of the natural one, each rounded to the nearest 64-bit number.
//!
//! Double-double decides nearly all points: the numbers within its error bound round alike. Elsewhere enclosures are narrowed
//! until they contain no midpoint of two neighbouring 64-bit numbers. ω/2π is transcendental, so that it never is such a
//! midpoint. ω/ω_n is algebraic and can be one; this is tested exactly, and the even neighbour is taken.

use rug::Float;

use super::Classification;
use super::slip_mode::equation_at_ratio;
use crate::friction::Parameters;
use crate::number::{Ball, Dd, Rational, Real, Wide, bits_for_digits};
use crate::roots::{Bounded, Depressed, certified_roots};

/// 1/2π within a relative [`Dd::UNIT`].
const INVERSE_TAU: Dd = Dd::from_parts(0.159_154_943_091_895_35, -9.839_338_337_591_243e-18);

/// The digits of the first enclosures; each further attempt doubles them.
const FIRST_DIGITS: u32 = 40;

/// The relative error of ω_n = √(K/M) from inputs within a relative [`Dd::UNIT`]: half of that of K/M and a root's own.
const NATURAL_ERROR: f64 = 3.0 * Dd::UNIT;

/// ω = max Im(s) in Hz and in units of ω_n. Each number is the exact one, rounded to 53 bits; a tie goes to the even one.
///
/// ```
/// use slipmode_core::stability::Frequencies;
/// use slipmode_core::{stability::{InertialThreshold, classify}, friction::Slider, number::parse_decimal};
///
/// let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(|text| parse_decimal(text).unwrap()));
/// let parameters = slider.at(parse_decimal("1e4").unwrap(), parse_decimal("0.5").unwrap());
/// let found = Frequencies::of(&parameters, &classify(&parameters, &InertialThreshold::default()));
/// assert_eq!(found.natural_angular_frequency_per_s.to_f64(), Some(100.0));
/// assert!(found.frequency_over_natural.to_f64().unwrap() < 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frequencies {
    /// ω/2π, Hz; exactly 0 when no root is complex.
    pub frequency_hz: Wide,
    /// ω_n = √(K/M), 1/s.
    pub natural_angular_frequency_per_s: Wide,
    /// ω/ω_n; exactly 0 when no root is complex.
    pub frequency_over_natural: Wide,
}

impl Frequencies {
    /// The frequencies of a point that was classified.
    #[must_use]
    pub fn of(parameters: &Parameters<Rational>, found: &Classification) -> Self {
        let natural_squared = parameters.slider.natural_angular_frequency_squared_per_s2();
        Self::in_double_double(Dd::from_rational(&natural_squared), found)
            .unwrap_or_else(|| Self::by_enclosures(parameters, &natural_squared))
    }

    /// The same for inputs that are each within a relative [`Dd::UNIT`] of the true ones; none where they do not decide.
    #[must_use]
    pub fn quickly(parameters: &Parameters<Dd>, found: &Classification) -> Option<Self> {
        Self::in_double_double(parameters.slider.natural_angular_frequency_squared_per_s2(), found)
    }

    fn in_double_double(natural_squared: Dd, found: &Classification) -> Option<Self> {
        let natural = natural_squared.sqrt();
        let natural_angular_frequency_per_s = nearest_wide(natural, NATURAL_ERROR)?;
        let [frequency_hz, frequency_over_natural] = if found.max_imaginary_per_s.is_zero() {
            [Wide::ZERO; 2]
        } else {
            let Bounded { value, error } = found.angular_frequency.0?;
            let relative = error / value.hi();
            [
                nearest_wide(value * INVERSE_TAU, relative + 2.0 * Dd::UNIT)?,
                nearest_wide(value / natural, relative + NATURAL_ERROR + Dd::UNIT)?,
            ]
        };
        Some(Self { frequency_hz, natural_angular_frequency_per_s, frequency_over_natural })
    }

    fn by_enclosures(parameters: &Parameters<Rational>, natural_squared: &Rational) -> Self {
        let cubic = parameters.characteristic_cubic_per_s();
        // The pair's upper root is the last one.
        let angular = |digits| certified_roots(&cubic, digits).roots.last().map(|root| root.im_ball());
        let angular = |digits| angular(digits).unwrap_or_else(|| Ball::from(0));
        let natural = |digits| Ball::from_rational(natural_squared, bits_for_digits(digits)).sqrt();
        let hertz = |digits| {
            let angular = angular(digits);
            let tau = Ball::pi(bits_for_digits(digits)) * Ball::from(2);
            angular / tau
        };
        let is_natural = |value: &Rational| Rational::from(value.square_ref()) == *natural_squared;
        let is_ratio = |value: &Rational| {
            let squared = Rational::from(value.square_ref());
            Depressed::of(&cubic).is_some_and(|cubic| equation_at_ratio(&cubic, &squared).is_zero())
        };
        Self {
            frequency_hz: nearest(hertz, |_| false),
            natural_angular_frequency_per_s: nearest(natural, is_natural),
            frequency_over_natural: nearest(|digits| angular(digits) / natural(digits), is_ratio),
        }
    }
}

/// The rounded number, if all numbers within a relative error of this one round to it.
fn nearest_wide(value: Dd, relative_error: f64) -> Option<Wide> {
    value.rounded_surely(relative_error).and_then(Wide::from_f64)
}

/// The number that lies in an enclosure for any number of digits, rounded to 53 bits. `is_exactly` decides whether a midpoint of
/// two neighbours that lies in an enclosure of [`FIRST_DIGITS`] or more is the number itself.
fn nearest(enclosure: impl Fn(u32) -> Ball, is_exactly: impl Fn(&Rational) -> bool) -> Wide {
    let mut digits = FIRST_DIGITS;
    loop {
        let ball = enclosure(digits);
        let [low, high] = [ball.lower(), ball.upper()].map(|end| Float::with_val(53, end));
        if low == high {
            return Wide::from_float(&low);
        }
        let middle = Float::with_val(60, &low + &high) / 2u32;
        if middle.to_rational().is_some_and(|middle| is_exactly(&middle)) {
            return Wide::from_float(&middle);
        }
        digits *= 2;
    }
}

#[cfg(test)]
mod tests;
