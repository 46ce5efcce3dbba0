//! The quick place against the certified one.

use proptest::prelude::*;

use super::*;
use crate::friction::Slider;
use crate::number::parse_decimal;

/// A slider whose η, κ and β are given as powers of ten.
fn point([eta, kappa, beta]: [f64; 3]) -> Parameters<Rational> {
    let one = Rational::from(1);
    let power = |exponent: f64| Rational::from_f64(libm::exp10(exponent)).unwrap();
    let slider = Slider {
        direct_effect: one.clone(),
        evolution_effect: power(beta),
        critical_slip_distance_m: one.clone(),
        stiffness_pa_per_m: power(kappa),
        mass_per_area_kg_per_m2: power(eta),
    };
    slider.at(one.clone(), one)
}

fn exact(parameters: &Parameters<Rational>) -> Option<NearestPlace> {
    nearest_boundary_point(parameters, 30)
        .map(|point| NearestPlace::of_point(&point, &parameters.point.normal_stress_pa))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn a_quick_place_is_the_certified_one(exponents in [-8f64..6.0, -6f64..6.0, -3f64..3.0]) {
        let parameters = point(exponents);
        let quick = NearestPlace::quickly(&parameters.map(Dd::from_rational));
        let quick = quick.expect("a random point is nowhere near a limit").expect("a ≠ b has a place");
        let exact = exact(&parameters).expect("a place");
        prop_assert_eq!((quick.arc, quick.asymptote), (exact.arc, exact.asymptote));
        let close = |x: f64, y: f64| (x - y).abs() <= NearestPlace::CERTAIN * y.abs().clamp(1e-3, 1.0);
        prop_assert!(close(quick.relative_error, exact.relative_error), "{quick:?} {exact:?}");
        prop_assert!(close(quick.log10_normal_stress_distance, exact.log10_normal_stress_distance));
    }
}

#[test]
fn equal_effects_leave_the_lower_arc_and_nothing_beyond_the_cusp() {
    let equal = |kappa: &str, eta: &str| {
        let mut parameters = point([0.0; 3]);
        parameters.slider.stiffness_pa_per_m = parse_decimal(kappa).unwrap();
        parameters.slider.mass_per_area_kg_per_m2 = parse_decimal(eta).unwrap();
        parameters
    };
    let quickly =
        |parameters: &Parameters<Rational>| NearestPlace::quickly(&parameters.map(Dd::from_rational));
    let below = equal("3.375", "0.1");
    assert_eq!(quickly(&below).unwrap().map(|place| place.arc), Some(Arc::Lower));
    assert_eq!(quickly(&equal("3.375", "0.2")), Ok(None));
    assert_eq!(NearestPlace::of(&equal("3.375", "0.2")), None);
    // The cusp itself, κ = 27/8 and η = 1/8: left to the enclosures.
    let cusp = equal("3.375", "0.125");
    assert_eq!(quickly(&cusp), Err(Uncertain));
    let place = NearestPlace::of(&cusp).unwrap();
    assert!(place.log10_normal_stress_distance.abs() < 1e-15, "{place:?}");
}

#[test]
fn next_to_the_cusp_and_far_out_the_answer_is_still_the_certified_one() {
    for exponents in [[-30.0, -20.0, 0.5], [30.0, 20.0, -0.5], [-200.0, -100.0, 0.1], [0.0, 0.0, 1e-12]] {
        let parameters = point(exponents);
        let (found, exact) = (NearestPlace::of(&parameters).unwrap(), exact(&parameters).unwrap());
        assert_eq!((found.arc, found.asymptote), (exact.arc, exact.asymptote), "{exponents:?}");
        let off = (found.relative_error / exact.relative_error - 1.0).abs();
        assert!(off < NearestPlace::CERTAIN, "{exponents:?}: {found:?} {exact:?}");
    }
}

#[test]
fn effects_that_differ_in_the_thirtieth_digit_keep_their_upper_arc() {
    for digit in [14, 16, 25, 31, 33, 49] {
        let excess = parse_decimal(&format!("3e-{digit}")).unwrap();
        for ratio in [excess.clone() + 1u32, Rational::from(1) - excess] {
            let direct = parse_decimal("0.0123").unwrap();
            let mut parameters = point([1.0, 0.5, 0.0]);
            parameters.slider.evolution_effect = ratio * &direct;
            parameters.slider.direct_effect = direct;
            let (found, exact) = (NearestPlace::of(&parameters).unwrap(), exact(&parameters).unwrap());
            assert_eq!((found.arc, found.asymptote), (exact.arc, exact.asymptote), "{digit}");
            let off = found.log10_normal_stress_distance - exact.log10_normal_stress_distance;
            assert!(off.abs() < NearestPlace::CERTAIN, "{digit}: {found:?} {exact:?}");
            assert!((found.relative_error / exact.relative_error - 1.0).abs() < NearestPlace::CERTAIN);
        }
    }
}

/// In other units of stress σ, K and M change together, and nothing else does.
#[test]
fn the_unit_of_stress_does_not_choose_the_place() {
    let mut arcs = std::collections::BTreeSet::new();
    for exponents in
        [[-3.0, -1.0, -0.5], [-3.0, 2.0, -0.5], [2.0, 1.0, 0.3], [-1.0, 0.5, 1.0], [1.0, -2.0, 0.3]]
    {
        let here = point(exponents);
        let unit = Rational::from(1_000_000);
        let mut there = here.clone();
        there.slider.stiffness_pa_per_m *= &unit;
        there.slider.mass_per_area_kg_per_m2 *= &unit;
        there.point.normal_stress_pa = unit;
        let (here, there) = (exact(&here).unwrap(), exact(&there).unwrap());
        assert_eq!((here.arc, here.asymptote), (there.arc, there.asymptote), "{exponents:?}");
        let change = here.log10_normal_stress_distance - there.log10_normal_stress_distance;
        assert!(change.abs() < 1e-12, "{exponents:?} {change}");
        arcs.insert(format!("{:?}", here.arc));
    }
    assert_eq!(arcs.len(), 2, "{arcs:?}");
}
