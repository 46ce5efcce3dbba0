//! How far the asymptotes are from the boundary: leading orders, measured orders, and the worst cases.
//!
//! With the signs of `arc_point` and κ − ηr² ≥ 0 everywhere on the boundary, each error is monotone along its own
//! branch: those of eqs 15 and 18 along the whole upper arc, that of eq 16 from the quasi-static end to the cusp,
//! that of eq 20 from the inertial end to the cusp. The largest distance to the nearer of two asymptotes is therefore
//! where the two distances are equal, which is at the V0 of their corner, or at the cusp.

use rug::Rational;

use crate::friction::Groups;
use crate::number::{Ball, Field, Real, bits_for_digits};
use crate::stability::boundary::ErrorPair;
use crate::stability::logarithm::log10_one_plus;
use crate::stability::parameter_equation::{ParameterEquation, cusp_parameter};
use crate::stability::{Arc, ArcFrame, Asymptote};

/// Bits beyond the digits requested.
const GUARD_BITS: u32 = 24;

/// The leading term of exact/asymptote − 1 at a point of the boundary: η, η, −2βκ/(β−1)², β/(2κ).
///
/// The first two are of σ at the same V0, the last two of V0 at the same σ. Eq 18 needs β ≠ 1 in rationals.
pub(crate) fn leading_relative_error<R: Field>(asymptote: Asymptote, groups: &Groups<R>) -> R {
    let (beta, kappa) = (&groups.effect_ratio, &groups.stiffness_group);
    match asymptote {
        Asymptote::QuasiStaticUpper | Asymptote::QuasiStaticLower => groups.inertial_parameter.clone(),
        Asymptote::InertialUpper => R::from(-2) * beta * kappa / (beta.clone() - R::from(1)).square(),
        Asymptote::InertialLower => beta.clone() / (R::from(2) * kappa),
    }
}

/// One step of a measured convergence.
#[derive(Debug, Clone)]
pub struct ConvergenceStep {
    /// The derived leading term of the relative error, as a magnitude.
    pub leading: Ball,
    /// The relative error itself.
    pub relative_error: Ball,
    /// error/leading: tends to 1 when the leading term is right.
    pub ratio: Ball,
    /// ln(error/previous error)/ln(leading/previous leading): tends to 1, the derived order; none for the first step.
    pub order: Option<Ball>,
}

/// Follows one asymptote to its end in `steps` decades of λ and compares its error with the derived leading term.
///
/// Empty for eqs 15 and 18 at β = 1, where the upper arc does not exist.
#[must_use]
pub fn convergence(
    asymptote: Asymptote,
    effect_ratio: &Rational,
    steps: u32,
    digits: u32,
) -> Vec<ConvergenceStep> {
    let mut collected: Vec<ConvergenceStep> = Vec::new();
    if asymptote.arc() == Arc::Upper && *effect_ratio == 1 {
        return collected;
    }
    let bits = bits_for_digits(digits) + GUARD_BITS;
    let frame = ArcFrame::of_rational(effect_ratio, bits);
    for decade in 0..steps {
        let step = step_at(asymptote, &frame, decade, bits);
        let order = collected.last().map(|previous| {
            logarithm_of_ratio(&step.relative_error, &previous.relative_error)
                / logarithm_of_ratio(&step.leading, &previous.leading)
        });
        collected.push(ConvergenceStep { order, ..step });
    }
    collected
}

fn step_at(asymptote: Asymptote, frame: &ArcFrame<Ball>, decade: u32, bits: u32) -> ConvergenceStep {
    let power =
        Ball::from_rational(&Rational::from(rug::Integer::from(rug::Integer::u_pow_u(10, decade))), bits);
    // λ√β ≫ 1 is the quasi-static end, λβ ≪ 1 + √β the inertial one.
    let parameter = if asymptote.is_quasi_static() {
        power / &frame.root_ratio
    } else {
        frame.sum.clone() / (frame.root_ratio.square() * power)
    };
    let place = frame.point(asymptote.arc(), &parameter);
    let errors = ErrorPair::at(frame, asymptote.arc(), &parameter);
    let relative_error = if asymptote.is_quasi_static() { errors.quasi_static } else { errors.inertial };
    let leading = leading_relative_error(asymptote, &place.groups);
    let ratio = relative_error.clone() / &leading;
    ConvergenceStep { leading, relative_error, ratio, order: None }
}

