//! The quantities whose signs decide the slip mode of a point, over any field, and the mode that each combination of signs gives.
//!
//! A page that cannot run this program evaluates them as polynomials; see [`slip_mode`](super::slip_mode()) for the same in one call.

use super::slip_mode::{is_upper_area_by, slip_mode_by};
use super::{SlipMode, SpectralClass};
use crate::friction::Groups;
use crate::number::Field;
use crate::roots::discriminant;

/// How many quantities decide.
pub const DECIDING: usize = 7;

/// κ − κ_c; the discriminant of eq 8; β − 1, η − 1/2 and κ + η − 1 − β of the upper area; how far a pair oscillates above the threshold,
/// and what is zero where that is zero although it does. `squared_ratio` is (ω/ω_n)² of the [threshold](super::InertialThreshold).
///
/// ```
/// use slipmode_core::{friction::{Groups, SlipMode}, number::Rational, stability};
///
/// let [inertial_parameter, stiffness_group, effect_ratio] = [1, 2, 3].map(Rational::from);
/// let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
/// let threshold = stability::InertialThreshold::default();
/// let values = stability::deciding_quantities(&groups, threshold.squared_ratio());
/// let signs = values.map(|value| value.cmp0() as i8);
/// assert_eq!(stability::slip_mode_of_signs(signs), SlipMode::StickSlip);
/// ```
#[must_use]
pub fn deciding_quantities<R: Field>(groups: &Groups<R>, squared_ratio: &R) -> [R; DECIDING] {
    let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } = groups;
    let whole = |value: i32| R::from(value);
    let cubic = groups.characteristic_cubic();
    let [c0, c1, c2, c3] = &cubic;
    // Of y³ + Py + Q with y = 3c₃p + c₂, and w = T·κ/η in these units: see `InertialThreshold::exceeded_by`.
    let outer = c3.clone() * c1;
    let linear = whole(3) * (whole(3) * &outer - c2.square());
    let constant = whole(2) * c2.square() * c2 - whole(9) * &outer * c2 + whole(27) * c3.square() * c0;
    let limit = whole(9) * squared_ratio * c0 * c3;
    let difference = whole(3) * &linear - whole(4) * &limit;
    let exceeded = whole(4) * linear.square() * &linear + whole(27) * constant.square()
        - whole(4) * &limit * difference.square();
    let double = constant.square() + (linear - whole(4) * limit).square();
    [
        groups.transition_margin(),
        discriminant(&cubic),
        beta.clone() - &whole(1),
        whole(2) * eta - &whole(1),
        kappa.clone() + eta - &whole(1) - beta,
        exceeded,
        double,
    ]
}

/// The slip mode where the deciding quantities have these signs, each −1, 0 or 1.
#[must_use]
pub fn slip_mode_of_signs(
    [transition, boundary, effect, inertia, sum, exceeded, double]: [i8; DECIDING],
) -> SlipMode {
    let upper_area = || Some(is_upper_area_by([effect, inertia, sum]));
    let inertial = || Some(exceeded > 0 || exceeded == 0 && double == 0);
    // Both answers are always given, so that no mode is left open.
    slip_mode_by(SpectralClass::from_signs(transition, boundary), upper_area, inertial)
        .unwrap_or(SlipMode::StickSlip)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use crate::stability::fixtures;
    use crate::stability::{InertialThreshold, boundary_sign, slip_mode, transition_sign};
    use proptest::prelude::*;

    fn agree(groups: &Groups<Rational>, threshold: &InertialThreshold) -> Result<(), TestCaseError> {
        let signs = deciding_quantities(groups, threshold.squared_ratio()).map(|value| value.cmp0() as i8);
        let [transition, boundary] = [transition_sign(groups), boundary_sign(groups)];
        prop_assert_eq!([signs[0], signs[1]], [transition, boundary]);
        let class = SpectralClass::from_signs(transition, boundary);
        prop_assert_eq!(slip_mode_of_signs(signs), slip_mode(groups, class, threshold));
        Ok(())
    }

    proptest! {
        #[test]
        fn the_signs_decide_as_the_program_does(
            eta in 1u32..4000, kappa in 1u32..8000, beta in 1u32..4000, ratio in 1u32..1000,
        ) {
            let [inertial_parameter, stiffness_group, effect_ratio] =
                [eta, kappa, beta].map(|value| Rational::from((value, 1000)));
            let threshold = InertialThreshold::from_squared_ratio(Rational::from((ratio, 1000))).unwrap();
            agree(&Groups { inertial_parameter, stiffness_group, effect_ratio }, &threshold)?;
        }

        #[test]
        fn and_on_the_limits((r, beta) in fixtures::double_root_and_effect_ratio(), eta in 1u32..4000) {
            let on_boundary = Groups {
                inertial_parameter: fixtures::inertial_parameter(&r, &beta),
                stiffness_group: fixtures::stiffness_group(&r, &beta),
                effect_ratio: beta.clone(),
            };
            agree(&on_boundary, &InertialThreshold::default())?;
            let mut on_transition = Groups {
                inertial_parameter: Rational::from((eta, 1000)),
                stiffness_group: Rational::from(1),
                effect_ratio: Rational::from(&beta + 1u32),
            };
            on_transition.stiffness_group = on_transition.critical_stiffness_group();
            agree(&on_transition, &InertialThreshold::default())?;
        }
    }
}
