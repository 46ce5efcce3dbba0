//! Hard 64-bit points against rationals and 60-digit roots.

use super::*;
use proptest::prelude::*;
use rug::Float;

use crate::roots::certified_roots;

/// Holds an answer against the exact signs and 60-digit roots.
fn assert_promises(point: &Parameters<f64>) -> Classification {
    let threshold = InertialThreshold::default();
    let found = classify_binary64(point, &threshold).unwrap();
    let exact = point.map(|value| Rational::from_f64(*value).unwrap());
    let by_rationals = classify(&exact, &threshold);
    let names = |found: &Classification| {
        (found.transition_sign, found.boundary_sign, found.spectral_class, found.slip_mode)
    };
    assert_eq!(names(&found), names(&by_rationals), "{point:?}");
    let roots = certified_roots(&exact.groups().characteristic_cubic(), 60).roots;
    let rate = Float::with_val(300, &exact.rate_per_s());
    let highest = roots.iter().map(|root| root.im.clone()).max_by(Float::total_cmp).unwrap() * &rate;
    let top = roots.iter().max_by(|x, y| x.re.total_cmp(&y.re)).unwrap();
    let error = |found: crate::number::Wide, exact: &Float| (found.to_float() - exact).abs();
    assert!(error(found.max_imaginary_per_s, &highest) <= highest * 1e-14, "{point:?} {found:?}");
    let growth = top.re.clone() * &rate;
    assert!(error(found.max_real_per_s, &growth) <= growth.clone().abs() * 1e-14, "{point:?} {found:?}");
    let sign = found.max_real_per_s.to_float().cmp0().unwrap() as i8;
    assert_eq!(sign, -found.transition_sign, "growth has the sign of K_c − K");
    found
}

fn slider(direct_effect: f64, evolution_effect: f64, stiffness: f64, mass: f64) -> Parameters<f64> {
    Parameters::from([direct_effect, evolution_effect, 1.0, stiffness, mass, 1.0, 1.0])
}

/// Zero, or a power of ten from 1e-30 to 1e-6 with either sign; below 1e-16 it is lost in 64-bit numbers of order 1.
fn distance() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), (-30f64..-6.0).prop_map(libm::exp10), (-16f64..-6.0).prop_map(|e| -libm::exp10(e))]
}

proptest! {
    #[test]
    fn points_beside_a_double_root_keep_signs_and_digits(
        ratio in 16i32..256, distance_of_root in 7i32..384, epsilon in distance(),
    ) {
        let ratio = f64::from(ratio) / 64.0;
        let r = -1.0 - (64.0 * ratio.sqrt()).ceil() / 64.0 - f64::from(distance_of_root) / 64.0;
        let square = (r + 1.0) * (r + 1.0);
        let direct = (2.0 * r * square).abs();
        let stiffness = (r * r * ((2.0 * r + 1.0) * ratio - square)).abs();
        let found = assert_promises(&slider(
            direct, ratio * direct, stiffness * (1.0 + epsilon), (ratio - square).abs(),
        ));
        prop_assert!(epsilon != 0.0 || found.boundary_sign == 0);
    }

    #[test]
    fn points_beside_the_transition_keep_signs_and_digits(
        ratio in 71i32..512, inertia in 7i32..512, epsilon in distance(),
    ) {
        let (ratio, inertia) = (f64::from(ratio) / 64.0, f64::from(inertia) / 64.0);
        let stiffness = (ratio - 1.0) * (1.0 + inertia) * (1.0 + epsilon);
        let found = assert_promises(&slider(1.0, ratio, stiffness, inertia));
        prop_assert!(epsilon != 0.0 || found.transition_sign == 0 && found.max_real_per_s.is_zero());
    }

    #[test]
    fn points_beside_the_cusp_keep_signs_and_digits(steps in 7i32..512, epsilon in distance()) {
        let r = -1.0 - f64::from(steps) / 64.0;
        let cube = |x: f64| (x * x * x).abs();
        let found = assert_promises(&slider(
            (3.0 * r + 1.0).abs(), cube(r + 1.0) * (1.0 + epsilon), cube(r), 1.0,
        ));
        prop_assert!(epsilon != 0.0 || found.boundary_sign == 0 && found.max_imaginary_per_s.is_zero());
    }

    /// The groups next to the cusp of β = 1 at distances that only the exponents of the inputs can carry.
    #[test]
    fn distances_down_to_1e_30_from_a_double_root_at_infinity_are_seen(exponent in -30f64..-6.0, beta in 1i32..64) {
        // η → 0: the boundary runs to κ = (√β ∓ 1)²; with β a square and η tiny, the distance is about η.
        let root = f64::from(beta);
        for kappa in [(root - 1.0) * (root - 1.0), (root + 1.0) * (root + 1.0)] {
            prop_assume!(kappa > 0.0);
            assert_promises(&slider(1.0, root * root, kappa, libm::exp10(exponent)));
        }
    }

    #[test]
    fn random_points_keep_signs_and_digits(exponents in [
        -4f64..-1.0, -4f64..-1.0, -7f64..-2.0, 4f64..12.0, -2f64..7.0, 2f64..9.0, -9f64..1.0,
    ]) {
        assert_promises(&Parameters::from(exponents.map(libm::exp10)));
    }

    #[test]
    fn the_short_cubic_has_the_signs_of_the_rationals(values in prop::array::uniform7(-30f64..30.0)) {
        let point = Parameters::from(values.map(libm::exp2));
        if let Some(cubic) = short_cubic(&point) {
            let groups = point.map(|value| Rational::from_f64(*value).unwrap()).groups();
            prop_assert_eq!(cubic.hurwitz_sign(), crate::stability::transition_sign(&groups));
            prop_assert_eq!(cubic.discriminant_sign(), crate::stability::boundary_sign(&groups));
        }
    }
}

