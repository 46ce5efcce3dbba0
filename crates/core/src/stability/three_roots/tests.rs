//! The guarantee of the three roots, compared with certified roots to 40 digits.

use super::*;
use crate::stability::fixtures::{double_root_and_effect_ratio, inertial_parameter, stiffness_group};
use proptest::prelude::*;

/// The roots of the reference in the order of [`ThreeRoots`], and its largest real part.
fn reference(parameters: &Parameters<Rational>) -> (Vec<[Float; 2]>, Float) {
    let found = certified_roots(&parameters.characteristic_cubic_per_s(), 40).roots;
    let largest = found.iter().map(|root| root.re.clone()).max_by(Float::total_cmp).unwrap();
    let each = found
        .iter()
        .flat_map(|root| std::iter::repeat_n([root.re.clone(), root.im.clone()], root.multiplicity as usize));
    (each.collect(), largest)
}

/// Checks the guarantee of one point, and returns what was found.
fn assert_guarantee<R: ExactInput + std::fmt::Debug>(parameters: &Parameters<R>) -> ThreeRoots {
    let found = three_roots(parameters).unwrap_or_else(|error| panic!("{parameters:?}: {error}"));
    let (roots, largest) = reference(&parameters.map(|value| value.exactly().unwrap()));
    for (root, [re, im]) in found.roots.iter().zip(&roots) {
        let wide = |value: f64| Float::with_val(200, value);
        let distance = (wide(root.re) - re).hypot(&(wide(root.im) - im));
        let modulus = Float::with_val(200, re).hypot(im);
        assert!(distance <= modulus * ROOT_ERROR, "{parameters:?} {found:?} {roots:?}");
    }
    let error = (Float::with_val(200, found.max_real_per_s) - largest).abs();
    assert!(error <= found.max_real_error_per_s, "{parameters:?} {found:?}");
    let modulus = found.roots.iter().map(|root| root.norm()).fold(0.0, f64::max);
    assert!(found.max_real_error_per_s <= 1.001 * ROOT_ERROR * modulus, "{parameters:?} {found:?}");
    found
}

/// 1 ± 10^-depth.
fn factor(depth: f64, plus: bool) -> f64 {
    let distance = libm::exp10(-depth);
    if plus { 1.0 + distance } else { 1.0 - distance }
}

/// Unit a, D_c, V and σ make the groups the parameters: η = M, κ = K, β = b.
fn with_groups<R: From<u8>>(eta: R, kappa: R, beta: R) -> Parameters<R> {
    let one = || R::from(1u8);
    Parameters::from([one(), beta, one(), kappa, eta, one(), one()])
}

fn nearest(value: &Rational) -> f64 {
    crate::number::nearest_f64(value)
}

proptest! {
    #[test]
    fn the_guarantee_holds_at_random_points(exponents in [
        -4f64..-1.5, -4f64..-1.5, -7f64..-2.0, 4f64..12.0, -2f64..7.0, 2f64..9.0, -9f64..1.0,
    ]) {
        let parameters = Parameters::from(exponents.map(libm::exp10));
        let found = assert_guarantee(&parameters);
        prop_assert_eq!(found.precision_level, PrecisionLevel::DoubleDouble);
        let exact = parameters.map(|value| Rational::from_f64(*value).unwrap());
        prop_assert_eq!(assert_guarantee(&exact).roots, found.roots);
    }

    #[test]
    fn the_guarantee_holds_beside_the_boundary(
        (r, beta) in double_root_and_effect_ratio(), depth in 1f64..16.5, plus in prop::bool::ANY,
    ) {
        let groups = [inertial_parameter(&r, &beta), stiffness_group(&r, &beta), beta];
        let [eta, kappa, beta] = groups.each_ref().map(nearest);
        prop_assume!([eta, kappa, beta].iter().all(|value| (1e-250..1e250).contains(value)));
        assert_guarantee(&with_groups(eta, kappa * factor(depth, plus), beta));
        let [eta, kappa, beta] = groups;
        assert_guarantee(&with_groups(eta, kappa, beta));
    }

    #[test]
    fn the_guarantee_holds_beside_the_transition(
        eta in -4f64..4.0, excess in -4f64..4.0, depth in 1f64..16.5, plus in prop::bool::ANY,
    ) {
        let (eta, beta) = (libm::exp10(eta), 1.0 + libm::exp10(excess));
        let kappa = (beta - 1.0) * (1.0 + eta);
        let found = assert_guarantee(&with_groups(eta, kappa * factor(depth, plus), beta));
        prop_assert_eq!(found.precision_level, PrecisionLevel::DoubleDouble);
    }

    #[test]
    fn the_guarantee_holds_beside_the_triple_root(
        r in 0.1f64..20.0, depth in 1f64..16.5, plus in prop::bool::ANY, which in 0usize..3,
    ) {
        // η(p − r)³ for r < −1 has η = −1/(3r + 1), κ = −ηr³, and β = κ + 1 − 3ηr².
        let r = -1.0 - r;
        let eta = -1.0 / (3.0 * r + 1.0);
        let kappa = -eta * r * r * r;
        let mut groups = [eta, kappa, kappa + 1.0 - 3.0 * eta * r * r];
        groups[which] *= factor(depth, plus);
        let [eta, kappa, beta] = groups;
        assert_guarantee(&with_groups(eta, kappa, beta));
    }

    #[test]
    fn the_guarantee_holds_at_extreme_scales(exponents in prop::array::uniform7(-300f64..300.0)) {
        let parameters = Parameters::from(exponents.map(libm::exp10));
        match three_roots(&parameters) {
            Ok(_) => drop(assert_guarantee(&parameters)),
            Err(error) => {
                prop_assert_eq!(error, RootsError::OutOfRange);
                let exact = parameters.map(|value| Rational::from_f64(*value).unwrap());
                let outside = |[re, im]: &[Float; 2]| {
                    let size = re.clone().abs().max(&im.clone().abs());
                    !(1e-299..=1e299).contains(&size)
                };
                prop_assert!(reference(&exact).0.iter().any(outside));
            }
        }
    }
}

#[test]
fn roots_that_coincide_are_given_as_often_as_they_count() {
    // The cusp at b = a, a triple root at −3; and the double root 1 at β = 9 (η = 5/8, κ = 23/8).
    let triple = assert_guarantee(&with_groups(0.125, 3.375, 1.0));
    assert_eq!(triple.roots, [Complex::new(-3.0, 0.0); 3]);
    let double = assert_guarantee(&with_groups(0.625, 2.875, 9.0));
    assert_eq!(double.roots[1..], [Complex::new(1.0, 0.0); 2]);
    assert_eq!(double.precision_level, PrecisionLevel::Exact);
}

#[test]
fn inputs_that_are_not_positive_and_finite_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..7 {
            let mut inputs = [1.0; 7];
            inputs[place] = bad;
            assert_eq!(three_roots(&Parameters::from(inputs)), Err(RootsError::NotPositive), "{bad} {place}");
        }
    }
    let zero = Parameters::from([1, 1, 1, 1, 1, 1, 0].map(Rational::from));
    assert_eq!(three_roots(&zero), Err(RootsError::NotPositive));
}
