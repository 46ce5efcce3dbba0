//! Sums, products and text of polynomials.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use rug::Rational;

use super::budget::spend;
use super::{Monomial, Polynomial};

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: Self) -> Polynomial {
        merged(self, other, Rational::clone)
    }
}

/// The sum of a polynomial and of another one whose coefficients are changed.
fn merged(one: &Polynomial, other: &Polynomial, changed: fn(&Rational) -> Rational) -> Polynomial {
    spend(one.term_count() + other.term_count());
    let mut sum = Vec::with_capacity(one.term_count() + other.term_count());
    let mut left = one.terms().peekable();
    for (monomial, coefficient) in other.terms() {
        while let Some((lighter, own)) = left.next_if(|(own, _)| *own < monomial) {
            sum.push((lighter.clone(), own.clone()));
        }
        let mut coefficient = changed(coefficient);
        if let Some((_, own)) = left.next_if(|(own, _)| *own == monomial) {
            coefficient += own;
        }
        if !coefficient.is_zero() {
            sum.push((monomial.clone(), coefficient));
        }
    }
    sum.extend(left.map(|(monomial, coefficient)| (monomial.clone(), coefficient.clone())));
    Polynomial::of_ascending(sum)
}

impl Neg for &Polynomial {
    type Output = Polynomial;

    fn neg(self) -> Polynomial {
        self.scale(&Rational::from(-1))
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: Self) -> Polynomial {
        merged(self, other, |coefficient| Rational::from(-coefficient))
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: Self) -> Polynomial {
        spend(self.term_count() * other.term_count() * length(self).max(length(other)));
        let (short, long) =
            if self.term_count() < other.term_count() { (self, other) } else { (other, self) };
        let products = short.terms().flat_map(|(monomial, coefficient)| {
            long.terms().map(move |(own, value)| (own.times(monomial), Rational::from(value * coefficient)))
        });
        // Products with one monomial keep the order.
        if short.term_count() <= 1 {
            return Polynomial::of_ascending(products.collect());
        }
        let mut product = BTreeMap::<Monomial, Rational>::new();
        for (monomial, coefficient) in products {
            *product.entry(monomial).or_default() += coefficient;
        }
        Polynomial::of_ascending(
            product.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()).collect(),
        )
    }
}

/// The length of the longest coefficient in machine words, at least 1.
pub(super) fn length(polynomial: &Polynomial) -> usize {
    polynomial.terms().map(|(_, coefficient)| length_of(coefficient)).max().unwrap_or(1)
}

/// The length of a coefficient in machine words, at least 1.
pub(super) fn length_of(value: &Rational) -> usize {
    1 + value.numer().significant_bits().max(value.denom().significant_bits()) as usize / 64
}

impl fmt::Display for Polynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", super::Expression::from(self))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;
    use crate::{Monomial, Symbol};

    /// Small random polynomials in x and y.
    fn polynomial() -> impl Strategy<Value = Polynomial> {
        proptest::collection::vec((-9i32..10, 1i32..5, 0u32..4, 0u32..4), 0..6).prop_map(|terms| {
            let (mut sum, mut one_by_one) = (Polynomial::zero(), Polynomial::zero());
            for (numerator, denominator, x_power, y_power) in terms {
                let monomial = Monomial::power(&Symbol::from("x"), x_power)
                    .times(&Monomial::power(&Symbol::from("y"), y_power));
                let coefficient = Rational::from((numerator, denominator));
                one_by_one.add_term(&monomial, &coefficient);
                sum = &sum + &Polynomial::term(coefficient, monomial);
            }
            assert_eq!(sum, one_by_one);
            sum
        })
    }

    proptest! {
        #[test]
        fn multiplication_distributes_and_commutes(a in polynomial(), b in polynomial(), c in polynomial()) {
            prop_assert_eq!(&a * &(&b + &c), &(&b * &a) + &(&a * &c));
        }

        #[test]
        fn values_are_those_of_the_numbers_and_terms_ascend(
            a in polynomial(), b in polynomial(), x in -5i32..6, y in (-5i32..6, 1i32..4)
        ) {
            let point = BTreeMap::from([("x", Rational::from(x)), ("y", Rational::from(y))].map(|(name, at)| (Symbol::from(name), at)));
            let at = |polynomial: &Polynomial| polynomial.evaluate(&point).expect("a value for each name");
            prop_assert_eq!(at(&(&a + &b)), at(&a) + at(&b));
            prop_assert_eq!(at(&(&a - &b)), at(&a) - at(&b));
            prop_assert_eq!(at(&(&a * &b)), at(&a) * at(&b));
            let x = Symbol::from("x");
            let moved = point.iter().map(|(name, own)| (name.clone(), if *name == x { at(&b) } else { own.clone() }));
            prop_assert_eq!(Some(at(&a.substitute(&x, &b))), a.evaluate(&moved.collect()));
            let signs: BTreeSet<_> = a.terms().map(|(_, coefficient)| if coefficient.is_positive() { 1 } else { -1 }).collect();
            prop_assert_eq!(a.coefficient_sign(), signs.first().copied().filter(|_| signs.len() == 1));
            let results = [&a + &b, &a - &b, &a * &b].into_iter().chain((&a * &b).divide_exact(&b));
            for result in results {
                prop_assert!(result.terms().is_sorted_by(|(lighter, _), (heavier, _)| lighter < heavier));
                prop_assert!(result.terms().all(|(_, coefficient)| !coefficient.is_zero()));
            }
        }

        #[test]
        fn difference_with_itself_vanishes(a in polynomial()) {
            prop_assert!((&a - &a).is_zero());
        }

        #[test]
        fn derivative_obeys_the_product_rule(a in polynomial(), b in polynomial()) {
            let x = Symbol::from("x");
            let rule = &(&a.derivative(&x) * &b) + &(&a * &b.derivative(&x));
            prop_assert_eq!((&a * &b).derivative(&x), rule);
        }

        #[test]
        fn substitution_is_a_homomorphism(a in polynomial(), b in polynomial(), value in polynomial()) {
            let x = Symbol::from("x");
            let product = &a.substitute(&x, &value) * &b.substitute(&x, &value);
            prop_assert_eq!((&a * &b).substitute(&x, &value), product);
        }

        #[test]
        fn exact_division_undoes_multiplication(a in polynomial(), b in polynomial()) {
            if !b.is_zero() {
                prop_assert_eq!((&a * &b).divide_exact(&b), Some(a));
            }
        }

        #[test]
        fn greatest_common_divisor_divides_both_and_holds_the_common_factor(
            a in polynomial(), b in polynomial(), common in polynomial()
        ) {
            prop_assume!(!a.is_zero() && !b.is_zero() && !common.is_zero());
            let (left, right) = (&a * &common, &b * &common);
            let divisor = left.gcd(&right);
            prop_assert!(left.divide_exact(&divisor).is_some() && right.divide_exact(&divisor).is_some());
            prop_assert!(divisor.divide_exact(&common).is_some());
        }

        #[test]
        fn printed_polynomial_reads_back(a in polynomial()) {
            let text = a.to_string();
            let expression: crate::Expression = text.parse().expect("printer writes the grammar");
            let read = crate::Domain::default().rational_function(&expression).expect("a polynomial");
            prop_assert_eq!(read, a.into());
        }
    }
}
