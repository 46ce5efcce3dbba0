//! One point of the boundary by each route: what it takes for so many digits.
//!
//! The section is σ = 1 kPa of the scene's slider, on the lower arc. Bisection needs one exact sign per bit; the curve is
//! evaluated once at its parameter. The reference is the section solved to twenty digits more.

use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational, bits_for_digits};
use slipmode_core::stability::boundary::{BoundaryCurve, Section, by_discriminant};
use slipmode_core::stability::boundary_sign;

/// One route at so many digits.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryCount {
    /// The route.
    pub route: &'static str,
    /// Digits requested.
    pub digits: u32,
    /// What is counted.
    pub counted: &'static str,
    /// How many of them; none where the route does not say.
    pub count: Option<u64>,
    /// −log10 of the error relative to the reference, as far as the reference goes.
    pub digits_right: f64,
    /// Whether its enclosure overlaps the reference's.
    pub agrees: bool,
}

/// Digits of the reference beyond those requested.
const MORE_DIGITS: u32 = 20;

/// σ of the section that is crossed, Pa.
const NORMAL_STRESS_PA: i32 = 1_000;

/// Halving to more digits than this takes longer than it shows.
const MOST_HALVED_DIGITS: u32 = 1_000;

/// Every route at every number of digits; nothing when the section does not cross the boundary once.
pub(crate) fn count(parameters: &Slider<Rational>, digits: &[u32]) -> Vec<BoundaryCount> {
    digits.iter().flat_map(|&digits| at(parameters, digits).unwrap_or_default()).collect()
}

fn at(slider: &Slider<Rational>, digits: u32) -> Option<Vec<BoundaryCount>> {
    let section = Section::AtNormalStress(Rational::from(NORMAL_STRESS_PA));
    let fine = BoundaryCurve::new(slider, digits + MORE_DIGITS).on_section(&section);
    let [reference] = fine.as_slice() else { return None };
    let velocity = &reference.loading_velocity_m_per_s;
    let curve = BoundaryCurve::new(slider, digits);
    let row = |route, counted, count, found: &Ball| BoundaryCount {
        route,
        digits,
        counted,
        count,
        digits_right: digits_right(found, velocity),
        agrees: found.overlaps(velocity),
    };
    let on_curve = curve.position(reference.arc, &reference.parameter).loading_velocity_m_per_s;
    let mut rows = vec![row("curve", "evaluations of the curve", Some(1), &on_curve)];
    for crossing in &curve.crossings(&section) {
        rows.push(row("section", "not counted", None, &crossing.position.loading_velocity_m_per_s));
    }
    for solution in &by_discriminant(slider, &section, digits).ok()? {
        rows.push(row("discriminant", "not counted", None, &solution.value));
    }
    if digits <= MOST_HALVED_DIGITS
        && let Some((found, signs)) = halve(slider, velocity, digits)
    {
        rows.push(row("bisection", "exact signs", Some(signs), &found));
    }
    Some(rows)
}

/// Halving between half and twice the crossing; the enclosure and the signs that it took.
fn halve(slider: &Slider<Rational>, crossing: &Ball, digits: u32) -> Option<(Ball, u64)> {
    let bits = bits_for_digits(digits);
    let start = Rational::from_f64(crossing.to_f64())?;
    let sign = |velocity: &Rational| {
        boundary_sign(&slider.at(Rational::from(NORMAL_STRESS_PA), velocity.clone()).groups())
    };
    let (mut low, mut width) = (start.clone() / 2_u32, start * 2_u32);
    let at_low = sign(&low);
    let mut signs = 1;
    // Half the width is the radius: one halving less than the bits.
    for _ in 0..bits {
        width /= 2_u32;
        let middle = Rational::from(&low + &width);
        signs += 1;
        match sign(&middle) {
            0 => return Some((Ball::from_rational(&middle, bits + 8), signs)),
            at_middle if at_middle == at_low => low = middle,
            _ => {}
        }
    }
    let half = width / 2_u32;
    let radius = rug::Float::with_val_round(32, &half, rug::float::Round::Up).0;
    let centre = Ball::from_rational(&(low + half), bits + 8);
    Some((centre + Ball::new(rug::Float::new(bits + 8), radius), signs))
}

fn digits_right(found: &Ball, reference: &Ball) -> f64 {
    let bits = reference.precision_bits();
    let difference = rug::Float::with_val(bits, found.centre() - reference.centre());
    let most = -reference.relative_radius_log2() * std::f64::consts::LOG10_2;
    if difference.is_zero() {
        return most;
    }
    let size = rug::Float::with_val(64, reference.centre().clone().abs().log10_ref());
    // not f64: MPFR's.
    (size - difference.abs().log10()).to_f64().min(most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::counts::paper;

    #[test]
    fn every_route_has_its_digits_and_halving_takes_a_sign_for_each_bit() {
        let rows = count(&paper(), &[16, 50]);
        assert_eq!(rows.len(), 8);
        for row in &rows {
            assert!(row.agrees && row.digits_right >= f64::from(row.digits), "{row:?}");
        }
        let halving = rows.iter().find(|row| row.route == "bisection" && row.digits == 50).unwrap();
        assert!(halving.count.is_some_and(|count| (160..180).contains(&count)), "{halving:?}");
    }
}
