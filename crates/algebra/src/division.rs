//! Exact division and greatest common divisors of polynomials in several variables.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use rug::{Integer, Rational};

use super::budget::spend;
use super::operators::{length, length_of};
use super::{Generator, Monomial, Polynomial};

impl Polynomial {
    /// The quotient when the division leaves no remainder; `None` otherwise, and for division by zero.
    #[must_use]
    pub fn divide_exact(&self, divisor: &Self) -> Option<Self> {
        let (leading, leading_coefficient) = divisor.leading_term()?;
        let length = length(divisor);
        let mut remainder: BTreeMap<Monomial, Rational> =
            self.terms().map(|(monomial, coefficient)| (monomial.clone(), coefficient.clone())).collect();
        let mut quotient = Vec::new();
        while let Some((monomial, coefficient)) = remainder.pop_last() {
            let step = monomial.divided_by(leading)?;
            let factor = coefficient / leading_coefficient;
            // A product, a difference and a sum.
            spend(divisor.term_count() * length.max(length_of(&factor)));
            spend(remainder.len() + 1 + divisor.term_count() + quotient.len() + 1);
            // The leading terms have cancelled.
            for (own, value) in divisor.terms().rev().skip(1) {
                subtract(&mut remainder, own.times(&step), Rational::from(value * &factor));
            }
            quotient.push((step, factor));
        }
        quotient.reverse();
        Some(Self::of_ascending(quotient))
    }

    /// A polynomial whose square this is (its leading coefficient positive), if there is one.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        let (monomial, coefficient) = self.leading_term()?;
        let leading = Self::term(square_root_of(coefficient)?, monomial.square_root()?);
        let (step_monomial, step_coefficient) = leading.leading_term()?;
        let mut root = leading.clone();
        let mut remainder = self - &root.pow(2);
        while let Some((monomial, coefficient)) = remainder.leading_term() {
            let term = Self::term(
                Rational::from(coefficient / step_coefficient) / 2,
                monomial.divided_by(step_monomial)?,
            );
            // The terms of a root come in descending order; another order means that there is none.
            if term.leading_term()?.0 >= root.terms().next()?.0 {
                return None;
            }
            remainder = &remainder - &(&(&(&root + &root) + &term) * &term);
            root = &root + &term;
        }
        Some(root)
    }

    /// The greatest common divisor, its leading coefficient 1; zero only when both are zero.
    ///
    /// Primitive remainder sequences, one variable at a time.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return (self + other).monic();
        }
        if (self.term_count() == 1 || other.term_count() == 1)
            && let Some((own, others)) = self.common_monomial().zip(other.common_monomial())
        {
            return Self::term(Rational::from(1), own.common_divisor(&others));
        }
        let (left, right) = (self.generators(), other.generators());
        // A divisor of both is free of every variable that only one of them has, so it divides that one's coefficients.
        for (polynomial, divided, alone) in [(self, other, &left - &right), (other, self, &right - &left)] {
            if let Some(variable) = alone.iter().next() {
                let coefficients =
                    polynomial.coefficients(variable).into_iter().filter(|part| !part.is_zero());
                return coefficients.fold(divided.monic(), |divisor, part| divisor.gcd(&part));
            }
        }
        // The variable of least degree keeps the remainder sequence short.
        let degree = |name: &&Generator| self.degree(name).min(other.degree(name));
        match left.iter().min_by_key(degree) {
            None => Self::one(),
            Some(variable) => self.gcd_in(other, variable).monic(),
        }
    }

    /// The polynomial divided by its leading coefficient.
    #[must_use]
    pub fn monic(&self) -> Self {
        self.leading_term().map_or_else(Self::zero, |(_, leading)| self.scale(&leading.clone().recip()))
    }

    /// The polynomial times the positive number that makes its coefficients integers without a common factor.
    pub(crate) fn with_integers(&self) -> Self {
        self.scale(&integer_scale(self.terms().map(|(_, coefficient)| coefficient)))
    }

    /// The greatest monomial that divides every term; none of zero.
    pub(super) fn common_monomial(&self) -> Option<Monomial> {
        let monomials = self.terms().map(|(monomial, _)| monomial.clone());
        monomials.reduce(|divisor, monomial| divisor.common_divisor(&monomial))
    }

    fn gcd_in(&self, other: &Self, variable: &Generator) -> Self {
        let (left_content, right_content) = (self.content(variable), other.content(variable));
        let content = left_content.gcd(&right_content);
        let mut left = self.divide_or_keep(&left_content);
        let mut right = other.divide_or_keep(&right_content);
        if left.degree(variable) < right.degree(variable) {
            std::mem::swap(&mut left, &mut right);
        }
        while !right.is_zero() {
            // Of too large remainders the common divisor stays unknown; that of the coefficients is one, if not the greatest.
            let Some(remainder) = left.pseudo_remainder(&right, variable) else { return content };
            left = right;
            right = remainder.without_content(variable).with_integers();
        }
        // A last non-zero remainder free of the variable means that the primitive parts have no common factor.
        if left.degree(variable) == 0 { content } else { &content * &left }
    }

    /// The greatest common divisor of the coefficients with respect to one variable.
    fn content(&self, variable: &Generator) -> Self {
        self.coefficients(variable).iter().fold(Self::zero(), |divisor, coefficient| divisor.gcd(coefficient))
    }

    /// The polynomial divided by the greatest common divisor of its coefficients with respect to one variable.
    #[must_use]
    pub fn without_content(&self, variable: &Generator) -> Self {
        self.divide_or_keep(&self.content(variable))
    }

    fn divide_or_keep(&self, divisor: &Self) -> Self {
        self.divide_exact(divisor).unwrap_or_else(|| self.clone())
    }

    /// A multiple of this polynomial reduced by `divisor` until its degree in the variable is lower.
    ///
    /// `None` before it would become too large.
    fn pseudo_remainder(&self, divisor: &Self, variable: &Generator) -> Option<Self> {
        let degree = divisor.degree(variable);
        let leading = leading_coefficient(divisor, variable);
        let mut remainder = self.clone();
        while !remainder.is_zero() && remainder.degree(variable) >= degree {
            let shift = Monomial::power(variable, remainder.degree(variable) - degree);
            let factor = &leading_coefficient(&remainder, variable) * &Self::term(Rational::from(1), shift);
            let products = [(&leading, &remainder), (&factor, divisor)];
            if products.iter().any(|(one, other)| one.term_count() * other.term_count() > MOST_PRODUCTS) {
                return None;
            }
            remainder = &(&leading * &remainder) - &(&factor * divisor);
        }
        Some(remainder)
    }
}

