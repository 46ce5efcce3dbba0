//! Crossings of the boundary by halving between two points of different exact class of eq 8.
//!
//! Nothing is used but the decision whether all roots of eq 8 are real: no curve, no polynomial in σ or V0.

use rug::{Float, Rational};

use crate::friction::Slider;
use crate::number::{Ball, bits_for_digits};
use crate::stability::boundary::Section;
use crate::stability::boundary_sign;

/// The crossing between two values of the unknown coordinate (σ in Pa at given V0, V0 in m/s at given σ).
///
/// None when the class at both ends is the same. The relative radius is at most 10^−digits.
#[must_use]
pub fn by_bisection(
    slider: &Slider<Rational>,
    section: &Section,
    (lower, upper): (&Rational, &Rational),
    digits: u32,
) -> Option<Ball> {
    let bits = bits_for_digits(digits);
    let sign = |coordinate: &Rational| sign_at(slider, section, coordinate);
    let (at_lower, at_upper) = (sign(lower), sign(upper));
    for (end, at_end) in [(lower, at_lower), (upper, at_upper)] {
        if at_end == 0 {
            return Some(Ball::from_rational(end, bits));
        }
    }
    if at_lower == at_upper {
        return None;
    }
    let (mut low, mut high) = (lower.clone(), upper.clone());
    // Each step halves the width; the midpoint is rounded to a dyadic of few bits, so that numbers stay short.
    while Rational::from(&high - &low) << bits > low {
        let middle = short_midpoint(&low, &high);
        match sign(&middle) {
            0 => return Some(Ball::from_rational(&middle, bits)),
            at_middle if at_middle == at_lower => low = middle,
            _ => high = middle,
        }
    }
    Some(between(&low, &high, bits))
}

/// The sign of the discriminant with the unknown coordinate set.
fn sign_at(slider: &Slider<Rational>, section: &Section, coordinate: &Rational) -> i8 {
    let there = match section {
        Section::AtVelocity(velocity) => slider.at(coordinate.clone(), velocity.clone()),
        Section::AtNormalStress(stress) => slider.at(stress.clone(), coordinate.clone()),
    };
    boundary_sign(&there.groups())
}

/// A number strictly between the two, within an eighth of the interval of its middle, with as few bits as that takes.
fn short_midpoint(low: &Rational, high: &Rational) -> Rational {
    let middle = Rational::from(low + high) / 2_u32;
    let width = Rational::from(high - low);
    let exponent =
        |x: &Rational| i64::from(x.numer().significant_bits()) - i64::from(x.denom().significant_bits());
    let bits = (exponent(&middle) - exponent(&width)).max(0) + 6;
    let rounded = Float::with_val(u32::try_from(bits).unwrap_or(u32::MAX), &middle);
    rounded.to_rational().unwrap_or(middle)
}

fn between(low: &Rational, high: &Rational, bits: u32) -> Ball {
    let middle = Rational::from(low + high) / 2_u32;
    let radius = Float::with_val_round(32, Rational::from(high - low) / 2_u32, rug::float::Round::Up).0;
    Ball::from_rational(&middle, bits + 8) + Ball::new(Float::new(bits + 8), radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::boundary::by_discriminant;
    use crate::stability::fixtures::paper;

    #[test]
    fn equal_classes_have_no_crossing_between_them() {
        let section = Section::AtVelocity(Rational::from((1, 1_000_000)));
        let stress = |value: i64| Rational::from(value);
        assert!(by_bisection(&paper(), &section, (&stress(20_000), &stress(100_000)), 20).is_none());
        assert!(by_bisection(&paper(), &section, (&stress(3_000), &stress(100_000)), 20).is_some());
    }

    #[test]
    fn the_velocity_found_at_a_normal_stress_is_the_discriminants() {
        let section = Section::AtNormalStress(Rational::from(3_000));
        let exact = by_discriminant(&paper(), &section, 30).unwrap();
        let ends = (Rational::from((1, 1_000_000)), Rational::from(1));
        let found = by_bisection(&paper(), &section, (&ends.0, &ends.1), 30);
        assert!(found.is_some_and(|ball| ball.overlaps(&exact[0].value)));
    }
}
