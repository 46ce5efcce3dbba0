//! The contract of certified roots, checked on itself and by rebuilding the cubic.

use super::*;
use crate::number::parse_decimal;
use proptest::prelude::*;

fn decimals(texts: [&str; 4]) -> [Rational; 4] {
    texts.map(|text| parse_decimal(text).unwrap())
}

/// Every part that is not exactly zero must have its relative accuracy, and enclosures must be apart.
fn assert_contract(found: &CertifiedRoots, digits: u32) {
    assert_eq!(found.roots.iter().map(|root| root.multiplicity).sum::<u32>(), 3);
    let wanted = -f64::from(digits) * std::f64::consts::LOG2_10;
    for root in &found.roots {
        for part in [root.re_ball(), root.im_ball()] {
            assert!(part.relative_radius_log2() <= wanted, "{root:?}");
        }
    }
    for (index, root) in found.roots.iter().enumerate() {
        for other in &found.roots[..index] {
            let apart = (root.re.clone() - &other.re).abs() > root.radius.clone() + &other.radius
                || (root.im.clone() - &other.im).abs() > root.radius.clone() + &other.radius;
            assert!(apart, "{root:?} meets {other:?}");
        }
    }
}

/// The second way: the cubic rebuilt from the root balls must contain the cubic it came from.
fn assert_rebuilds(found: &CertifiedRoots, cubic: &[Rational; 4]) {
    let complex = found.discriminant_sign < 0;
    let real: Vec<Ball> = found
        .roots
        .iter()
        .filter(|root| root.im.is_zero())
        .flat_map(|root| std::iter::repeat_n(root.re_ball(), root.multiplicity as usize))
        .collect();
    let (sum, product) = if complex {
        let (re, im) = (found.roots[2].re_ball(), found.roots[2].im_ball());
        (re.clone() * Ball::from(2), re.square() + im.square())
    } else {
        (real[1].clone() + &real[2], real[1].clone() * &real[2])
    };
    let monic = |k: usize| Rational::from(&cubic[k] / &cubic[3]);
    assert!((-(real[0].clone() + &sum)).contains(&monic(2)));
    assert!((real[0].clone() * &sum + &product).contains(&monic(1)));
    assert!((-(real[0].clone() * &product)).contains(&monic(0)));
}

fn check(cubic: &[Rational; 4], digits: u32) -> CertifiedRoots {
    let found = certified_roots(cubic, digits);
    assert_contract(&found, digits);
    assert_rebuilds(&found, cubic);
    found
}

#[test]
fn the_cusp_at_equal_effects_is_a_triple_root_at_minus_three() {
    // η = 1/8, κ = 27/8, β = 1.
    let found = check(&decimals(["3.375", "3.375", "1.125", "0.125"]), 1000);
    assert_eq!(found.roots.len(), 1);
    assert_eq!((found.roots[0].multiplicity, found.roots[0].radius.is_zero()), (3, true));
    assert_eq!(found.roots[0].re, -3);
}

#[test]
fn a_double_root_has_multiplicity_two_and_a_neighbour_1e_1000_away_has_not() {
    // (x + 1)²(x + 2) = x³ + 4x² + 5x + 2.
    let double = check(&decimals(["2", "5", "4", "1"]), 50);
    assert_eq!(double.roots.iter().map(|r| r.multiplicity).collect::<Vec<_>>(), [1, 2]);
    for (shift, roots) in [("1e-1000", 3), ("-1e-1000", 3)] {
        let mut cubic = decimals(["2", "5", "4", "1"]);
        cubic[0] += parse_decimal(shift).unwrap();
        assert_eq!(check(&cubic, 50).roots.len(), roots);
    }
}

#[test]
fn a_pair_on_the_imaginary_axis_has_real_part_exactly_zero() {
    // (x² + 3)(2x + 5) and a neighbour 1e-60 off it.
    let mut cubic = decimals(["15", "6", "5", "2"]);
    assert!(check(&cubic, 100).roots[2].re.is_zero());
    cubic[0] += parse_decimal("1e-60").unwrap();
    let near = check(&cubic, 100);
    assert!(!near.roots[2].re.is_zero() && near.roots[2].re.to_f64().abs() < 1e-60);
}

