//! How far a point of the (V0, σ) plane is from the transition and from the boundary, along each axis.

use rug::{Float, Rational};

use super::boundary::{BoundaryCurve, Section};
use super::logarithm::log10_one_plus;
use super::{boundary_sign, transition_sign};
use crate::friction::{OperatingPoint, Parameters};
use crate::number::{Ball, Wide};

/// Signed decimal logarithms of (coordinate of the line)/(coordinate of the point), of the nearest such place.
///
/// ```
/// use slipmode_core::stability::LogDistance;
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// // Without inertia K = K_c at σ_c = 50 kPa: from 5 kPa it is one decade up.
/// let distance = LogDistance::to_transition(&slider.at(number("5e3"), number("1e-9")));
/// assert!((distance.normal_stress.unwrap().to_f64().unwrap() - 1.0).abs() < 1e-6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogDistance {
    /// log10(σ_line/σ) at the same V0; `None` when the line has no point there.
    pub normal_stress: Option<Wide>,
    /// log10(V_line/V0) at the same σ; `None` when the line has no point there.
    pub loading_velocity: Option<Wide>,
}

impl LogDistance {
    const ON_THE_LINE: Self = Self { normal_stress: Some(Wide::ZERO), loading_velocity: Some(Wide::ZERO) };

    /// The distance to K = K_c; there is none for b ≤ a, where the transition does not exist.
    #[must_use]
    pub fn to_transition(parameters: &Parameters<Rational>) -> Self {
        if transition_sign(&parameters.groups()) == 0 {
            return Self::ON_THE_LINE;
        }
        let Parameters { slider, point: OperatingPoint { normal_stress_pa, loading_velocity_m_per_s } } =
            parameters;
        if !slider.has_transition() {
            return Self { normal_stress: None, loading_velocity: None };
        }
        let stress_ratio = slider.transition_normal_stress_pa(loading_velocity_m_per_s) / normal_stress_pa;
        let velocity_squared_ratio =
            slider.transition_velocity_squared(normal_stress_pa) / loading_velocity_m_per_s.clone().square();
        Self { normal_stress: log10(stress_ratio, 1), loading_velocity: log10(velocity_squared_ratio, 2) }
    }

    /// The distance to max Im(s) = 0.
    #[must_use]
    pub fn to_boundary(parameters: &Parameters<Rational>) -> Self {
        if boundary_sign(&parameters.groups()) == 0 {
            return Self::ON_THE_LINE;
        }
        let (slider, point) = (&parameters.slider, &parameters.point);
        let (stress, velocity) = (&point.normal_stress_pa, &point.loading_velocity_m_per_s);
        let curve = BoundaryCurve::new(slider, FIRST_DIGITS);
        Self {
            normal_stress: nearest(&curve, stress, &Section::AtVelocity(velocity.clone())),
            loading_velocity: nearest(&curve, velocity, &Section::AtNormalStress(stress.clone())),
        }
    }
}

/// log10(ratio)/divisor of a positive ratio: that of the ratio or its inverse above 1, so that no digits are lost next to −1.
fn log10(ratio: Rational, divisor: i32) -> Option<Wide> {
    (ratio > 0).then(|| {
        let (above, divisor) = if ratio < 1 { (ratio.recip(), -divisor) } else { (ratio, divisor) };
        let excess = Ball::from_rational(&(above - 1u32), 80);
        Wide::from_float(&Float::with_val(80, log10_one_plus(&excess).centre() / divisor))
    })
}

/// Digits at which a distance is looked for first: enough for all but points made to be near.
const FIRST_DIGITS: u32 = 40;
/// Digits beyond which no point made of decimals of the grammar can hide its distance.
const MOST_DIGITS: u32 = 1 << 17;

