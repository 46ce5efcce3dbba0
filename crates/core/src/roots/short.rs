//! Cubics whose coefficients are short integers: exact signs, and roots whose every part keeps its relative accuracy.
//!
//! In exact integers, with y = 3c3·x + c2 and y³ + 3P'y + Q = 0 as in [`depressed`](super::depressed):
//! P' = 3c1c3 − c2², Q = c2(2c2² − 9c1c3) + 27c0c3², Δ, and H = c1c2 − c0c3. Each is rounded once, to double-double, after
//! all that cancels next to a double or triple root or to K = K_c has cancelled. The outermost root y is well-conditioned
//! in P' and Q; the others are x = (−y − 2c2)/(6c3) ± (9/2)√Δ/f'(y), f'(y) = 3(y² + P'), and a pair's real part is also
//! −H/(2c3²·|x_real + pair|²).

use super::forward::{Bounded, BoundedCubic, Pair, Spectrum};
use crate::number::{Dd, Field, Real, ShortInteger};

/// The most bits of a coefficient: Δ has terms of four coefficients and is at most 2^8 times as large as one of them.
pub(crate) const COEFFICIENT_BITS: u32 = ShortInteger::BITS / 4 - 4;

/// Bound on the relative error of an integer rounded to double-double.
const ROUNDING: f64 = Dd::UNIT / 4.0;

/// Covers the second order of first-order bounds and the rounding of the bounds themselves.
const SLACK: f64 = 1.05;

/// What is exactly known of a cubic of positive leading coefficient.
#[derive(Debug, Clone)]
pub(crate) struct ShortCubic {
    quadratic: ShortInteger,
    lead: ShortInteger,
    third_of_linear: ShortInteger,
    constant: ShortInteger,
    discriminant: ShortInteger,
    hurwitz: ShortInteger,
}

impl ShortCubic {
    /// The cubic with these coefficients by ascending power; `None` when one is too long or the last is not positive.
    pub(crate) fn of(coefficients: [&ShortInteger; 4]) -> Option<Self> {
        let fits = coefficients.iter().all(|coefficient| coefficient.bits() <= COEFFICIENT_BITS);
        let [c0, c1, c2, c3] = coefficients;
        if !fits || c3.sign() <= 0 {
            return None;
        }
        let square = c2.squared();
        let (inner, outer) = (c1.times(c2), c0.times(c3));
        let (even, odd) = (c0.times(c2), c1.times(c3));
        let shifted = square.shifted(1).minus(&odd.scaled(9));
        let cubes = even.times(&square).plus(&odd.times(&c1.squared())).shifted(2);
        let products = inner.squared().plus(&inner.times(&outer).scaled(18));
        Some(Self {
            third_of_linear: odd.scaled(3).minus(&square),
            constant: c2.times(&shifted).plus(&outer.times(c3).scaled(27)),
            discriminant: products.minus(&cubes).minus(&outer.squared().scaled(27)),
            hurwitz: inner.minus(&outer),
            quadratic: *c2,
            lead: *c3,
        })
    }

    /// The sign of the discriminant.
    pub(crate) const fn discriminant_sign(&self) -> i8 {
        self.discriminant.sign()
    }

    /// The sign of c1c2 − c0c3; for eq 8 that of K − K_c.
    pub(crate) const fn hurwitz_sign(&self) -> i8 {
        self.hurwitz.sign()
    }

    /// The roots with error bounds, double roots as two equal ones.
    ///
    /// `None` when the numbers leave double-double's range.
    pub(crate) fn spectrum(&self) -> Option<Spectrum<Dd>> {
        let scale = self.third_of_linear.bits().div_ceil(2).max(self.constant.bits().div_ceil(3)) as i32;
        let scaled = |value: &ShortInteger, power: i32| scaled(value, power * scale);
        let (c2, c3) = (scaled(&self.quadratic, 1)?, scaled(&self.lead, 1)?);
        let third = scaled(&self.third_of_linear, 2)?;
        let y = outermost(third * Dd::from(3.0), scaled(&self.constant, 3)?)?;
        let real = divided(&Bounded { value: y.value - c2, error: sum_error(&y, c2) }, c3 * Dd::from(3.0));
        let pair = Bounded { value: -y.value - c2 * Dd::from(2.0), error: sum_error(&y, c2 * Dd::from(2.0)) };
        let re = divided(&pair, c3 * Dd::from(6.0));
        let slope = (y.value.square() + third) * Dd::from(3.0);
        let width = self.half_width(&y, third, slope, scale)?;
        let pair = if self.discriminant_sign() < 0 {
            Pair::Complex { re: self.better_real_part(re, &real, &width, c3, scale), im: width }
        } else {
            let end = |value: Dd| Bounded {
                value,
                error: (re.error + width.error + value.hi().abs() * Dd::UNIT) * SLACK,
            };
            Pair::Real([end(re.value - width.value), end(re.value + width.value)])
        };
        Some(Spectrum { real, pair })
    }