#[test]
fn roots_thousands_of_orders_of_magnitude_apart_keep_their_digits() {
    check(&decimals(["1e-3000", "1", "1e2500", "1e-9000"]), 60);
    check(&decimals(["1e3000", "-1", "1e-2500", "1e1000"]), 60);
}

#[test]
fn ten_thousand_digits_are_certified() {
    let found = check(&decimals(["0.7", "0.31", "1.013", "0.013"]), 10_000);
    assert!(found.precision_bits > 33_219 && found.precision_bits < 33_400);
}

#[test]
fn zero_roots_and_lower_degrees_are_guarded() {
    let found = check(&decimals(["0", "2", "3", "1"]), 30);
    assert!(found.roots[2].re.is_zero() && found.roots[2].radius.is_zero());
    assert!(certified_roots(&decimals(["1", "2", "1", "0"]), 30).roots.is_empty());
}

fn coefficient() -> impl Strategy<Value = Rational> {
    (1i64..1_000_000_000, -40i32..40, prop::bool::ANY).prop_map(|(digits, exponent, negative)| {
        let value = parse_decimal(&format!("{digits}e{exponent}")).unwrap();
        if negative { -value } else { value }
    })
}

/// Roots to a few digits, and to so many that they come by the other road: the enclosures must meet.
fn assert_contains_more_digits(cubic: &[Rational; 4], digits: u32) {
    let (found, more) = (check(cubic, digits), certified_roots(cubic, digits + 130));
    assert_eq!(found.discriminant_sign, more.discriminant_sign);
    for (root, reference) in found.roots.iter().zip(&more.roots) {
        assert_eq!(root.multiplicity, reference.multiplicity);
        assert!(
            root.re_ball().overlaps(&reference.re_ball()) && root.im_ball().overlaps(&reference.im_ball())
        );
    }
}

proptest! {
    #[test]
    fn roots_in_limbs_contain_those_with_more_digits(
        cubic in prop::array::uniform4(coefficient()), digits in 1u32..115,
    ) {
        assert_contains_more_digits(&cubic, digits);
    }

    #[test]
    fn roots_in_limbs_next_to_multiple_roots_contain_those_with_more_digits(
        root in -1000i64..1000, other in -1000i64..1000, triple in prop::bool::ANY, power in 20u32..90,
        shift in prop::array::uniform4(-9i32..10), digits in 1u32..115,
    ) {
        let [a, b] = [root, if triple { root } else { other }].map(Rational::from);
        let (twice, square) = (Rational::from(&a * 2u32), a.clone().square());
        let exact = [
            -(square.clone() * &b), square + twice.clone() * &b, -(twice + &b), Rational::from(1),
        ];
        let cubic = std::array::from_fn(|k| exact[k].clone() + (Rational::from(shift[k]) >> power));
        assert_contains_more_digits(&cubic, digits);
    }

    #[test]
    fn any_cubic_is_enclosed_and_rebuilt(
        cubic in prop::array::uniform4(coefficient()), digits in 1u32..120,
    ) {
        check(&cubic, digits);
    }

    #[test]
    fn rational_roots_are_found_also_when_close(
        root in -1000i64..1000, gap in 0i64..3, power in 0u32..80, other in -1000i64..1000,
    ) {
        let distance = Rational::from(gap) >> power;
        let (a, b, c) = (Rational::from(root), Rational::from(root) + distance, Rational::from((other, 7)));
        let cubic = [
            -(a.clone() * &b * &c),
            a.clone() * &b + b.clone() * &c + c.clone() * &a,
            -(a.clone() + &b + &c),
            Rational::from(1),
        ];
        let found = check(&cubic, 40);
        for exact in [a, b, c] {
            prop_assert!(found.roots.iter().any(|r| r.re_ball().contains(&exact)), "{} missed", exact);
        }
    }
}

#[test]
fn a_hundred_thousand_digits_are_certified_and_rebuild_the_cubic() {
    let ordinary = decimals(["0.7", "-0.2", "1.3", "0.3"]);
    // The double root 1 at β = 9 (η = 5/8, κ = 23/8), with κ moved by 1e-30.
    let kappa = parse_decimal("2.875000000000000000000000000001").unwrap();
    let hard = [kappa.clone(), kappa + 1u32 - 9u32, Rational::from((13, 8)), Rational::from((5, 8))];
    for cubic in [ordinary, hard] {
        assert_eq!(check(&cubic, 100_000).discriminant_sign.abs(), 1);
    }
}