/// Subtracts a term, keeping zeros out.
fn subtract(terms: &mut BTreeMap<Monomial, Rational>, monomial: Monomial, value: Rational) {
    match terms.entry(monomial) {
        Entry::Vacant(place) => _ = place.insert(-value),
        Entry::Occupied(mut place) => {
            *place.get_mut() -= value;
            if place.get().is_zero() {
                place.remove();
            }
        }
    }
}

/// The most products of terms in one step of a remainder sequence.
const MOST_PRODUCTS: usize = 100_000;

/// The positive factor that turns rationals, not all zero, into integers without a common factor.
pub(super) fn integer_scale<'r>(values: impl Iterator<Item = &'r Rational>) -> Rational {
    let (divisor, multiple) = values
        .fold((Integer::new(), Integer::from(1)), |(divisor, multiple), value| {
            (divisor.gcd(value.numer()), multiple.lcm(value.denom()))
        });
    if divisor.is_zero() { Rational::from(1) } else { Rational::from((multiple, divisor)) }
}

pub(super) fn square_root_of(value: &Rational) -> Option<Rational> {
    let square =
        !value.is_negative() && value.numer().is_perfect_square() && value.denom().is_perfect_square();
    square.then(|| Rational::from((value.numer().clone().sqrt(), value.denom().clone().sqrt())))
}

