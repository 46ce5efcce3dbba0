//! The cusp of the boundary: the one point of the lower arc where all three roots of eq 8 coincide.

use rug::Rational;

use crate::friction::Groups;
use crate::number::{Ball, Field};
use crate::polynomial::UnivariatePolynomial;

/// κ of the cusp at η: κ = (1+η)³/(27η²).
#[must_use]
pub fn stiffness_group<R: Field>(inertial_parameter: &R) -> R {
    let base = R::from(1) + inertial_parameter;
    base.square() * &base / (R::from(27) * inertial_parameter.square())
}

/// The triple root at η: r = −(1+η)/(3η).
#[must_use]
pub fn triple_root<R: Field>(inertial_parameter: &R) -> R {
    -((R::from(1) + inertial_parameter) / (R::from(3) * inertial_parameter))
}

/// The cusp of a given β, enclosed: the groups and the triple root.
///
/// η is the only positive root of (1−2η)³ = 27βη²: the left side falls, the right side rises. The relative radius of
/// each number is at most 2^−bits.
#[must_use]
pub fn cusp(effect_ratio: &Rational, bits: u32) -> (Groups<Ball>, Ball) {
    let bits = bits.saturating_add(8);
    let difference = UnivariatePolynomial::new(vec![
        Rational::from(1),
        Rational::from(-6),
        Rational::from(12) - Rational::from(27) * effect_ratio,
        Rational::from(-8),
    ]);
    let roots = difference.isolate_positive_roots();
    let inertial_parameter =
        roots.first().map_or_else(|| Ball::unbounded(bits), |root| difference.refine(root, bits));
    let groups = Groups {
        stiffness_group: stiffness_group(&inertial_parameter),
        effect_ratio: Ball::from_rational(effect_ratio, bits),
        inertial_parameter: inertial_parameter.clone(),
    };
    let root = triple_root(&inertial_parameter);
    (groups, root)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// β of the cusp at η: β = (1−2η)³/(27η²), 0 < η < 1/2.
    fn effect_ratio(inertial_parameter: &Rational) -> Rational {
        let base = Rational::from(1) - Rational::from(2) * inertial_parameter;
        base.clone().square() * &base / (Rational::from(27) * inertial_parameter.clone().square())
    }

    #[test]
    fn at_equal_effects_the_cusp_is_rational() {
        let eta = Rational::from((1, 8));
        assert_eq!(effect_ratio(&eta), 1);
        assert_eq!(stiffness_group(&eta), Rational::from((27, 8)));
        assert_eq!(triple_root(&eta), -3);
        let (groups, root) = cusp(&Rational::from(1), 200);
        assert!(groups.inertial_parameter.contains(&eta) && root.contains(&Rational::from(-3)));
    }

    proptest! {
        #[test]
        fn at_the_cusp_the_cubic_is_a_cube(numerator in 1_i64..5_000) {
            let eta = Rational::from((numerator, 10_001));
            let groups = Groups {
                inertial_parameter: eta.clone(),
                stiffness_group: stiffness_group(&eta),
                effect_ratio: effect_ratio(&eta),
            };
            let r = triple_root(&eta);
            let [c0, c1, c2, c3] = groups.characteristic_cubic();
            prop_assert_eq!(c2, Rational::from(-3) * &r * &c3);
            prop_assert_eq!(c1, Rational::from(3) * r.clone().square() * &c3);
            prop_assert_eq!(c0, -(r.clone().square() * &r) * &c3);
            let (found, _) = cusp(&groups.effect_ratio, 300);
            prop_assert!(found.inertial_parameter.contains(&eta));
            prop_assert!(found.inertial_parameter.relative_radius_log2() < -300.0);
        }
    }
}
