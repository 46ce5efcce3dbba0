//! The positive forms against the curve and its differential, exactly.

use proptest::prelude::*;

use super::*;
use crate::stability::fixtures::{self, positive_rational};

proptest! {
    #[test]
    fn the_positive_forms_are_the_curve_and_its_errors_exactly(
        q in positive_rational(), parameter in positive_rational(), upper in any::<bool>(),
    ) {
        let arc = if upper { Arc::Upper } else { Arc::Lower };
        let beta = q.clone().square();
        prop_assume!(beta != 1);
        let frame = ArcFrame::new(Rational::from(&beta - 1_u32), q.clone());
        let point = frame.point(arc, &parameter);
        let r = &point.double_root;
        prop_assert_eq!(&point.groups.inertial_parameter, &fixtures::inertial_parameter(r, &beta));
        prop_assert_eq!(&point.groups.stiffness_group, &fixtures::stiffness_group(r, &beta));
        let ratio = Rational::from(&point.groups.inertial_parameter / &point.groups.stiffness_group);
        prop_assert_eq!(&point.velocity_squared, &ratio);
        let inverse = Rational::from(point.groups.stiffness_group.recip_ref());
        prop_assert_eq!(frame.place(arc, &parameter), (inverse, ratio.clone()));
        prop_assert!(point.groups.inertial_parameter > 0 && point.groups.stiffness_group > 0);

        let (end, factor) = match arc {
            Arc::Upper => (q.clone() - 1_u32, Rational::from(&beta - 1_u32)),
            Arc::Lower => (q.clone() + 1_u32, Rational::from(1)),
        };
        let quasi_static = end.square() / &point.groups.stiffness_group - 1_u32;
        prop_assert_eq!(frame.quasi_static_error(arc, &parameter), quasi_static);
        let product = Rational::from(&point.groups.inertial_parameter * &point.groups.stiffness_group);
        let inertial = product * 4_u32 / factor.square() - 1_u32;
        prop_assert_eq!(frame.inertial_error_of_square(arc, &parameter), inertial);
    }

    #[test]
    fn the_sensitivities_follow_from_the_differential_of_the_cubic_at_its_double_root(
        q in positive_rational(), parameter in positive_rational(), upper in any::<bool>(),
    ) {
        let arc = if upper { Arc::Upper } else { Arc::Lower };
        let beta = q.clone().square();
        prop_assume!(beta != 1);
        let frame = ArcFrame::new(Rational::from(&beta - 1_u32), q);
        let ArcPoint { double_root: r, groups: Groups { inertial_parameter: eta, stiffness_group: kappa, .. }, .. } =
            frame.point(arc, &parameter);
        let [direct_effect, evolution_effect, critical_slip_distance, stiffness, mass, loading_velocity] =
            frame.sensitivity(arc, &parameter);
        // (ηr² + κ) dlnσ = ηr² dln(M V²/(a D_c)) + κ dln(K D_c/a) − rβ/(r+1) dln(b/a).
        let inertia = eta * r.clone().square();
        let whole = Rational::from(&inertia + &kappa);
        let effect = r.clone() * &beta / (r + 1_u32);
        prop_assert_eq!(Rational::from(&mass * &whole), inertia.clone());
        prop_assert_eq!(Rational::from(&stiffness * &whole), kappa.clone());
        prop_assert_eq!(loading_velocity, mass * 2_u32);
        prop_assert_eq!(critical_slip_distance * &whole, kappa - inertia);
        prop_assert_eq!(evolution_effect * &whole, Rational::from(-&effect));
        prop_assert_eq!(direct_effect * &whole, effect - whole);
    }
}