/// log10(x/y), for numbers of one sign.
fn logarithm_of_ratio(x: &Ball, y: &Ball) -> Ball {
    log10_one_plus(&((x.clone() - y) / y))
}

/// The errors at the places that bound them, as functions of β alone.
#[derive(Debug, Clone)]
pub struct CornerErrors {
    /// Upper arc at the V0 of the corner 15∩18, where both asymptotes are equally far in log10; none for a = b.
    pub upper: Option<ErrorPair>,
    /// At the cusp, the largest error of eq 16 before it and of eq 20 after it.
    pub cusp: ErrorPair,
    /// Lower arc at the V0 of the corner 16∩20, on the branch of eq 16 (between the quasi-static end and the cusp).
    pub lower_quasi_static: Option<ErrorPair>,
    /// Lower arc at the V0 of the corner 16∩20, on the branch of eq 20 (between the cusp and the inertial end).
    pub lower_inertial: Option<ErrorPair>,
    /// Relative error of eq 20 in V0 at the σ of the corner 16∩20.
    pub lower_at_corner_normal_stress: Ball,
    /// The largest distance in log10 between the upper arc and the nearer of eqs 15 and 18; none for a = b.
    pub upper_worst_log10: Option<Ball>,
    /// The largest distance in log10 between the lower arc and the nearer of eqs 16 and 20.
    pub lower_worst_log10: Ball,
}

/// The worst cases at β, every number to this many digits.
#[must_use]
pub fn corner_errors(effect_ratio: &Rational, digits: u32) -> CornerErrors {
    let bits = bits_for_digits(digits) + GUARD_BITS;
    let frame = ArcFrame::of_rational(effect_ratio, bits);
    let at = |arc: Arc, parameter: &Ball| ErrorPair::at(&frame, arc, parameter);
    let at_corner_velocity = |arc: Arc| -> Vec<ErrorPair> {
        let parameters = ParameterEquation::at_corner_velocity(effect_ratio, arc).roots(bits);
        parameters.iter().map(|parameter| at(arc, parameter)).collect()
    };
    let upper = at_corner_velocity(Arc::Upper).pop();
    let mut lower = at_corner_velocity(Arc::Lower).into_iter();
    let (lower_quasi_static, lower_inertial) = (lower.next(), lower.next());
    let cusp = at(Arc::Lower, &cusp_parameter(effect_ratio, bits));
    let lower_worst_log10 = [Some(&cusp), lower_quasi_static.as_ref(), lower_inertial.as_ref()]
        .into_iter()
        .flatten()
        .map(ErrorPair::nearer_log10)
        .fold(Ball::from(0), larger);
    CornerErrors {
        upper_worst_log10: upper.as_ref().map(ErrorPair::nearer_log10),
        lower_at_corner_normal_stress: at(Arc::Lower, &corner_normal_stress_parameter(&frame)).inertial,
        upper,
        cusp,
        lower_quasi_static,
        lower_inertial,
        lower_worst_log10,
    }
}

/// λ where the lower arc has the σ of eq 16: the positive root of 2qλ² + (1+q)λ − (1+q).
pub(super) fn corner_normal_stress_parameter(frame: &ArcFrame<Ball>) -> Ball {
    let discriminant = frame.sum.square() + Ball::from(8) * &frame.root_ratio * &frame.sum;
    Ball::from(2) * &frame.sum / (discriminant.sqrt() + &frame.sum)
}

