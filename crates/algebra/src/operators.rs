//! Sums, products and text of polynomials.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use rug::Rational;

use super::Polynomial;
use super::budget::spend;

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: Self) -> Polynomial {
        spend(self.term_count() + other.term_count());
        let mut sum = self.clone();
        for (monomial, coefficient) in other.terms() {
            sum.add_term(monomial, coefficient);
        }
        sum
    }
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
        self + &-other
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;

    fn mul(self, other: Self) -> Polynomial {
        spend(self.term_count() * other.term_count() * length(self).max(length(other)));
        let mut product = Polynomial::zero();
        for (left, left_coefficient) in self.terms() {
            for (right, right_coefficient) in other.terms() {
                product.add_term(&left.times(right), &Rational::from(left_coefficient * right_coefficient));
            }
        }
        product
    }
}

/// The length of the longest coefficient in machine words, at least 1.
fn length(polynomial: &Polynomial) -> usize {
    let bits =
        |value: &Rational| value.numer().significant_bits().max(value.denom().significant_bits()) as usize;
    1 + polynomial.terms().map(|(_, coefficient)| bits(coefficient)).max().unwrap_or(0) / 64
}

impl fmt::Display for Polynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", super::Expression::from(self))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Monomial, Symbol};

    /// Small random polynomials in x and y.
    fn polynomial() -> impl Strategy<Value = Polynomial> {
        proptest::collection::vec((-9i32..10, 1i32..5, 0u32..4, 0u32..4), 0..6).prop_map(|terms| {
            let mut sum = Polynomial::zero();
            for (numerator, denominator, x_power, y_power) in terms {
                let monomial = Monomial::power(&Symbol::from("x"), x_power)
                    .times(&Monomial::power(&Symbol::from("y"), y_power));
                sum = &sum + &Polynomial::term(Rational::from((numerator, denominator)), monomial);
            }
            sum
        })
    }

    proptest! {
        #[test]
        fn multiplication_distributes_and_commutes(a in polynomial(), b in polynomial(), c in polynomial()) {
            prop_assert_eq!(&a * &(&b + &c), &(&b * &a) + &(&a * &c));
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
