//! Roots of polynomials with ball coefficients, enclosed to any number of bits by the interval Newton method.

use std::cmp::Ordering;

use rug::{Float, Rational};

use crate::number::Ball;
use crate::{IsolatingInterval, UnivariatePolynomial};

/// Precision of the first attempt, in bits.
const FIRST_PRECISION: u32 = 96;

/// Bits carried beyond those requested; each doubling of precision costs about three of them.
const GUARD_BITS: u32 = 16;

/// A polynomial whose coefficients can be had to any precision, by ascending power.
pub trait Coefficients {
    /// The coefficients as balls of this precision.
    fn at_precision(&self, precision_bits: u32) -> Vec<Ball>;
}

impl Coefficients for UnivariatePolynomial {
    fn at_precision(&self, precision_bits: u32) -> Vec<Ball> {
        self.coefficients().iter().map(|value| Ball::from_rational(value, precision_bits)).collect()
    }
}

impl<F: Fn(u32) -> Vec<Ball>> Coefficients for F {
    fn at_precision(&self, precision_bits: u32) -> Vec<Ball> {
        self(precision_bits)
    }
}

impl UnivariatePolynomial {
    /// The root in an isolating interval of this polynomial, with a relative radius of at most 2^−bits.
    #[must_use]
    pub fn refine(&self, interval: &IsolatingInterval, bits: u32) -> Ball {
        match interval {
            IsolatingInterval::Exact(root) => Ball::from_rational(root, bits + GUARD_BITS),
            IsolatingInterval::Between(lower, upper) => {
                enclose_root(&self.squarefree().primitive(), lower, upper, bits)
            }
        }
    }
}

/// The simple root between two numbers of one sign at which the polynomial has opposite signs.
///
/// The relative radius is at most 2^−bits. When the coefficients never become precise enough to say where the root is
/// (it is not simple, or the signs at the ends are equal), the ball returned has a larger radius; it is still right.
#[must_use]
pub fn enclose_root(polynomial: &impl Coefficients, lower: &Rational, upper: &Rational, bits: u32) -> Ball {
    let target = bits.saturating_add(GUARD_BITS);
    let mut bracket = Bracket { lower: lower.clone(), upper: upper.clone() };
    let mut precision = FIRST_PRECISION;
    loop {
        match bracket.contract(&polynomial.at_precision(precision), precision) {
            Contraction::Reached(start) => return polish(polynomial, start, precision, bits),
            Contraction::EqualSigns => return bracket.ball(precision),
            Contraction::TooCoarse => {}
        }
        // Past this the root is not simple; a simple one is separated after a few times the precision requested.
        if precision > target.saturating_mul(64).max(1 << 16) {
            return bracket.ball(precision);
        }
        precision *= 2;
    }
}

/// Newton steps at doubling precision from a ball that contains a root and on which the method contracts.
pub fn polish(polynomial: &impl Coefficients, start: Ball, first_precision: u32, bits: u32) -> Ball {
    let (mut root, mut precision) = (start, first_precision);
    let limit = bits.saturating_add(GUARD_BITS).saturating_mul(64).max(1 << 16);
    while root.relative_radius_log2() > -f64::from(bits) && precision <= limit {
        let certain = (-root.relative_radius_log2()).clamp(1.0, f64::from(u32::MAX / 4)) as u32;
        let wanted = (2 * certain + GUARD_BITS).clamp(precision, bits.max(precision) + GUARD_BITS);
        let next = newton(&polynomial.at_precision(wanted), &root.with_precision(wanted));
        // Without a gain of a quarter of the bits the coefficients' own precision is what is missing.
        let gained = next.relative_radius_log2() < 1.25 * root.relative_radius_log2();
        if next.relative_radius_log2() < root.relative_radius_log2() {
            root = next;
        }
        precision = if gained { wanted } else { wanted * 2 };
    }
    root
}

/// m − p(m)/p′(X): contains every root of p in the ball X around m.
fn newton(coefficients: &[Ball], enclosure: &Ball) -> Ball {
    let middle = Ball::exact(enclosure.centre().clone());
    let value = horner(coefficients.to_vec(), &middle);
    let slope = horner(derivative(coefficients.to_vec()), enclosure);
    middle - value / slope
}

/// The coefficients of the derivative.
pub fn derivative(coefficients: Vec<Ball>) -> Vec<Ball> {
    coefficients
        .into_iter()
        .zip(0..)
        .skip(1)
        .map(|(coefficient, power)| coefficient.times_small(power))
        .collect()
}

/// The value at x of the polynomial with these coefficients, by ascending power.
pub fn horner(coefficients: Vec<Ball>, x: &Ball) -> Ball {
    coefficients
        .into_iter()
        .rev()
        .reduce(|value, coefficient| value * x + coefficient)
        .unwrap_or_else(|| Ball::from(0))
}

/// What came of the attempt to start Newton's method at one precision.
enum Contraction {
    /// A ball that holds exactly one root, in reach of Newton's method.
    Reached(Ball),
    /// The coefficients are not precise enough to say.
    TooCoarse,
    /// No change of sign between the ends.
    EqualSigns,
}

