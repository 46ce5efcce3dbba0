//! The batch compared with single points, which go another way.

use super::*;
use crate::number::{Rational, parse_decimal};
use crate::stability::classify;
use crate::stability::three_roots;
use proptest::prelude::*;

fn decimals(exponents: [f64; 7]) -> Parameters<Rational> {
    Parameters::from(exponents.map(|e| parse_decimal(&format!("{:.6e}", libm::exp10(e))).unwrap()))
}

proptest! {
    #[test]
    fn a_batch_says_what_single_points_say(exponents in prop::collection::vec(
        [-4f64..-1.0, -4f64..-1.0, -7f64..-2.0, 4f64..12.0, -2f64..7.0, 2f64..9.0, -9f64..1.0], 1..100,
    )) {
        let threshold = InertialThreshold::default();
        let exact: Vec<Parameters<Rational>> = exponents.into_iter().map(decimals).collect();
        let points: Vec<Parameters<Dd>> = exact.iter().map(|point| point.map(Dd::from_rational)).collect();
        let found = classify_points(&points, &threshold);
        prop_assert_eq!(found.len(), points.len());
        for ((found, point), exact) in found.iter().zip(&points).zip(&exact) {
            prop_assert_eq!(found, &classify_quickly(point, &threshold));
            let found = found.as_ref().expect("a random point is nowhere near a limit");
            prop_assert_eq!(found.precision_level, PrecisionLevel::F64);
            let exact = classify(exact, &threshold);
            prop_assert_eq!(
                (found.transition_sign, found.boundary_sign, found.slip_mode),
                (exact.transition_sign, exact.boundary_sign, exact.slip_mode)
            );
        }
    }

    #[test]
    fn columns_have_the_roots_of_their_points(
        exponents in prop::collection::vec(prop::array::uniform7(-8f64..8.0), 1..150),
    ) {
        let rows: Vec<[f64; 7]> = exponents.into_iter().map(|point| point.map(libm::exp10)).collect();
        let columns: Vec<Vec<f64>> = (0..7).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
        let columns = Parameters::from([0, 1, 2, 3, 4, 5, 6].map(|k: usize| &columns[k][..]));
        let found = three_roots_of_points(&columns).unwrap();
        for (found, row) in found.iter().zip(rows) {
            prop_assert_eq!(*found, three_roots(&Parameters::from(row)).unwrap());
        }
    }
}

#[test]
fn points_next_to_limits_get_the_general_way_and_the_same_answers() {
    let threshold = InertialThreshold::default();
    let at = |eta: f64, kappa: f64, beta: f64| {
        Parameters::from([1.0, beta, 1.0, kappa, eta, 1.0, 1.0].map(Dd::from))
    };
    let points: Vec<Parameters<Dd>> = [1e-16, 1e-13, 1e-9, -1e-9]
        .iter()
        .flat_map(|off| {
            // The boundary at its double root 1, the transition at β = 3, and the cusp.
            [
                at(0.625, 2.875 * (1.0 + off), 9.0),
                at(1.0, 4.0 * (1.0 + off), 3.0),
                at(0.125, 3.375, 1.0 + off),
            ]
        })
        .collect();
    for (found, point) in classify_points(&points, &threshold).iter().zip(&points) {
        assert_eq!(found, &classify_quickly(point, &threshold));
    }
}

#[test]
fn what_cannot_be_solved_is_refused_with_its_index() {
    let one = vec![1.0; 2000];
    let mut other = one.clone();
    other[1500] = f64::NAN;
    let columns = |last: &[f64]| {
        three_roots_of_points(&Parameters::from([&one[..], &one, &one, &one, &one, &one, last]))
    };
    assert_eq!(columns(&one).unwrap().len(), 2000);
    assert_eq!(columns(&other), Err(PointError::Point { index: 1500, error: RootsError::NotPositive }));
    assert_eq!(columns(&one[1..]), Err(PointError::UnequalColumns));
}
