//! Frequencies are the nearest numbers to those of an independent computation with many more bits.

use super::*;
use crate::friction::Slider;
use crate::number::parse_decimal;
use crate::stability::{InertialThreshold, classify};
use proptest::prelude::*;

/// Unit a, D_c and σ, and V0 = rate, make η, κ and β any groups and ω any multiple of Im(p).
fn point(eta: &Rational, kappa: &Rational, beta: &Rational, rate: &Rational) -> Parameters<Rational> {
    let one = Rational::from(1);
    let slider = Slider {
        direct_effect: one.clone(),
        evolution_effect: beta.clone(),
        critical_slip_distance_m: one.clone(),
        stiffness_pa_per_m: kappa.clone(),
        mass_per_area_kg_per_m2: eta / Rational::from(rate.square_ref()),
    };
    slider.at(one, rate.clone())
}

/// The two frequencies and the natural one, rounded from 400 digits.
fn expected(parameters: &Parameters<Rational>) -> [Wide; 3] {
    let roots = certified_roots(&parameters.characteristic_cubic_per_s(), 400).roots;
    let bits = 1300;
    let angular = Float::with_val(bits, &roots.last().unwrap().im);
    let tau = Float::with_val(bits, rug::float::Constant::Pi) * 2u32;
    let natural_squared = parameters.slider.natural_angular_frequency_squared_per_s2();
    let natural = Float::with_val(bits, natural_squared).sqrt();
    let ratio = angular.clone() / &natural;
    [angular / tau, natural, ratio].map(|value| Wide::from_float(&value))
}

/// Both roads against 400 digits; the quick one may leave a point open.
fn assert_nearest(parameters: &Parameters<Rational>) -> Frequencies {
    let threshold = InertialThreshold::default();
    let numbers = |found: Frequencies| {
        [found.frequency_hz, found.natural_angular_frequency_per_s, found.frequency_over_natural]
    };
    let found = Frequencies::of(parameters, &classify(parameters, &threshold));
    assert_eq!(numbers(found), expected(parameters), "{parameters:?}");
    let rounded = parameters.map(Dd::from_rational);
    let batch = crate::stability::batch::classify_points(std::slice::from_ref(&rounded), &threshold);
    for classified in batch.into_iter().flatten() {
        if let Some(quick) = Frequencies::quickly(&rounded, &classified) {
            assert_eq!(numbers(quick), numbers(found), "{parameters:?}");
        }
    }
    found
}

fn group() -> impl Strategy<Value = Rational> {
    (1i64..1_000_000, -12i32..6).prop_map(|(n, e)| parse_decimal(&format!("{n}e{e}")).unwrap())
}

/// The midpoint above the 64-bit number nearest to a value.
fn midpoint_near(value: Wide) -> Rational {
    let below = value.to_float();
    let mut above = below.clone();
    above.next_up();
    (Float::with_val(60, below + above) / 2u32).to_rational().unwrap()
}

#[test]
fn the_constant_is_one_over_two_pi() {
    let exact = Float::with_val(300, rug::float::Constant::Pi) * 2u32;
    let product = exact * (Float::with_val(300, INVERSE_TAU.hi()) + INVERSE_TAU.lo());
    assert!((product - 1u32).abs() < Dd::UNIT);
}

proptest! {
    #[test]
    fn frequencies_are_the_nearest_numbers(eta in group(), kappa in group(), beta in group(), rate in group()) {
        assert_nearest(&point(&eta, &kappa, &beta, &rate));
    }

    /// V0 and M are chosen so that ω/2π lies beside a midpoint of two 64-bit numbers, by a part of 10^-depth.
    #[test]
    fn a_frequency_beside_a_midpoint_is_rounded_to_its_side(
        eta in group(), kappa in group(), beta in group(), depth in 15i32..80, sign in prop::bool::ANY,
    ) {
        let at_one = point(&eta, &kappa, &beta, &Rational::from(1));
        let [hertz, ..] = expected(&at_one);
        prop_assume!(!hertz.is_zero());
        let roots = certified_roots(&at_one.characteristic_cubic_per_s(), 200).roots;
        let exact = Float::with_val(700, &roots.last().unwrap().im)
            / (Float::with_val(700, rug::float::Constant::Pi) * 2u32);
        let shift = parse_decimal(&format!("{}1e-{depth}", if sign { "-" } else { "" })).unwrap() + 1u32;
        let rate = Float::with_val(700, midpoint_near(hertz) * shift) / exact;
        assert_nearest(&point(&eta, &kappa, &beta, &rate.to_rational().unwrap()));
    }
}

/// On K = K_c, (ω/ω_n)² = η/(1 + η): η = r²/(1 − r²) makes ω/ω_n the rational r, here a midpoint of two 64-bit numbers.
#[test]
fn a_ratio_that_is_a_midpoint_goes_to_the_even_neighbour_and_one_beside_it_to_its_side() {
    let beta = parse_decimal("1.5").unwrap();
    let half = 1u64 << 53;
    for odd in [1, 3, 5, 7_001, 123_456_789] {
        let ratio = Rational::from((half + odd, 2 * half));
        let squared = Rational::from(ratio.square_ref());
        let eta = squared.clone() / (1u32 - squared);
        let kappa = (beta.clone() - 1u32) * Rational::from(&eta + 1u32);
        let found = assert_nearest(&point(&eta, &kappa, &beta, &Rational::from(1)));
        let even = Float::with_val(53, &ratio);
        assert_eq!(found.frequency_over_natural, Wide::from_float(&even));
        for shift in ["1e-12", "-1e-12", "1e-17", "-1e-17", "1e-35", "-1e-35", "1e-90", "-1e-90"] {
            let shift = parse_decimal(shift).unwrap() + 1u32;
            assert_nearest(&point(&eta, &(kappa.clone() * shift), &beta, &Rational::from(1)));
        }
    }
}

#[test]
fn frequencies_beyond_the_range_of_64_bits_keep_their_digits() {
    let [eta, kappa, beta, rate] =
        ["1e-1000", "1e5000", "2", "1e-3000"].map(|text| parse_decimal(text).unwrap());
    assert_nearest(&point(&eta, &kappa, &beta, &rate));
    let [eta, kappa, beta] = ["0.125", "3.375", "1"].map(|text| parse_decimal(text).unwrap());
    let found = assert_nearest(&point(&eta, &kappa, &beta, &Rational::from(1)));
    assert!(found.frequency_hz.is_zero() && found.frequency_over_natural.is_zero());
}