#[test]
fn points_on_the_cusp_and_on_the_transition_need_no_rationals() {
    let threshold = InertialThreshold::default();
    let cusp = classify_shortly(&slider(1.0, 1.0, 3.375, 0.125), &threshold).unwrap();
    assert_eq!((cusp.boundary_sign, cusp.max_real_per_s.to_f64()), (0, Some(-3.0)));
    assert!(cusp.max_imaginary_per_s.is_zero());
    let neutral = classify_shortly(&slider(1.0, 3.0, 3.0, 0.5), &threshold).unwrap();
    assert_eq!((neutral.transition_sign, neutral.max_real_per_s.is_zero()), (0, true));
    assert!((neutral.max_imaginary_per_s.to_f64().unwrap() - 2f64.sqrt()).abs() < 1e-15);
}

/// A D_c² or V0² beyond 64-bit's range between inputs and groups of ordinary size.
#[test]
fn modes_do_not_depend_on_the_units_of_the_inputs() {
    for (stiffness, mass) in [(0.6, 0.2), (0.75, 0.5), (2.0, 3.0), (0.01, 1e-3), (7.0, 0.3)] {
        for (length, velocity) in [(700, 600), (-700, -600), (600, -700), (-500, 510), (0, 600)] {
            // β = 3/2, next to K = K_c for the second pair.
            let mut point = slider(
                1.0,
                1.5,
                libm::ldexp(stiffness, -length),
                libm::scalbn(mass, (length - 2 * velocity).clamp(-1000, 1000)),
            );
            point.slider.critical_slip_distance_m = libm::ldexp(1.0, length);
            point.point.loading_velocity_m_per_s = libm::ldexp(1.0, velocity);
            assert_promises(&point);
        }
    }
}

#[test]
fn inputs_that_are_not_positive_and_finite_are_refused() {
    let threshold = InertialThreshold::default();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(classify_binary64(&slider(bad, 1.0, 1.0, 1.0), &threshold).is_none());
    }
}

#[test]
fn inputs_at_the_ends_of_the_range_are_classified() {
    for pattern in 0..9 {
        let ends = [f64::from_bits(1), 7.0, f64::MAX];
        let end = |k: usize| ends[(pattern * (k + 1) + k / 3) % 3];
        let point = Parameters::from([end(0), end(1), end(2), end(3), end(4), end(5), end(6)]);
        assert_promises(&point);
    }
}