/// An interval at whose ends the polynomial has opposite signs.
struct Bracket {
    lower: Rational,
    upper: Rational,
}

impl Bracket {
    /// Halves until Newton's method maps the interval into itself.
    fn contract(&mut self, coefficients: &[Ball], precision: u32) -> Contraction {
        let sign = |x: &Rational| horner(coefficients.to_vec(), &Ball::from_rational(x, precision)).sign();
        let (Some(at_lower), Some(at_upper)) = (sign(&self.lower), sign(&self.upper)) else {
            return Contraction::TooCoarse;
        };
        if at_lower == at_upper {
            return Contraction::EqualSigns;
        }
        loop {
            let enclosure = self.ball(precision);
            let image = newton(coefficients, &enclosure);
            // Next to zero an image has no certain digit, and steps gain none.
            let is_certain = image.relative_radius_log2() < 0.0;
            if is_certain && image.lower() > enclosure.lower() && image.upper() < enclosure.upper() {
                return Contraction::Reached(image);
            }
            let exhausted = enclosure.relative_radius_log2() < 8.0 - f64::from(precision);
            if exhausted || self.halve(at_lower, sign).is_none() {
                return Contraction::TooCoarse;
            }
        }
    }

    /// Keeps the half with the change of sign. A root at the middle has no sign there, so another point is tried too.
    fn halve(&mut self, at_lower: Ordering, sign: impl Fn(&Rational) -> Option<Ordering>) -> Option<()> {
        let width = Rational::from(&self.upper - &self.lower);
        for numerator in [4_u32, 3] {
            let point = &self.lower + width.clone() * numerator / 8_u32;
            if let Some(at_point) = sign(&point).filter(|sign| *sign != Ordering::Equal) {
                *(if at_point == at_lower { &mut self.lower } else { &mut self.upper }) = point;
                return Some(());
            }
        }
        None
    }

    fn ball(&self, precision: u32) -> Ball {
        let middle = Rational::from(&self.lower + &self.upper) / 2_u32;
        let half_width = Rational::from(&self.upper - &self.lower) / 2_u32;
        let radius = Ball::from_rational(&half_width, precision).upper();
        Ball::from_rational(&middle, precision) + Ball::new(Float::new(precision), radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;

    #[test]
    fn the_square_root_of_two_to_a_thousand_digits() {
        let p = UnivariatePolynomial::from_integers(&[-2, 0, 1]);
        let root = p.refine(&p.isolate_positive_roots()[0], 3_330);
        let exact = Float::with_val(4_000, 2).sqrt();
        assert!(root.relative_radius_log2() <= -3_330.0);
        assert!(root.lower() < exact && exact < root.upper());
        let negative = IsolatingInterval::Between(Rational::from(-2), Rational::from(-1));
        assert!(p.refine(&negative, 100).upper() < 0);
    }

    #[test]
    fn a_root_far_below_the_others_is_enclosed_from_a_wide_bracket() {
        for power in [20_u32, 120, 400, 2000] {
            // (2ⁿx − 1)(x² + x + 2ⁿ).
            let scale = Rational::from(1) << power;
            let other = UnivariatePolynomial::new(vec![scale.clone(), Rational::from(1), Rational::from(1)]);
            let p = UnivariatePolynomial::new(vec![Rational::from(-1), scale]).times(&other);
            let root = p.refine(&p.isolate_positive_roots()[0], 64);
            assert!(root.relative_radius_log2() <= -64.0, "{power}");
            assert!(root.contains(&(Rational::from(1) >> power)), "{power}");
        }
    }

    #[test]
    fn a_double_root_is_refined_through_the_squarefree_part() {
        let factor = UnivariatePolynomial::from_integers(&[-3, 0, 1]);
        let p = factor.times(&factor).times(&UnivariatePolynomial::from_integers(&[5, 1]));
        let roots = p.isolate_positive_roots();
        assert_eq!(roots.len(), 1);
        let root = p.refine(&roots[0], 200);
        assert!(root.relative_radius_log2() <= -200.0);
        assert!((root.square() - Ball::from(3)).contains_zero());
    }

    #[test]
    fn roots_that_agree_in_forty_digits_are_told_apart() {
        let near = Rational::from((1, 3)) + crate::number::parse_decimal("1e-40").unwrap_or_default();
        let factor =
            |root: &Rational| UnivariatePolynomial::new(vec![Rational::from(-root), Rational::from(1)]);
        let third = Rational::from((1, 3));
        let p = factor(&near).times(&factor(&third));
        let roots = p.isolate_positive_roots();
        assert_eq!(roots.len(), 2);
        let (first, second) = (p.refine(&roots[0], 60), p.refine(&roots[1], 60));
        assert!(first.contains(&third) && second.contains(&near));
        assert!(p.refine(&roots[0], 300).upper() < p.refine(&roots[1], 300).lower());
    }

    #[test]
    fn a_bracket_without_a_change_of_sign_gives_back_the_whole_bracket() {
        let p = UnivariatePolynomial::from_integers(&[1, 0, 1]);
        let ball = enclose_root(&p, &Rational::from(1), &Rational::from(2), 50);
        assert!(ball.contains(&Rational::from(1)) && ball.contains(&Rational::from(2)));
    }
}
