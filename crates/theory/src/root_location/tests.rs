//! The signs against roots that are known beforehand, and the proofs of the lemmas.

use super::*;
use slipmode_algebra::{Domain, Literal, RootCounts, UnivariatePolynomial};

fn number(value: i32) -> Expression {
    Expression::integer(value)
}

fn holds(formula: &SignFormula) -> bool {
    let of = |literal: &Literal| {
        let value = Domain::default().rational_function(&literal.expression).unwrap().as_constant().unwrap();
        Some(literal.sign.admits(value.cmp0()))
    };
    formula.truth(&of).unwrap()
}

/// leading · Π (s − root) over real roots and pairs x ± iy.
fn product(leading: i32, real: &[i32], pairs: &[(i32, i32)]) -> Vec<Expression> {
    let factors = real.iter().map(|root| vec![-root, 1]);
    let pairs = pairs.iter().map(|(x, y)| vec![x * x + y * y, -2 * x, 1]);
    let start = UnivariatePolynomial::from_integers(&[leading.into()]);
    let times = |product: UnivariatePolynomial, factor: Vec<i32>| {
        product.times(&UnivariatePolynomial::from_integers(
            &factor.iter().map(|&one| one.into()).collect::<Vec<_>>(),
        ))
    };
    let product = factors.chain(pairs).fold(start, times);
    product.coefficients().iter().map(|value| Expression::Number(value.clone())).collect()
}

fn counts(coefficients: &[Expression]) -> RootCounts {
    let values = coefficients.iter().map(|one| one.rational_value(&Default::default()).unwrap());
    UnivariatePolynomial::new(values.collect()).root_counts().unwrap()
}

#[test]
fn signs_agree_with_roots_that_are_known_beforehand() {
    let mut compared = 0;
    let mut compare = |real: &[i32], pairs: &[(i32, i32)]| {
        for leading in [-2, 1, 3] {
            let parts: Vec<i32> = real.iter().copied().chain(pairs.iter().map(|(x, _)| *x)).collect();
            for degree_above in 0..2 {
                let mut coefficients = product(leading, real, pairs);
                // A leading coefficient of zero changes no root.
                coefficients.extend((0..degree_above).map(|_| number(0)));
                let says = |statement: RootStatement| holds(&statement.signs(&coefficients));
                let words = format!("{leading} {real:?} {pairs:?}");
                assert_eq!(says(RootStatement::Stable), parts.iter().all(|part| *part < 0), "{words}");
                assert_eq!(says(RootStatement::Unstable), parts.iter().any(|part| *part > 0), "{words}");
                assert_eq!(says(RootStatement::AllReal), pairs.is_empty(), "{words}");
                // Charts count roots: their counts say the same.
                let counts = counts(&coefficients);
                assert_eq!(counts.right == 0 && counts.on_axis == 0, says(RootStatement::Stable), "{words}");
                assert_eq!(counts.right > 0, says(RootStatement::Unstable), "{words}");
                assert_eq!(counts.real == counts.all, says(RootStatement::AllReal), "{words}");
                compared += 3;
            }
        }
    };
    let all = -2..=2;
    for p in all.clone() {
        compare(&[p], &[]);
        for q in all.clone() {
            compare(&[p, q], &[]);
            for y in 1..=2 {
                compare(&[p], &[(q, y)]);
                compare(&[], &[(q, y)]);
            }
            for r in all.clone() {
                compare(&[p, q, r], &[]);
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// All lists of this length with entries in order, of which the same may stand twice.
fn multisets<T: Copy>(from: &[T], length: usize) -> Vec<Vec<T>> {
    let Some(shorter) = length.checked_sub(1) else { return vec![Vec::new()] };
    let begin = |at: usize| {
        multisets(&from[at..], shorter).into_iter().map(move |mut rest| {
            rest.insert(0, from[at]);
            rest
        })
    };
    (0..from.len()).flat_map(begin).collect()
}

#[test]
fn higher_degrees_agree_with_roots_that_are_known_beforehand() {
    let all_pairs: Vec<(i32, i32)> = (-1..=1).flat_map(|x| [(x, 1), (x, 2)]).collect();
    let mut compared = 0;
    for degree in 4..=MOST_DEGREE {
        for count in 0..=degree / 2 {
            for pairs in multisets(&all_pairs, count) {
                for real in multisets(&[-2, -1, 0, 1], degree - 2 * count) {
                    let leading = [1, -2, 3][compared % 3];
                    let coefficients = product(leading, &real, &pairs);
                    let parts = || real.iter().copied().chain(pairs.iter().map(|(x, _)| *x));
                    let says = |statement: RootStatement| holds(&statement.signs(&coefficients));
                    let words = format!("{leading} {real:?} {pairs:?}");
                    assert_eq!(says(RootStatement::Stable), parts().all(|part| part < 0), "{words}");
                    assert_eq!(says(RootStatement::Unstable), parts().any(|part| part > 0), "{words}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 900, "{compared}");
}

#[test]
fn the_polynomial_zero_has_every_root() {
    let zero = [number(0), number(0)];
    assert!(holds(&RootStatement::Unstable.signs(&zero)));
    assert!(!holds(&RootStatement::Stable.signs(&zero)) && !holds(&RootStatement::AllReal.signs(&zero)));
}

#[test]
fn every_lemma_is_proved_and_has_no_step_in_words() {
    for statement in RootStatement::ALL {
        for degree in 1..=statement.most_degree() {
            let lemma = statement.lemma(degree).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(lemma.recheck(), Ok(()));
            assert!(lemma.is_certified() && !lemma.steps.is_empty());
        }
    }
}

#[test]
fn a_pair_crosses_where_its_real_part_changes_and_the_third_root_is_off_the_axis() {
    let expression = |text: &str| text.parse::<Expression>().unwrap();
    // (s² − (K − 1) s + 4)(s + third): the pair has the real part (K − 1)/2.
    let crosses = |third: &str, move_by: &str, frequency: &str, critical: &str| {
        let real = expression(move_by);
        let third = expression(third);
        let coefficients =
            [number(4) * third.clone(), number(4) - real.clone() * third.clone(), third - real, number(1)];
        let (signs, lemma) =
            pair_crosses(&coefficients, &"K".into(), &expression(critical), &expression(frequency)).unwrap();
        assert!(lemma.is_certified() && lemma.recheck().is_ok());
        holds(&signs)
    };
    assert!(crosses("3", "K - 1", "2", "1") && crosses("-3", "1 - K", "-2", "1"));
    assert!(!crosses("3", "K - 1", "3", "1"), "another frequency");
    assert!(!crosses("3", "K - 1", "2", "2"), "not on the axis there");
    assert!(!crosses("0", "K - 1", "2", "1"), "the third root is on the axis");
    assert!(!crosses("3", "(K - 1)^2", "2", "1"), "it touches the axis only");
    let quadratic = [number(4), expression("1 - K"), number(1)];
    let (signs, lemma) = pair_crosses(&quadratic, &"K".into(), &number(1), &number(2)).unwrap();
    assert!(holds(&signs) && lemma.recheck().is_ok());
}
