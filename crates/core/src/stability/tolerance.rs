//! Where an asymptote is good to a given relative error, exactly and in closed form to leading order.
//!
//! Every error grows monotonically from its asymptotic end to the end of its branch (`deviation`), so one number per
//! asymptote and tolerance says it all: η for eqs 15 and 16, κ for eqs 18 and 20.

mod over_box;

pub use over_box::{LimitOverBox, limit_over_box};

use rug::Rational;

use crate::friction::{Groups, Slider};
use crate::number::{Ball, Real, bits_for_digits};
use crate::stability::parameter_equation::{ParameterEquation, cusp_parameter};
use crate::stability::{Arc, ArcFrame, Asymptote};

/// Bits beyond the digits requested.
const GUARD_BITS: u32 = 24;

/// How far an asymptote can be used.
#[derive(Debug, Clone)]
pub struct Limit {
    /// The asymptote.
    pub asymptote: Asymptote,
    /// Whether the whole branch, up to the cusp, is within the tolerance (eqs 16 and 20 only); the groups are then the cusp's.
    pub whole_branch: bool,
    /// η and κ of the boundary where the error reaches the tolerance, and β.
    pub groups: Groups<Ball>,
    /// (V0/D_c)²·M/K = η/κ there.
    pub velocity_squared: Ball,
    /// The same limit in closed form to leading order: η = ε for eqs 15 and 16, κ = ε(β−1)²/(2β) for eq 18,
    /// κ = β/(2ε) for eq 20.
    pub leading: Rational,
    /// The exact limit over the leading one: of η (eqs 15, 16) or κ (eqs 18, 20).
    pub exact_over_leading: Ball,
}

impl Limit {
    /// V0 up to which eq 15 or 16 is good, or σ from which (eq 18) or up to which (eq 20) the inertial one is, in SI.
    #[must_use]
    pub fn in_si(&self, slider: &Slider<Ball>) -> Ball {
        if self.asymptote.is_quasi_static() {
            let rate = (slider.natural_angular_frequency_squared_per_s2() * &self.velocity_squared).sqrt();
            rate * &slider.critical_slip_distance_m
        } else {
            slider.stress_scale_pa() / &self.groups.stiffness_group
        }
    }
}

/// Bits for so many digits of what these numbers give: |β − 1|, √β and 1 − ε are at least the inverse of their numerators or denominators.
fn working_bits(digits: u32, exact: &[&Rational]) -> u32 {
    let size = |value: &&Rational| value.numer().significant_bits() + value.denom().significant_bits();
    bits_for_digits(digits) + GUARD_BITS + 2 * exact.iter().map(size).sum::<u32>()
}

/// A slider's values with bits for so many digits of its asymptotes and limits.
#[must_use]
pub fn enclosed(slider: &Slider<Rational>, digits: u32) -> Slider<Ball> {
    let bits = working_bits(digits, &[&slider.effect_ratio()]);
    slider.map(|value| Ball::from_rational(value, bits))
}

/// Where the asymptote's relative error reaches `tolerance`; none for eqs 15 and 18 at β = 1 and for an error of eq 18
/// of 100 % or more.
#[must_use]
pub fn limit(
    asymptote: Asymptote,
    effect_ratio: &Rational,
    tolerance: &Rational,
    digits: u32,
) -> Option<Limit> {
    let bits = working_bits(digits, &[effect_ratio, tolerance]);
    let arc = asymptote.arc();
    let roots = ParameterEquation::at_error(effect_ratio, asymptote, tolerance.clone()).roots(bits);
    // Descending: the first lies towards the quasi-static end, the last towards the inertial one.
    let reached = if asymptote.is_quasi_static() { roots.first() } else { roots.last() };
    let cusp = || (arc == Arc::Lower).then(|| cusp_parameter(effect_ratio, bits));
    let parameter = reached.cloned().or_else(cusp)?;
    let place = ArcFrame::of_rational(effect_ratio, bits).point(arc, &parameter);
    let leading = leading_limit(asymptote, effect_ratio, tolerance);
    let [eta, kappa] = [&place.groups.inertial_parameter, &place.groups.stiffness_group];
    let exact = if asymptote.is_quasi_static() { eta } else { kappa };
    Some(Limit {
        asymptote,
        whole_branch: reached.is_none(),
        exact_over_leading: exact.clone() / Ball::from_rational(&leading, bits),
        velocity_squared: place.velocity_squared,
        groups: Groups { effect_ratio: Ball::from_rational(effect_ratio, bits), ..place.groups },
        leading,
    })
}

