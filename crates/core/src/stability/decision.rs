//! The two exact decisions: stable or not, oscillating or not. Both are signs of rationals, so never wrong.

use crate::friction::Groups;
use crate::number::Rational;
use crate::roots::Depressed;

/// The sign of K − K_c (eq 9): +1 linearly stable, −1 unstable, 0 on the transition.
#[must_use]
pub fn transition_sign(groups: &Groups<Rational>) -> i8 {
    groups.transition_margin().cmp0() as i8
}

/// The sign of the discriminant of eq 8: +1 three distinct real roots, −1 a complex pair, 0 on the boundary.
///
/// η = 0 has no cubic; as one root is then at −∞, the sign is that of the remaining quadratic's discriminant.
#[must_use]
pub fn boundary_sign(groups: &Groups<Rational>) -> i8 {
    let cubic = groups.characteristic_cubic();
    match Depressed::of(&cubic) {
        Some(depressed) => depressed.discriminant_sign(),
        None => {
            let [c0, c1, c2, _] = cubic;
            (c1.square() - c0 * c2 * 4u32).cmp0() as i8
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use crate::roots::discriminant;
    use crate::stability::fixtures::{self, double_root_and_effect_ratio};
    use proptest::prelude::*;

    fn group() -> impl Strategy<Value = Rational> {
        (1i64..1_000_000, -40i32..30).prop_map(|(n, e)| parse_decimal(&format!("{n}e{e}")).unwrap())
    }

    fn any_groups() -> impl Strategy<Value = Groups<Rational>> {
        (group(), group(), group()).prop_map(|(inertial_parameter, stiffness_group, effect_ratio)| Groups {
            inertial_parameter,
            stiffness_group,
            effect_ratio,
        })
    }

    fn on_boundary(r: &Rational, beta: &Rational) -> Groups<Rational> {
        Groups {
            inertial_parameter: fixtures::inertial_parameter(r, beta),
            stiffness_group: fixtures::stiffness_group(r, beta),
            effect_ratio: beta.clone(),
        }
    }

    #[test]
    fn without_inertia_the_limits_are_those_of_eqs_15_and_16() {
        // κ = (√β ± 1)², at β = 4: 1 and 9.
        for (kappa, sign) in [("0.5", 1), ("1", 0), ("4", -1), ("9", 0), ("10", 1)] {
            let groups = Groups {
                inertial_parameter: Rational::new(),
                stiffness_group: parse_decimal(kappa).unwrap(),
                effect_ratio: Rational::from(4),
            };
            assert_eq!(boundary_sign(&groups), sign, "κ = {kappa}");
        }
    }

    proptest! {
        #[test]
        fn the_integer_route_agrees_with_the_discriminant_over_the_rationals(groups in any_groups()) {
            let sign = discriminant(&groups.characteristic_cubic()).cmp0() as i8;
            prop_assert_eq!(boundary_sign(&groups), sign);
        }

        #[test]
        fn points_on_the_boundary_and_1e_60_beside_it_are_told_apart(
            (r, beta) in double_root_and_effect_ratio(),
        ) {
            let mut groups = on_boundary(&r, &beta);
            prop_assert!(groups.inertial_parameter > 0 && groups.stiffness_group > 0);
            prop_assert_eq!(boundary_sign(&groups), 0);
            prop_assume!(fixtures::third_root(&r, &beta) != r);
            // Off the cusp, κ splits the double root into two reals on one side and a pair on the other: ∂F/∂κ = r + 1 ≠ 0.
            let shift = parse_decimal("1e-60").unwrap() * &groups.stiffness_group;
            groups.stiffness_group -= &shift;
            let below = boundary_sign(&groups);
            groups.stiffness_group += shift * 2u32;
            prop_assert_eq!(boundary_sign(&groups), -below);
            prop_assert_ne!(below, 0);
        }

        #[test]
        fn points_on_the_transition_and_beside_it_are_told_apart(
            eta in group(), excess in group(),
        ) {
            let beta = excess.clone() + 1u32;
            let kappa = excess * (eta.clone() + 1u32);
            let mut groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
            prop_assert_eq!(transition_sign(&groups), 0);
            groups.stiffness_group += parse_decimal("1e-60").unwrap();
            prop_assert_eq!(transition_sign(&groups), 1);
            prop_assert_eq!(Depressed::of(&groups.characteristic_cubic()).unwrap().hurwitz().cmp0() as i8, 1);
        }
    }
}