    /// (9/2)√|Δ|/f'(y), all in units of 2^scale; zero exactly when Δ is.
    ///
    /// y² + P' ≥ y²/3 ≥ |P'|/3 on the outermost root, so that its relative error is at most 9 of P' and 6 of y.
    fn half_width(&self, y: &Bounded<Dd>, third: Dd, slope: Dd, scale: i32) -> Option<Bounded<Dd>> {
        if self.discriminant_sign() == 0 {
            return Some(Bounded { value: Dd::from(0.0), error: 0.0 });
        }
        let (mantissa, exponent) = self.discriminant.as_double_double();
        let odd = exponent.rem_euclid(2);
        let root = mantissa.abs().scale(f64::from(1 << odd)).sqrt();
        let value = root * Dd::from(4.5) / slope * Dd::from(power_of_two((exponent - odd) / 2 - 2 * scale)?);
        let in_slope = 9.0 * (ROUNDING + Dd::UNIT) + 6.0 * y.error / y.value.hi().abs();
        let relative = (in_slope + ROUNDING + 6.0 * Dd::UNIT) * SLACK;
        let usable = third.is_finite() && relative < 1e-3 && value.hi() > MOST_SMALL;
        usable.then_some(Bounded { value, error: relative * value.hi() })
    }

    /// The real part of a pair, from the sum of the roots or from H, whichever is known better.
    fn better_real_part(
        &self,
        by_sum: Bounded<Dd>,
        real: &Bounded<Dd>,
        im: &Bounded<Dd>,
        c3: Dd,
        scale: i32,
    ) -> Bounded<Dd> {
        if self.hurwitz_sign() == 0 {
            return Bounded { value: Dd::from(0.0), error: 0.0 };
        }
        let Some(hurwitz) = scaled(&self.hurwitz, 2 * scale) else { return by_sum };
        let sum = real.value + by_sum.value;
        let sum_error = real.error + by_sum.error + Dd::UNIT * sum.hi().abs();
        let squared = sum.square() + im.value.square();
        let squared_error = 2.0 * (sum.hi().abs() + sum_error) * sum_error + 2.0 * im.value.hi() * im.error;
        let relative = squared_error / squared.hi() + 2.0 * ROUNDING + 6.0 * Dd::UNIT;
        let value = -hurwitz / (c3.square() * squared * Dd::from(2.0));
        let error = value.hi().abs() * relative * SLACK;
        // Written so that what is not a number is never taken.
        let better = relative < 1e-3 && value.hi().abs() > MOST_SMALL && error < by_sum.error;
        if better { Bounded { value, error } } else { by_sum }
    }
}

/// Below this the trailing half of a double-double may be lost to underflow.
const MOST_SMALL: f64 = 1e-250;

/// value·2^−exponent in double-double, when its range has room for the products that follow.
fn scaled(value: &ShortInteger, exponent: i32) -> Option<Dd> {
    let (mantissa, own) = value.as_double_double();
    if value.sign() == 0 {
        return Some(mantissa);
    }
    Some(mantissa.scale(power_of_two(own - exponent)?))
}

/// 2^exponent within ±2^300: squares and quotients of such numbers, times a unit, stay normal.
fn power_of_two(exponent: i32) -> Option<f64> {
    (-300..=300).contains(&exponent).then(|| f64::from_bits(((1023 + exponent) as u64) << 52))
}

/// The outermost root of y³ + py + q, each known to a few roundings; zero exactly for p = q = 0.
fn outermost(p: Dd, q: Dd) -> Option<Bounded<Dd>> {
    if p.hi() == 0.0 && q.hi() == 0.0 {
        return Some(Bounded { value: Dd::from(0.0), error: 0.0 });
    }
    let coefficients = [q, p, Dd::from(0.0), Dd::from(1.0)];
    let magnitudes = coefficients.map(|coefficient| coefficient.hi().abs());
    let root = BoundedCubic { coefficients, magnitudes, relative_error: 2.0 * Dd::UNIT }.outermost_root();
    (root.error <= 1e-3 * root.value.hi().abs()).then_some(root)
}

/// The error of y + c, c being known to a rounding.
fn sum_error(y: &Bounded<Dd>, c: Dd) -> f64 {
    (y.error + Dd::UNIT * (2.0 * c.hi().abs() + y.value.hi().abs())) * SLACK
}

/// The quotient by a divisor known to two roundings.
fn divided(numerator: &Bounded<Dd>, divisor: Dd) -> Bounded<Dd> {
    let value = numerator.value / divisor;
    let error = numerator.error / divisor.hi().abs() + value.hi().abs() * 4.0 * Dd::UNIT;
    Bounded { value, error: error * SLACK }
}
