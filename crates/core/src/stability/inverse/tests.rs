//! Counts against scans of the roots, values against other routes, and the zeros at half the frequency.

use proptest::prelude::*;

use super::*;
use crate::friction::Slider;
use crate::number::{nearest_f64, parse_decimal};
use crate::roots::{CertifiedRoot, certified_roots};
use crate::stability::fixtures;
use crate::stability::inverse::family::at;

/// a, b, K, M and σ with D_c = V0 = 1.
fn parameters([a, b, k, m, s]: [i64; 5]) -> Parameters<Rational> {
    let [one, a, b, k, m, s] = [1, a, b, k, m, s].map(Rational::from);
    Slider::from([a, b, one.clone(), k, m]).at(s, one)
}

/// A part of the roots of eq 8, the largest.
fn largest(parameters: &Parameters<Rational>, part: fn(&CertifiedRoot) -> f64) -> f64 {
    let roots = certified_roots(&parameters.characteristic_cubic_per_s(), 20).roots;
    roots.iter().map(part).fold(f64::NEG_INFINITY, f64::max)
}

/// The mass on the boundary is far below the other roots of the discriminant. Where K is so large, it goes with 1/K: 2.0818840579710145e-33 by FLINT.
#[test]
fn a_mass_on_the_boundary_is_found_at_a_huge_stiffness() {
    for (stiffness, expected) in [
        ("2346e20", 2.081_884_057_971_014_5e-21),
        ("2346e32", 2.081_884_057_971_014_5e-33),
        ("2346e80", 2.081_884_057_971_014_5e-81),
    ] {
        let values = ["0.0026", "0.00058708", "0.00013", stiffness, "1", "17000", "1"];
        let parameters = Parameters::from(values.map(|text| parse_decimal(text).unwrap()));
        let found = solve(&parameters, Unknown::MassPerArea, &Target::Boundary, 20).unwrap();
        assert_eq!(found.len(), 1);
        assert!((found[0].value.to_f64() / expected - 1.0).abs() < 1e-15, "{stiffness}");
        assert_eq!(found[0].kind, SolutionKind::LowerArc);
    }
}

/// Whether the numbers of solutions between neighbours of a grid are odd exactly where the sign changes; gives their sum.
fn count_beside_scan(
    parameters: &Parameters<Rational>,
    unknown: Unknown,
    target: &Target,
    is_above: impl Fn(&Parameters<Rational>) -> bool,
) -> usize {
    let solutions = solve(parameters, unknown, target, 20).unwrap();
    let grid: Vec<Rational> =
        (-60..=60).map(|step| Rational::from_f64(libm::exp(f64::from(step) / 8.0)).unwrap()).collect();
    let sides: Vec<bool> = grid.iter().map(|value| is_above(&at(parameters, unknown, value))).collect();
    for (ends, sides) in grid.windows(2).zip(sides.windows(2)) {
        let [low, high] = [&ends[0], &ends[1]].map(nearest_f64);
        let inside = solutions.iter().filter(|found| (low..high).contains(&found.value.to_f64())).count();
        assert_eq!(inside % 2 == 1, sides[0] != sides[1], "{unknown:?} {target:?} {low} {high}");
    }
    solutions.len()
}

#[test]
fn a_zero_at_half_the_frequency_is_no_solution() {
    // (s + 2)(s² + 4s + 8): the real root is the mean of all three, and the pair is −2 ± 2i.
    let slider = parameters([5, 5, 16, 1, 1]);
    let [c0, c1, c2, c3] = slider.characteristic_cubic_per_s();
    assert_eq!([c0, c1, c2, c3], [16, 16, 6, 1].map(Rational::from));
    for unknown in Unknown::ALL {
        let value: Rational = match unknown {
            Unknown::Stiffness => Rational::from(16),
            _ => Rational::from(1),
        };
        let has = |frequency: i32| {
            let target = Target::AngularFrequency(Rational::from(frequency));
            let found = solve(&slider, unknown, &target, 20).unwrap();
            found.iter().any(|solution| solution.value.contains(&value))
        };
        assert_eq!((has(1), has(2)), (false, true), "{unknown:?}");
        // R itself is zero at both.
        let condition = FrequencyCondition::new(&Family::new(&slider, unknown));
        let zero = Root::all_of(&condition.at(&Rational::from(1)));
        assert!(zero.iter().any(|root| root.enclosed(60).contains(&value)));
    }
}

