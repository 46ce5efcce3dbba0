//! The frequency of the oscillating pair: enclosed at a point, against ω_n, along K = K_c and along lines of constant σ.
//!
//! With p = s·D_c/V0 = x ± iω the pair of eq 8, ω is in units of V0/D_c and ω_n² in the same units is κ/η.

use rug::Rational;

use crate::friction::{Groups, Parameters};
use crate::number::{Ball, Field, Real, bits_for_digits};
use crate::polynomial::UnivariatePolynomial;
use crate::roots::{certified_roots, discriminant};

/// Digits beyond those requested, for the few operations on the roots.
const GUARD_DIGITS: u32 = 5;

/// The oscillating pair of eq 8 at one point.
#[derive(Debug, Clone)]
pub struct Oscillation {
    /// Re(s), 1/s: negative when the oscillation decays.
    pub growth_rate_per_s: Ball,
    /// |Im(s)|, 1/s.
    pub angular_frequency_per_s: Ball,
    /// |Im(s)|/ω_n: always below 1, because |s|² = ω_n²/|t| with the real root t < −1.
    pub ratio_to_natural: Ball,
    /// ∂ ln ω/∂ ln M at the other six inputs fixed: 0 for an oscillation without inertia, −1/2 for ω_n.
    pub mass_sensitivity: Ball,
    /// ∂ ln ω/∂ ln K: 1/2 for ω_n, and not 0 in the quasi-static range either.
    pub stiffness_sensitivity: Ball,
    /// ∂ ln ω/∂ ln V0: 1 where eq 23 holds, 0 for ω_n.
    pub velocity_sensitivity: Ball,
}

/// The oscillating pair at a point, to this many digits; none when all roots are real.
#[must_use]
pub fn oscillation(parameters: &Parameters<Rational>, digits: u32) -> Option<Oscillation> {
    let groups = parameters.groups();
    let found = certified_roots(&groups.characteristic_cubic(), digits + GUARD_DIGITS);
    let root = found.roots.last().filter(|root| !root.im.is_zero())?;
    let (re, im) = (root.re_ball(), root.im_ball());
    let bits = im.precision_bits();
    let ball = |value: &Rational| Ball::from_rational(value, bits);
    let rate = ball(&parameters.rate_per_s());
    let natural_squared = ball(&Rational::from(&groups.stiffness_group / &groups.inertial_parameter));
    let [by_inertia, by_stiffness] =
        sensitivities(&groups.map(ball), &Pair { re: re.clone(), im: im.clone() });
    Some(Oscillation {
        growth_rate_per_s: re * &rate,
        angular_frequency_per_s: im.clone() * rate,
        ratio_to_natural: im / natural_squared.sqrt(),
        velocity_sensitivity: Ball::from(1) + Ball::from(2) * &by_inertia,
        mass_sensitivity: by_inertia,
        stiffness_sensitivity: by_stiffness,
    })
}

/// A complex number.
struct Pair {
    re: Ball,
    im: Ball,
}

impl Pair {
    fn times(&self, other: &Self) -> Self {
        Self {
            re: self.re.clone() * &other.re - self.im.clone() * &other.im,
            im: self.re.clone() * &other.im + self.im.clone() * &other.re,
        }
    }

    /// The imaginary part of self/other.
    fn imaginary_of_quotient(&self, other: &Self) -> Ball {
        (self.im.clone() * &other.re - self.re.clone() * &other.im) / (other.re.square() + other.im.square())
    }
}

/// ∂ ln ω/∂ ln η and ∂ ln ω/∂ ln κ, from F(p) = 0: dp = −((p³+p²)dη + (p+1)dκ)/F′(p).
fn sensitivities(groups: &Groups<Ball>, p: &Pair) -> [Ball; 2] {
    let [_, c1, c2, c3] = groups.characteristic_cubic();
    let next = Pair { re: p.re.clone() + Ball::from(1), im: p.im.clone() };
    let square = p.times(p);
    let slope = Pair {
        re: Ball::from(3) * &c3 * &square.re + Ball::from(2) * &c2 * &p.re + c1,
        im: Ball::from(3) * c3 * &square.im + Ball::from(2) * c2 * &p.im,
    };
    let of = |direction: &Pair, group: &Ball| -(direction.imaginary_of_quotient(&slope) * group / &p.im);
    [of(&square.times(&next), &groups.inertial_parameter), of(&next, &groups.stiffness_group)]
}

/// (ω/ω_n)² on K = K_c: η/(1+η) = (V0/V_c)². Eq 23 meets ω_n at V_c, where σ = 0.
#[must_use]
pub fn transition_ratio_squared<R: Field>(inertial_parameter: &R) -> R {
    inertial_parameter.clone() / (R::from(1) + inertial_parameter)
}

