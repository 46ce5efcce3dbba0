//! The bounds of a precision level under the largest errors of the groups that they allow for, and the range outside of which they do not hold.

use super::*;

/// So much larger than rounding that each part of a bound is due to it.
const DATA_ERROR: f64 = 1e-9;

/// η, κ and β near the transition and far from it, each large and small.
const POINTS: [[f64; 3]; 6] = [
    [1.0, 1.0, 1.5],
    [1e-3, 0.5, 1.5],
    [1e3, 500.0, 1.5],
    [0.1, 1e4, 1e-3],
    [1e-4, 1e-4, 1e3],
    [20.0, 3.0, 0.9],
];

fn groups([eta, kappa, beta]: [f64; 3]) -> Groups<f64> {
    Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta }
}

/// The groups with each off by all that it may be, up or down as the bits of `signs` say.
fn disturbed(point: [f64; 3], signs: u32) -> BoundedGroups<f64> {
    let off = |place: usize| if signs >> place & 1 == 1 { DATA_ERROR } else { -DATA_ERROR };
    let point = std::array::from_fn(|place| point[place] * (1.0 + off(place)));
    BoundedGroups { groups: groups(point), relative_error: DATA_ERROR }
}

#[test]
fn the_distance_from_the_transition_is_within_its_bound_when_every_group_is_off() {
    for point in POINTS {
        let exact = groups(point).transition_margin();
        for signs in 0..8 {
            let found = disturbed(point, signs).transition_margin();
            assert!((found.value - exact).abs() <= found.error, "{point:?} {signs:03b} {found:?}");
        }
    }
}

#[test]
fn a_certain_sign_is_the_sign_and_on_the_transition_none_is_certain() {
    for (kappa, sign) in [("1.2", 1), ("0.8", -1), ("1.0000000000000000000001", 1)] {
        let kappa = crate::number::parse_decimal(kappa).unwrap();
        let exact = Groups {
            inertial_parameter: Rational::from(1),
            stiffness_group: kappa,
            effect_ratio: Rational::from((3, 2)),
        };
        assert_eq!(transition_sign(&exact), sign);
        assert_eq!(certain_sign(&BoundedGroups::of(&exact).unwrap().transition_margin()), Some(sign));
        let on_it = Groups { stiffness_group: Rational::from(1), ..exact };
        assert_eq!(certain_sign(&BoundedGroups::of(&on_it).unwrap().transition_margin()), None);
    }
}

#[test]
fn the_coefficients_of_eq_8_are_within_their_bounds_when_every_group_is_off() {
    for point in POINTS {
        let exact = groups(point).characteristic_cubic();
        for signs in 0..8 {
            let found = disturbed(point, signs).cubic();
            for (power, coefficient) in exact.iter().enumerate() {
                let off = (found.coefficients[power] - coefficient).abs();
                let bound = found.relative_error * found.magnitudes[power];
                assert!(off <= bound, "{point:?} {signs:03b} x^{power}: {off} > {bound}");
            }
        }
    }
}

/// κ = 10⁻⁵ and η = 10⁵ are harmless, but K and M that lead to them are not.
#[test]
fn inputs_whose_products_could_leave_the_range_are_left_to_higher_precision() {
    let point =
        |stiffness: f64| Parameters::from([1.0, 1.5, 1e-5 / stiffness, stiffness, 1.0 / stiffness, 1.0, 1.0]);
    assert!(inputs_in_range(&point(1e-50)));
    let outside = point(1e-65);
    assert!(groups_in_range(&outside.groups()));
    assert!(!inputs_in_range(&outside));
    assert!(!filter(&outside).0);
    assert!(BoundedGroups::of_parameters(&outside.map(|value| Dd::from(*value))).is_none());
}

/// K = K_c at κ = η = 1 and β = 3/2, and the cusp at κ = 27/8, η = 1/8 and β = 1: one of the two signs is zero.
#[test]
fn the_filter_is_certain_only_where_both_signs_are() {
    let point = |[eta, kappa, beta]: [f64; 3]| Parameters::from([1.0, beta, 1.0, kappa, eta, 1.0, 1.0]);
    assert!(!filter(&point([1.0, 1.0, 1.5])).0);
    assert!(!filter(&point([0.125, 3.375, 1.0])).0);
    assert_eq!(filter(&point([1.0, 1.25, 1.5])), (true, true, false));
    assert_eq!(filter(&point([1.0, 0.75, 1.5])), (true, false, false));
}