/// η or κ at which the leading term of the relative error is the tolerance.
#[must_use]
pub fn leading_limit(asymptote: Asymptote, effect_ratio: &Rational, tolerance: &Rational) -> Rational {
    match asymptote {
        Asymptote::QuasiStaticUpper | Asymptote::QuasiStaticLower => tolerance.clone(),
        Asymptote::InertialUpper => {
            let excess = Rational::from(effect_ratio - 1_u32);
            excess.square() * tolerance / Rational::from(effect_ratio * 2_u32)
        }
        Asymptote::InertialLower => effect_ratio.clone() / Rational::from(tolerance * 2_u32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Field, parse_decimal};
    use crate::stability::boundary::by_discriminant;
    use crate::stability::fixtures::with_effects;
    use crate::stability::{Section, asymptote};

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    #[test]
    fn at_the_limit_the_error_is_the_tolerance() {
        let below_one = "0.999999999999999999999999999999999999999999999999999999999999";
        for beta in ["1e-300", "1e-3", "0.5", below_one, "1", "1.5", "1000", "1e300"] {
            for tolerance in [below_one, "0.1", "0.01", "0.001", "1e-300"] {
                for asymptote in Asymptote::ALL {
                    let Some(limit) = limit(asymptote, &number(beta), &number(tolerance), 1000) else {
                        assert!(beta == "1" && asymptote.arc() == Arc::Upper, "{beta} {tolerance}");
                        continue;
                    };
                    let groups = &limit.groups;
                    let coarse =
                        super::limit(asymptote, &number(beta), &number(tolerance), 20).unwrap().groups;
                    for (fine, coarse) in [
                        (&groups.inertial_parameter, coarse.inertial_parameter),
                        (&groups.stiffness_group, coarse.stiffness_group),
                    ] {
                        let off = coarse / fine - Ball::from(1);
                        assert!(off.upper() < number("1e-18"), "{beta} {tolerance} {asymptote:?}");
                    }
                    let frame = ArcFrame::of_rational(&number(beta), 4000);
                    let end = match asymptote.arc() {
                        Arc::Upper => frame.difference.square(),
                        Arc::Lower => frame.sum.square(),
                    };
                    // Straight from eqs 15, 16, 18, 20 in groups: κ, and 4ηκ against (β−1)² or 1.
                    let factor = if asymptote.arc() == Arc::Upper {
                        (groups.effect_ratio.clone() - Ball::from(1)).square()
                    } else {
                        Ball::from(1)
                    };
                    let error = if asymptote.is_quasi_static() {
                        end / &groups.stiffness_group - Ball::from(1)
                    } else {
                        let product = Ball::from(4) * &groups.inertial_parameter * &groups.stiffness_group;
                        (product / factor).sqrt() - Ball::from(1)
                    };
                    let magnitude = if asymptote == Asymptote::InertialUpper { -error } else { error };
                    let tolerance = number(tolerance);
                    if limit.whole_branch {
                        assert!(magnitude.upper() < tolerance);
                    } else {
                        assert!(magnitude.contains(&tolerance), "{beta} {asymptote:?}");
                        assert!(magnitude.relative_radius_log2() < -60.0);
                    }
                }
            }
        }
    }

    #[test]
    fn the_limit_in_si_is_where_the_discriminant_says_the_error_is_reached() {
        let slider = with_effects(number("0.004"), number("0.006"));
        let balls = slider.map(|value| Ball::from_rational(value, 200));
        let limit = limit(Asymptote::QuasiStaticUpper, &number("1.5"), &number("0.01"), 30).unwrap();
        let velocity = limit.in_si(&balls).centre().to_rational().unwrap();
        let highest = by_discriminant(&slider, &Section::AtVelocity(velocity), 30).unwrap().pop().unwrap();
        let ratio = highest.value / asymptote::quasi_static_upper_normal_stress_pa(&balls);
        assert!((ratio.to_f64() - 1.01).abs() < 1e-15);
        assert_eq!(highest.kind, Arc::Upper.into());
    }

    #[test]
    fn the_leading_limit_is_approached_in_proportion_to_the_tolerance() {
        for beta in ["0.1", "1.5", "20"] {
            for asymptote in Asymptote::ALL {
                let off = |tolerance: &str| {
                    limit(asymptote, &number(beta), &number(tolerance), 30)
                        .map_or(0.0, |limit| limit.exact_over_leading.to_f64() - 1.0)
                };
                let (coarse, fine) = (off("1e-5"), off("1e-6"));
                assert!((coarse / fine - 10.0).abs() < 0.1, "{beta} {asymptote:?} {coarse} {fine}");
            }
        }
    }
}
