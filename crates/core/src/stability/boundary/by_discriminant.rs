//! Crossings of the boundary as roots of the discriminant of eq 8: isolated exactly over ℚ, then refined.
//!
//! At given V0 the ratio g = η/κ is fixed and Δ(gκ, κ, β) is a quartic in κ ∝ 1/σ; at given σ κ is fixed and
//! Δ(η, κ, β) is a cubic in η ∝ V0². Sturm's theorem counts the positive roots, so none is missed and none invented.

use std::cmp::Ordering;

use rug::Rational;

use crate::friction::{Groups, Slider};
use crate::number::{Ball, Field, bits_for_digits};
use crate::roots::discriminant;
use crate::stability::Arc;
use crate::stability::boundary::{Crossing, Section};
use slipmode_algebra::{IsolatingInterval, UnivariatePolynomial};

/// Bits beyond the digits requested, for the arithmetic after the root is known.
const GUARD_BITS: u32 = 24;

/// The groups along a section, as functions of the unknown: κ at given V0, η at given σ.
struct Line {
    effect_ratio: Rational,
    /// g = η/κ, or κ.
    given: Rational,
    at_velocity: bool,
}

/// All crossings of the section, by σ descending (given V0) or V0 ascending (given σ).
#[must_use]
pub fn by_discriminant(slider: &Slider<Rational>, section: &Section, digits: u32) -> Vec<Crossing> {
    let bits = bits_for_digits(digits) + GUARD_BITS;
    let line = Line::new(slider, section);
    let polynomial = line.along(|groups| discriminant(&groups.characteristic_cubic()), 4);
    let cusps = line.along(|groups| distance_from_cusp(&groups.characteristic_cubic()), 2).gcd(&polynomial);
    polynomial
        .isolate_positive_roots()
        .iter()
        .map(|interval| {
            let arc = line.arc(&polynomial, &cusps, interval, bits);
            let groups =
                line.groups(polynomial.refine(interval, bits), |value| Ball::from_rational(value, bits));
            Crossing { arc, position: section.coordinates(slider, &groups, bits) }
        })
        .collect()
}

impl Line {
    fn new(slider: &Slider<Rational>, section: &Section) -> Self {
        let (given, at_velocity) = match section {
            Section::AtVelocity(velocity) => (Section::velocity_squared(slider, velocity), true),
            Section::AtNormalStress(stress) => (Section::stiffness_group(slider, stress), false),
        };
        Self { effect_ratio: slider.effect_ratio(), given, at_velocity }
    }

    fn groups<R: Field>(&self, unknown: R, convert: impl Fn(&Rational) -> R) -> Groups<R> {
        let (given, effect_ratio) = (convert(&self.given), convert(&self.effect_ratio));
        if self.at_velocity {
            Groups { inertial_parameter: given * &unknown, stiffness_group: unknown, effect_ratio }
        } else {
            Groups { inertial_parameter: unknown, stiffness_group: given, effect_ratio }
        }
    }

    /// A polynomial function of the groups as a polynomial of the unknown, from its values at 0, 1, …, degree.
    fn along(&self, function: impl Fn(&Groups<Rational>) -> Rational, degree: i32) -> UnivariatePolynomial {
        let values =
            (0..=degree).map(|x| function(&self.groups(Rational::from(x), Rational::clone))).collect();
        UnivariatePolynomial::interpolating(values)
    }

    /// The arc: on the upper one r > −1, on the lower one r < −1. The precision is raised until r tells which it is.
    fn arc(
        &self,
        polynomial: &UnivariatePolynomial,
        cusps: &UnivariatePolynomial,
        interval: &IsolatingInterval,
        bits: u32,
    ) -> Arc {
        let is_cusp = cusps.has_root_in(interval);
        let mut precision = bits;
        loop {
            let unknown = polynomial.refine(interval, precision);
            let groups = self.groups(unknown, |value| Ball::from_rational(value, precision));
            let root = double_root(&groups.characteristic_cubic(), is_cusp);
            let sign = (root + Ball::from(1)).sign();
            if sign.is_some() || precision > bits.saturating_mul(64) {
                return if sign == Some(Ordering::Less) { Arc::Lower } else { Arc::Upper };
            }
            precision = precision.saturating_mul(2);
        }
    }
}

/// c2² − 3c1c3: zero, on the boundary, only where all three roots coincide.
fn distance_from_cusp<R: Field>([_, c1, c2, c3]: &[R; 4]) -> R {
    c2.square() - R::from(3) * c1 * c3
}

/// r = (9c0c3 − c1c2)/(2(c2² − 3c1c3)), or −c2/(3c3) at a cusp.
fn double_root<R: Field>(cubic: &[R; 4], is_cusp: bool) -> R {
    let [c0, c1, c2, c3] = cubic;
    if is_cusp {
        return -(c2.clone() / (R::from(3) * c3));
    }
    (R::from(9) * c0 * c3 - c1.clone() * c2) / (R::from(2) * distance_from_cusp(cubic))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_root_is_found_beside_a_third_one_and_in_a_cube() {
        let cubic = |coefficients: [i32; 4]| coefficients.map(Rational::from);
        // 2(x + 3)²(x − 1) and 2(x + 3)³.
        assert_eq!(double_root(&cubic([-18, 6, 10, 2]), false), -3);
        assert_eq!(double_root(&cubic([54, 54, 18, 2]), true), -3);
    }
}