/// η on K = K_c where (ω/ω_n)² has the value T, 0 < T < 1: T/(1−T).
#[must_use]
pub fn transition_inertial_parameter<R: Field>(ratio_squared: &R) -> R {
    ratio_squared.clone() / (R::from(1) - ratio_squared)
}

/// The angular frequency of eq 23, √((b−a)/a)·V0/D_c, 1/s: exact on K = K_c. Needs b > a.
#[doc(alias = "eq. 23")]
#[must_use]
pub fn transition_angular_frequency_per_s<R: Real>(parameters: &Parameters<R>) -> R {
    let excess = parameters.evolution_effect.clone() - &parameters.direct_effect;
    (excess / &parameters.direct_effect).sqrt() * parameters.rate_per_s()
}

/// ω² of the quasi-static pair (M = 0, eq 14), in units of V0/D_c: κ − (κ+1−β)²/4, negative when it does not oscillate.
#[must_use]
pub fn quasi_static_frequency_squared<R: Field>(stiffness_group: &R, effect_ratio: &R) -> R {
    let damping = stiffness_group.clone() + R::from(1) - effect_ratio;
    stiffness_group.clone() - damping.square() / R::from(4)
}

/// All V0 in m/s at which |Im(s)| is √T·ω_n at the parameters' σ, ascending, each to this many digits.
///
/// z = −4ω² is the only negative root of Π(z − (pᵢ−pⱼ)²) = z(z−S)² − Δ/c3⁴ with S = (c2² − 3c1c3)/c3², so with ω² = Tκ/η
/// the equation is 4Tκ(c2² − 3c1c3 + 4Tκη)² + ηΔ = 0, a quartic in η ∝ V0²; its positive roots are isolated over ℚ.
#[must_use]
pub fn velocities_at_ratio(
    parameters: &Parameters<Rational>,
    ratio_squared: &Rational,
    digits: u32,
) -> Vec<Ball> {
    let bits = bits_for_digits(digits) + 16;
    let at = |inertial_parameter: i32| Groups {
        inertial_parameter: Rational::from(inertial_parameter),
        ..parameters.groups()
    };
    let values = (0..=4).map(|eta| ratio_equation(&at(eta), ratio_squared)).collect();
    let equation = UnivariatePolynomial::interpolating(values);
    // V0² = η·σ a D_c/M.
    let scale = parameters.normal_stress_pa.clone()
        * &parameters.direct_effect
        * &parameters.critical_slip_distance_m
        / &parameters.mass_per_area_kg_per_m2;
    let scale = Ball::from_rational(&scale, bits);
    let roots = equation.isolate_positive_roots();
    roots.iter().map(|root| (equation.refine(root, bits) * &scale).sqrt()).collect()
}