/// The smallest of the distances from `from` to the curve's coordinates on a section, with as many digits as it takes to tell it
/// from zero. The curve has [`FIRST_DIGITS`].
fn nearest(curve: &BoundaryCurve, from: &Rational, section: &Section) -> Option<Wide> {
    let mut digits = FIRST_DIGITS;
    let mut there = curve.coordinates(section);
    loop {
        let distances: Vec<Ball> = there.iter().map(|coordinate| log10_ratio(coordinate, from)).collect();
        let separated = distances.iter().all(|distance| distance.relative_radius_log2() < -60.0);
        if separated || digits >= MOST_DIGITS {
            let magnitude = |distance: &&Ball| Wide::from_float(distance.centre()).to_float().abs();
            let least = distances.iter().min_by(|x, y| magnitude(x).total_cmp(&magnitude(y)));
            return least.map(|distance| Wide::from_float(distance.centre()));
        }
        digits *= 4;
        there = curve.with_digits(digits).coordinates(section);
    }
}

fn log10_ratio(there: &Ball, from: &Rational) -> Ball {
    let from = Ball::from_rational(from, there.precision_bits());
    log10_one_plus(&((there.clone() - &from) / from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use crate::stability::fixtures::{paper, with_effects};

    fn at(stress: &str, velocity: &str) -> Parameters<Rational> {
        paper().at(parse_decimal(stress).unwrap(), parse_decimal(velocity).unwrap())
    }

    fn number(distance: Option<Wide>) -> f64 {
        distance.unwrap().to_f64().unwrap()
    }

    #[test]
    fn the_transition_of_the_papers_values_is_where_eq_9_says() {
        // σ_c = 50 kPa, and σ = σ_c − M V0²/(a D_c) = 49 750 Pa at V0 = 0.1 mm/s.
        let distance = LogDistance::to_transition(&at("497500", "1e-4"));
        assert!((number(distance.normal_stress) + 1.0).abs() < 1e-15);
        assert!(distance.loading_velocity.is_none(), "σ above σ_c is unstable at any velocity");
        assert_eq!(LogDistance::to_transition(&at("49750", "1e-4")), LogDistance::ON_THE_LINE);
        let slower = LogDistance::to_transition(&at("49750", "1e-5"));
        assert!((number(slower.loading_velocity) - 1.0).abs() < 1e-15, "a decade of velocity: {slower:?}");
        let stable = with_effects(Rational::from((6, 1000)), Rational::from((4, 1000)));
        assert!(
            LogDistance::to_transition(&stable.at(Rational::from(1), Rational::from(1)))
                .normal_stress
                .is_none()
        );
    }

    #[test]
    fn powers_of_ten_have_their_exponents_far_from_the_transition_and_next_to_it() {
        for power in [1, 11, 15, 16, 17, 33, 300] {
            let ratio = parse_decimal(&format!("1e{power}")).unwrap();
            assert_eq!(number(log10(ratio.clone(), 1)), f64::from(power));
            assert_eq!(number(log10(ratio.recip(), 2)), -0.5 * f64::from(power));
        }
        // log10(1 ± x) = ±x/ln 10 − x²/(2 ln 10) ± …
        for sign in [1, -1] {
            let small = parse_decimal("1e-30").unwrap() * sign;
            let expected = f64::from(sign) * 1e-30 * std::f64::consts::LOG10_E;
            assert!((number(log10(small + 1u32, 1)) / expected - 1.0).abs() < 1e-15);
        }
        assert!(log10(Rational::new(), 1).is_none());
    }

    #[test]
    fn a_distance_from_the_boundary_is_resolved_however_small() {
        // Eq 16 to leading order, and then a point next to the crossing that the curve gives.
        let curve = BoundaryCurve::new(&paper(), 80);
        let velocity = parse_decimal("1e-5").unwrap();
        let crossing = curve.on_section(&Section::AtVelocity(velocity.clone())).remove(1).normal_stress_pa;
        let factor = parse_decimal("1.00000000000000000000000000000000000000000000000001").unwrap();
        let beside = crossing.centre().to_rational().unwrap() * factor;
        let distance = number(LogDistance::to_boundary(&paper().at(beside, velocity)).normal_stress);
        assert!((distance / -4.342_944_819_032_518e-51 - 1.0).abs() < 1e-12, "{distance:e}");
    }
}
