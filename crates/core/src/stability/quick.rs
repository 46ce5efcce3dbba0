//! The classification of a point whose inputs are double-doubles: for large files, where it nearly always suffices.

use super::certain_signs::BoundedGroups;
use super::slip_mode::slip_mode_by;
use super::spectrum::{LargestParts, OfPair, clearly_inertial};
use super::{Classification, InertialThreshold, SpectralClass};
use crate::friction::{Groups, Parameters};
use crate::number::{Dd, nearest_f64};
use crate::roots::PrecisionLevel;

/// How close to a limit a comparison of groups is left open; they are known to far better.
const MARGIN: f64 = 1e-12;

/// The classification of a point whose inputs are each within a relative [`Dd::UNIT`] of the true ones.
///
/// Every sign, name and value has the guarantees of [`classify`](super::classify); where the error bounds do not
/// allow them, the answer is `None`, and the exact inputs are needed.
#[must_use]
pub fn classify_quickly(
    parameters: &Parameters<Dd>,
    threshold: &InertialThreshold,
) -> Option<Classification> {
    let bounded = BoundedGroups::of_parameters(parameters)?;
    let signs = bounded.signs_below_exact()?;
    let parts = LargestParts::of_bounded(&bounded.cubic().spectrum(), signs.transition)?;
    let in_si = parts.times_rate(parameters.rate_per_s())?;
    let rounded = in_si.rounded()?;
    let spectral_class = SpectralClass::from_signs(signs.transition, signs.boundary);
    let groups = bounded.groups.map(Dd::hi);
    let inertial = || {
        let (natural_squared, limit) =
            (groups.natural_angular_frequency_squared(), nearest_f64(threshold.squared_ratio()));
        clearly_inertial(parts.imaginary.value.hi(), natural_squared, limit)
    };
    let slip_mode = slip_mode_by(spectral_class, || clearly_in_upper_area(&groups), inertial)?;
    Some(Classification {
        transition_sign: signs.transition,
        boundary_sign: signs.boundary,
        spectral_class,
        slip_mode,
        max_real_per_s: rounded.real,
        max_imaginary_per_s: rounded.imaginary,
        precision_level: signs.precision_level,
        value_precision_level: PrecisionLevel::DoubleDouble,
        angular_frequency: OfPair(Some(in_si.imaginary)),
    })
}

/// Whether a point with real roots lies in the upper area of a > b, when that is clear (see `slip_mode::is_upper_area`).
pub(super) fn clearly_in_upper_area(groups: &Groups<f64>) -> Option<bool> {
    let (eta, kappa, beta) = (groups.inertial_parameter, groups.stiffness_group, groups.effect_ratio);
    let below =
        |left: f64, right: f64| ((left - right).abs() > MARGIN * (left + right)).then_some(left < right);
    Some(below(beta, 1.0)? && !(below(eta, 0.5)? && below(1.0 + beta, kappa + eta)?))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::{Rational, parse_decimal};
    use crate::stability::classify;

    fn slider(exponents: [f64; 7]) -> Parameters<Rational> {
        let decimal = |exponent| parse_decimal(&format!("{:.5e}", libm::exp10(exponent))).unwrap();
        Parameters::from(exponents.map(decimal))
    }

    proptest! {
        #[test]
        fn a_quick_answer_is_the_exact_one(exponents in [
            -4f64..-1.0, -4f64..-1.0, -7f64..-2.0, 4f64..12.0, -2f64..7.0, 2f64..9.0, -9f64..1.0,
        ]) {
            let parameters = slider(exponents);
            let threshold = InertialThreshold::default();
            let exact = classify(&parameters, &threshold);
            let quick = classify_quickly(&parameters.map(Dd::from_rational), &threshold);
            let quick = quick.expect("a random point is nowhere near a limit");
            let names = |found: &Classification| {
                (found.transition_sign, found.boundary_sign, found.spectral_class, found.slip_mode)
            };
            prop_assert_eq!(names(&quick), names(&exact));
            let value = |found: &Classification| {
                [found.max_real_per_s, found.max_imaginary_per_s].map(|part| part.to_f64().unwrap())
            };
            let ([re, im], [exact_re, exact_im]) = (value(&quick), value(&exact));
            prop_assert!((im - exact_im).abs() <= 2e-14 * exact_im);
            prop_assert!((re - exact_re).abs() <= 2e-14 * exact_re.abs());
        }
    }

    #[test]
    fn a_point_on_a_limit_is_left_to_the_exact_inputs() {
        let threshold = InertialThreshold::default();
        let on_transition = slider([-2.0; 7]).map(Dd::from_rational);
        let mut equal_effects = on_transition;
        equal_effects.slider.evolution_effect = equal_effects.slider.direct_effect;
        let cusp = Parameters::from([1.0, 1.0, 1.0, 3.375, 0.125, 1.0, 1.0].map(Dd::from));
        assert!(classify_quickly(&cusp, &threshold).is_none());
        assert!(classify_quickly(&equal_effects, &threshold).is_some(), "a = b is no limit of the signs");
    }

    #[test]
    fn which_real_area_it_is_stays_open_on_its_limits_alone() {
        let area = |inertial_parameter, stiffness_group, effect_ratio| {
            clearly_in_upper_area(&Groups { inertial_parameter, stiffness_group, effect_ratio })
        };
        assert_eq!(area(0.4, 1.0, 0.5), Some(true));
        assert_eq!(area(0.4, 2.0, 0.5), Some(false));
        assert_eq!(area(0.6, 2.0, 0.5), Some(true));
        assert_eq!(area(0.4, 1.0, 2.0), Some(false));
        for (eta, kappa, beta) in [(0.5, 1.0, 0.5), (0.25, 1.25, 0.5), (0.4, 1.0, 1.0)] {
            assert_eq!(area(eta, kappa, beta), None, "{eta} {kappa} {beta}");
        }
    }
}