/// 4Tκ(c2² − 3c1c3 + 4Tκη)² + ηΔ.
fn ratio_equation<R: Field>(groups: &Groups<R>, ratio_squared: &R) -> R {
    let cubic = groups.characteristic_cubic();
    let [_, c1, c2, c3] = &cubic;
    let four_t_kappa = R::from(4) * ratio_squared * &groups.stiffness_group;
    let spread = c2.square() - R::from(3) * c1 * c3 + four_t_kappa.clone() * c3;
    four_t_kappa * spread.square() + discriminant(&cubic) * c3
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::parse_decimal;
    use crate::stability::fixtures::{paper, positive_rational, with_effects};
    use crate::stability::transition::{critical_velocity_m_per_s, transition_normal_stress_pa};

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    fn at(velocity: &str, stress: &str) -> Parameters<Rational> {
        Parameters { loading_velocity_m_per_s: number(velocity), normal_stress_pa: number(stress), ..paper() }
    }

    #[test]
    fn on_the_transition_the_frequency_is_eq_23_and_its_ratio_is_the_velocity_over_v_c() {
        let mut p = at("3e-4", "1");
        p.normal_stress_pa = transition_normal_stress_pa(&p);
        let found = oscillation(&p, 40).unwrap();
        let balls = p.map(|value| Ball::from_rational(value, 200));
        assert!(found.angular_frequency_per_s.overlaps(&transition_angular_frequency_per_s(&balls)));
        let ratio = balls.loading_velocity_m_per_s.clone() / critical_velocity_m_per_s(&balls);
        assert!(found.ratio_to_natural.overlaps(&ratio));
        let squared = transition_ratio_squared(&p.groups().inertial_parameter);
        assert!(found.ratio_to_natural.square().contains(&squared));
        assert_eq!(transition_inertial_parameter(&squared), p.groups().inertial_parameter);
        assert!(found.growth_rate_per_s.contains_zero());
    }

    #[test]
    fn as_many_digits_are_certain_as_were_requested() {
        for digits in [10, 40, 200] {
            let found = oscillation(&at("3e-4", "3e4"), digits).unwrap();
            let certain = -found.angular_frequency_per_s.relative_radius_log2() / libm::log2(10.0);
            assert!(certain >= f64::from(digits), "{certain} of {digits}");
        }
    }

    #[test]
    fn slow_sliding_oscillates_as_eq_14_without_mass() {
        let slow = at("1e-9", "4e4");
        let groups = slow.groups();
        let squared = quasi_static_frequency_squared(&groups.stiffness_group, &groups.effect_ratio);
        let rate = slow.rate_per_s().to_f64();
        let found = oscillation(&slow, 20).unwrap().angular_frequency_per_s.to_f64();
        // What is left out is of the order of η = M V0²/(aσD_c), 10⁻¹² here.
        assert!((found / (squared.to_f64().sqrt() * rate) - 1.0).abs() < 1e-9, "{found}");
    }

    #[test]
    fn the_velocity_at_a_ratio_has_that_ratio() {
        for (stress, ratio_squared) in [("5e4", "0.5"), ("1e3", "0.5"), ("1e6", "0.25"), ("1e5", "0.99")] {
            let p = at("1", stress);
            let found = velocities_at_ratio(&p, &number(ratio_squared), 40);
            assert!(!found.is_empty(), "{stress}");
            for velocity in found {
                let there = Parameters {
                    loading_velocity_m_per_s: velocity.centre().to_rational().unwrap(),
                    ..p.clone()
                };
                let ratio = oscillation(&there, 40).unwrap().ratio_to_natural.square();
                // The velocity's centre is within 1e-40 of the true one; d ln(ratio)/d ln V0 is at most a few units here.
                let error = (ratio - Ball::from_rational(&number(ratio_squared), 200)).to_f64().abs();
                assert!(error < 1e-38, "{stress} {error}");
            }
        }
    }

    #[test]
    fn below_the_natural_frequency_mass_does_not_matter_and_stiffness_does() {
        let slow = oscillation(&at("1e-7", "5e4"), 20).unwrap();
        assert!(slow.mass_sensitivity.to_f64().abs() < 1e-6);
        assert!((slow.velocity_sensitivity.to_f64() - 1.0).abs() < 1e-6);
        // At σ_c the quasi-static ω² is κ − (κ+1−β)²/4 with κ = β − 1, so ∂ ln ω/∂ ln K is 1/2.
        assert!((slow.stiffness_sensitivity.to_f64() - 0.5).abs() < 1e-6);
        let fast = oscillation(&at("1", "10"), 20).unwrap();
        assert!((fast.mass_sensitivity.to_f64() + 0.5).abs() < 1e-3);
    }

    proptest! {
        #[test]
        fn the_frequency_stays_below_the_natural_one(
            velocity in positive_rational(), stress in positive_rational(), b in positive_rational(),
        ) {
            let mut p = with_effects(number("0.004"), b);
            p.loading_velocity_m_per_s = velocity;
            p.normal_stress_pa = stress;
            if let Some(found) = oscillation(&p, 20) {
                prop_assert!(found.ratio_to_natural.upper() < 1);
            }
        }

        #[test]
        fn the_sensitivities_match_a_difference_quotient(exponent in -60_i32..0) {
            let velocity = number(&format!("1e{}", exponent / 10 - 1));
            let base = Parameters { loading_velocity_m_per_s: velocity, ..at("1", "3e4") };
            let step = number("1e-15");
            let factor = Rational::from(&step + 1_u32);
            let moved = |change: &dyn Fn(&mut Parameters<Rational>)| {
                let mut p = base.clone();
                change(&mut p);
                oscillation(&p, 60).map(|found| found.angular_frequency_per_s)
            };
            let (Some(here), Some(mass), Some(stiffness)) = (
                oscillation(&base, 60),
                moved(&|p| p.mass_per_area_kg_per_m2 *= &factor),
                moved(&|p| p.stiffness_pa_per_m *= &factor),
            ) else { return Ok(()) };
            let omega = &here.angular_frequency_per_s;
            let quotient = |other: Ball| ((other - omega) / omega / Ball::from_rational(&step, 200)).to_f64();
            // The quotient is off by the step times the second derivative, which is below 10³ away from the boundary.
            prop_assert!((quotient(mass) - here.mass_sensitivity.to_f64()).abs() < 1e-12);
            prop_assert!((quotient(stiffness) - here.stiffness_sensitivity.to_f64()).abs() < 1e-12);
        }
    }
}