fn leading_coefficient(polynomial: &Polynomial, variable: &Generator) -> Polynomial {
    polynomial.coefficients(variable).pop().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A polynomial in x, y and z from a few terms: numbers over 6, and exponents.
    fn polynomial() -> impl Strategy<Value = Polynomial> {
        let term = (-4..=4_i32, prop::array::uniform3(0..=2_u32));
        prop::collection::vec(term, 1..4).prop_map(|terms| {
            let term = |(coefficient, exponents): &(i32, [u32; 3])| {
                let names = ["x", "y", "z"].map(Polynomial::variable);
                let powers = names.iter().zip(exponents).map(|(name, exponent)| name.pow(*exponent));
                powers.fold(Polynomial::constant(Rational::from((*coefficient, 6))), |product, power| {
                    &product * &power
                })
            };
            terms.iter().map(term).fold(Polynomial::zero(), |sum, term| &sum + &term)
        })
    }

    proptest! {
        #[test]
        fn a_product_divided_by_a_factor_is_the_other_one(one in polynomial(), other in polynomial(), more in polynomial()) {
            let product = &one * &other;
            prop_assert_eq!(product.divide_exact(&other), (!other.is_zero()).then_some(one));
            if let Some(quotient) = (&product + &more).divide_exact(&other) {
                prop_assert_eq!(&quotient * &other, &product + &more);
            }
        }

        #[test]
        fn the_greatest_common_divisor_divides_both_and_holds_every_shared_factor(
            shared in polynomial(),
            one in polynomial(),
            other in polynomial(),
        ) {
            let (left, right) = (&shared * &one, &shared * &other);
            let divisor = left.gcd(&right);
            if divisor.is_zero() {
                prop_assert!(left.is_zero() && right.is_zero());
            } else {
                let parts = [&left, &right].map(|product| product.divide_exact(&divisor).expect("it divides both"));
                prop_assert!(shared.is_zero() || divisor.divide_exact(&shared).is_some());
                // Nothing is shared any more.
                prop_assert!(parts[0].gcd(&parts[1]).as_constant().is_some());
                prop_assert_eq!(divisor.clone(), divisor.monic());
                prop_assert_eq!(divisor.leading_term().map(|(_, one)| one.clone()), Some(Rational::from(1)));
            }
        }

        #[test]
        fn a_square_root_is_that_of_its_square(root in polynomial(), more in polynomial()) {
            let found = root.pow(2).square_root();
            prop_assert!(found.as_ref().is_none_or(|found| found.leading_term().is_some_and(|(_, leading)| *leading > 0)));
            prop_assert!(root.is_zero() || found == Some(root.clone()) || found == Some(-&root));
            let changed = &root.pow(2) + &more;
            if let Some(found) = changed.square_root() {
                prop_assert_eq!(found.pow(2), changed);
            }
        }

        #[test]
        fn integer_coefficients_have_the_sign_and_no_common_factor(one in polynomial()) {
            let whole = one.with_integers();
            prop_assert!(whole.terms().all(|(_, value)| value.is_integer()));
            let shared = whole.terms().fold(Integer::new(), |shared, (_, value)| shared.gcd(value.numer()));
            prop_assert!(one.is_zero() || shared == 1);
            prop_assert_eq!(whole.monic(), one.monic());
            prop_assert!(one.is_zero() || (one.leading_term().unwrap().1 > &0) == (whole.leading_term().unwrap().1 > &0));
        }
    }

    #[test]
    fn indivisible_polynomials_have_no_quotient() {
        let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
        assert_eq!((&x.pow(2) + &y).divide_exact(&x), None);
        assert_eq!(x.divide_exact(&Polynomial::zero()), None);
    }

    #[test]
    fn square_roots_are_found_exactly_for_squares() {
        let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
        let root = &(&x + &y.pow(2)) + &Polynomial::one();
        assert_eq!(root.pow(2).square_root(), Some(root.clone()));
        assert_eq!((&root.pow(2) + &x).square_root(), None);
        assert_eq!((&root.pow(2) + &y).square_root(), None);
        assert_eq!((-&root.pow(2)).square_root(), None);
    }

    #[test]
    fn integers_without_a_common_factor() {
        let x = Polynomial::variable("x");
        let fractions = &x.scale(&Rational::from((4, 3))) - &Polynomial::constant(Rational::from((2, 5)));
        assert_eq!(fractions.with_integers().to_string(), "10*x - 3");
    }

    #[test]
    fn coprime_polynomials_have_divisor_one() {
        let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
        assert_eq!((&x + &y).gcd(&(&x - &y)), Polynomial::one());
    }
}