fn larger(x: Ball, y: Ball) -> Ball {
    if y.centre() > x.centre() { y } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    #[test]
    fn the_measured_order_is_one_and_the_leading_term_is_right() {
        for text in ["1e-3", "0.5", "0.999", "1", "1.5", "1000"] {
            for asymptote in Asymptote::ALL {
                let steps = convergence(asymptote, &number(text), 9, 30);
                let Some(last) = steps.last() else {
                    assert!(text == "1" && asymptote.arc() == Arc::Upper);
                    continue;
                };
                // The next order is relative to the leading one smaller by a factor of the order of λ^±1·(1 + 1/√β)²:
                // at eight decades below 10⁻³ for every β here.
                assert!((last.ratio.to_f64() - 1.0).abs() < 1e-3, "{text} {asymptote:?} {:?}", last.ratio);
                let order = last.order.as_ref().map_or(0.0, Ball::to_f64);
                assert!((order - 1.0).abs() < 1e-3, "{text} {asymptote:?} {order}");
            }
        }
    }

    #[test]
    fn at_the_corner_velocity_both_asymptotes_are_equally_far() {
        for text in ["1e-3", "0.9", "1.5", "1000"] {
            let errors = corner_errors(&number(text), 40);
            let pairs = [errors.upper, errors.lower_quasi_static, errors.lower_inertial];
            for pair in pairs.into_iter().flatten() {
                let (one, other) = (log10_one_plus(&pair.quasi_static), log10_one_plus(&pair.inertial));
                assert!((one + other).contains_zero());
            }
        }
    }

    #[test]
    fn no_sample_of_an_arc_is_farther_from_its_asymptotes_than_the_worst_case() {
        for text in ["1e-3", "0.03", "0.5", "0.9999", "1", "1.5", "10", "1000"] {
            let beta = number(text);
            let errors = corner_errors(&beta, 20);
            let frame = ArcFrame::of_rational(&beta, 100);
            for step in -400..=400 {
                let exponent = f64::from(step) / 20.0;
                let parameter = Ball::from(libm::exp2(exponent)).with_precision(100);
                let farther = |arc: Arc, worst: &Ball| {
                    ErrorPair::at(&frame, arc, &parameter).nearer_log10().lower() > worst.upper()
                };
                assert!(!farther(Arc::Lower, &errors.lower_worst_log10), "{text} {exponent}");
                if let Some(worst) = &errors.upper_worst_log10 {
                    assert!(!farther(Arc::Upper, worst), "{text} {exponent}");
                }
            }
        }
    }

    #[test]
    fn no_sample_of_an_asymptotes_arc_has_a_larger_error_than_at_the_cusp_or_the_corner() {
        for text in ["1e-3", "0.5", "1", "1.5", "10"] {
            let beta = number(text);
            let errors = corner_errors(&beta, 20);
            let frame = ArcFrame::of_rational(&beta, 100);
            let cusp = cusp_parameter(&beta, 100);
            let corner = ParameterEquation::at_corner_velocity(&beta, Arc::Upper).roots(100).pop();
            let size = |error: &Ball| libm::fabs(error.to_f64());
            for step in -400..=400 {
                let parameter = Ball::from(libm::exp2(f64::from(step) / 20.0)).with_precision(100);
                // The quasi-static end of either arc has the large parameters.
                let checked = |arc: Arc, place: &Ball, worst: &ErrorPair| {
                    let found = ErrorPair::at(&frame, arc, &parameter);
                    match parameter.centre() > place.centre() {
                        true => size(&found.quasi_static) <= size(&worst.quasi_static) * (1.0 + 1e-12),
                        false => size(&found.inertial) <= size(&worst.inertial) * (1.0 + 1e-12),
                    }
                };
                assert!(checked(Arc::Lower, &cusp, &errors.cusp), "{text} {step}");
                if let (Some(corner), Some(worst)) = (&corner, &errors.upper) {
                    assert!(checked(Arc::Upper, corner, worst), "{text} {step}");
                }
            }
        }
    }

    #[test]
    fn the_worst_cases_of_the_papers_ratio() {
        let errors = corner_errors(&number("1.5"), 20);
        // From a plain scan of both arcs with mpmath (4 000 steps of λ): 0.2241…0.2245 and 0.0744…0.0750.
        let upper = errors.upper_worst_log10.map_or(0.0, |ball| ball.to_f64());
        assert!((0.2241..0.2246).contains(&upper), "{upper}");
        let lower = errors.lower_worst_log10.to_f64();
        assert!((0.0744..0.0751).contains(&lower), "{lower}");
    }

    #[test]
    fn the_lower_arc_has_the_normal_stress_of_eq_16_where_its_quadratic_is_zero() {
        for text in ["1e-3", "0.9", "1", "1.5", "1000"] {
            let frame = ArcFrame::of_rational(&number(text), 200);
            let (q, lambda) = (&frame.root_ratio, corner_normal_stress_parameter(&frame));
            let quadratic = Ball::from(2) * q * lambda.square() + frame.sum.clone() * &lambda - &frame.sum;
            assert!(quadratic.contains_zero() && lambda.to_f64() > 0.0, "{text} {quadratic:?}");
            // Eq 16 is κ = (1 + √β)² with κ = K D_c/(aσ).
            let kappa = frame.point(Arc::Lower, &lambda).groups.stiffness_group;
            assert!((kappa - frame.sum.square()).contains_zero(), "{text}");
        }
    }
}