#[test]
fn three_stresses_velocities_stiffnesses_or_masses_may_have_one_frequency() {
    let decimal = |text: &str| parse_decimal(text).unwrap();
    let count = |values: [&str; 4], unknown, frequency: &str| {
        let [a, b, k, m] = values.map(decimal);
        let one = Rational::from(1);
        let slider = Slider::from([a, b, one.clone(), k, m]).at(one.clone(), one);
        let target = Target::AngularFrequency(decimal(frequency));
        let largest_im = |changed: &Parameters<Rational>| largest(changed, |root| root.im.to_f64());
        count_beside_scan(&slider, unknown, &target, |changed| {
            largest_im(changed) > nearest_f64(&decimal(frequency))
        })
    };
    assert_eq!(count(["1.2533", "2.0689", "9.6866", "0.11147"], Unknown::NormalStress, "0.34733"), 3);
    assert_eq!(count(["0.49811", "0.35498", "18.783", "0.28913"], Unknown::NormalStress, "0.7681"), 3);
    assert_eq!(count(["3.5392", "1.3429", "8.5045", "0.18023"], Unknown::LoadingVelocity, "0.053844"), 3);
    assert_eq!(count(["3.629", "3.7664", "0.39309", "0.41843"], Unknown::Stiffness, "0.5279"), 3);
    assert_eq!(count(["3.5392", "1.3429", "8.5045", "0.18023"], Unknown::MassPerArea, "0.053844"), 3);
    // ω above ω_n: never.
    assert_eq!(count(["1.2533", "2.0689", "4", "1"], Unknown::NormalStress, "2"), 0);
    assert_eq!(count(["1.2533", "2.0689", "4", "1"], Unknown::LoadingVelocity, "2"), 0);
}

#[test]
fn the_transition_is_that_of_the_closed_forms() {
    let slider = fixtures::paper();
    let velocity = Rational::from((1, 1000));
    let stress = slider.transition_normal_stress_pa(&velocity);
    let point = slider.at(stress.clone(), velocity.clone());
    let transition = Target::GrowthRate(Rational::new());
    let only = |unknown| {
        let mut found = solve(&point, unknown, &transition, 30).unwrap();
        assert_eq!((found.len(), found[0].transition_sign), (1, 0));
        found.remove(0)
    };
    assert_eq!(only(Unknown::NormalStress).exact, Some(stress));
    assert_eq!(only(Unknown::Stiffness).exact, Some(point.critical_stiffness()));
    assert_eq!(only(Unknown::MassPerArea).exact, Some(slider.mass_per_area_kg_per_m2.clone()));
    assert!(only(Unknown::LoadingVelocity).value.contains(&velocity));
    let stable = fixtures::with_effects(Rational::from((6, 1000)), Rational::from((4, 1000)));
    assert!(
        solve(&stable.at(Rational::from(1), velocity), Unknown::MassPerArea, &transition, 9)
            .unwrap()
            .is_empty()
    );
}

#[test]
fn a_frequency_in_hertz_is_that_of_the_pair() {
    let slider = fixtures::paper().at(Rational::from(1), Rational::from((1, 1000)));
    let found = solve(&slider, Unknown::NormalStress, &Target::Frequency(Rational::from(10)), 30).unwrap();
    assert_eq!(found.len(), 1);
    let value = found[0].value.centre().to_rational().unwrap();
    let back = at(&slider, Unknown::NormalStress, &value);
    let roots = certified_roots(&back.characteristic_cubic_per_s(), 40).roots;
    let relative = roots[2].im_ball() / (Ball::pi(200) * Ball::from(20)) - Ball::from(1);
    assert!(relative.upper().abs() < 1e-28 && relative.lower().abs() < 1e-28);
    assert!(
        solve(&slider, Unknown::NormalStress, &Target::Frequency(Rational::from(16)), 30).unwrap().is_empty()
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn the_numbers_of_solutions_are_those_of_a_scan(
        values in prop::array::uniform5(1_i64..60), thirds in 1_i64..60,
    ) {
        let slider = parameters(values);
        let wanted = Rational::from((thirds, 13));
        let limit = nearest_f64(&wanted);
        for unknown in Unknown::ALL {
            let frequency = Target::AngularFrequency(wanted.clone());
            let count = count_beside_scan(&slider, unknown, &frequency, |changed| {
                largest(changed, |root| root.im.to_f64()) > limit
            });
            let is_below = wanted.clone().square() < slider.slider.natural_angular_frequency_squared_per_s2();
            let is_expected = match unknown {
                Unknown::MassPerArea => count <= 4,
                Unknown::Stiffness => count == 1 || count == 3,
                _ if is_below => count == 1 || count == 3,
                _ => count == 0,
            };
            prop_assert!(is_expected, "{} of {:?}", count, unknown);
            for sign in [1, -1] {
                let rate = Target::GrowthRate(wanted.clone() * sign);
                count_beside_scan(&slider, unknown, &rate, |changed| {
                    largest(changed, |root| root.re.to_f64()) > limit * f64::from(sign)
                });
            }
        }
    }
}

#[test]
fn a_frequency_ratio_is_that_of_the_pair_for_every_unknown() {
    let mut found = 0;
    for (squared, values) in [((1, 2), [5, 8, 3, 2, 1]), ((4, 5), [8, 5, 1, 3, 2]), ((1, 9), [5, 5, 2, 1, 4])]
    {
        let threshold = InertialThreshold::from_squared_ratio(Rational::from(squared)).unwrap();
        let is_above = |changed: &Parameters<Rational>| {
            let natural = changed.slider.natural_angular_frequency_squared_per_s2();
            let limit = nearest_f64(&(natural * threshold.squared_ratio())).sqrt();
            largest(changed, |root| root.im.to_f64()) > limit
        };
        for unknown in Unknown::ALL {
            let target = Target::FrequencyRatio(threshold.clone());
            found += count_beside_scan(&parameters(values), unknown, &target, is_above);
        }
    }
    assert!(found >= 12, "{found}");
}
