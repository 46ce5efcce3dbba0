//! Sparse polynomials over ℚ in any number of variables and functions.

use std::collections::{BTreeMap, BTreeSet};

use rug::Rational;
use rug::ops::Pow;

use super::{Expression, Generator, Monomial, Symbol};

/// A polynomial over ℚ: a sum of rational coefficients times monomials, none of them zero.
///
/// The terms are in ascending order of their monomials.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial(Vec<(Monomial, Rational)>);

impl Polynomial {
    /// The zero polynomial.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// The constant 1.
    #[must_use]
    pub fn one() -> Self {
        Self::constant(Rational::from(1))
    }

    /// A constant.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        Self::term(value, Monomial::one())
    }

    /// The polynomial that is one variable.
    #[must_use]
    pub fn variable(name: impl Into<Symbol>) -> Self {
        Self::generator(&name.into())
    }

    /// The polynomial that is one variable or function.
    #[must_use]
    pub fn generator(generator: &(impl AsRef<Generator> + ?Sized)) -> Self {
        Self::term(Rational::from(1), Monomial::power(generator, 1))
    }

    /// coefficient · monomial.
    #[must_use]
    pub fn term(coefficient: Rational, monomial: Monomial) -> Self {
        if coefficient.is_zero() { Self::zero() } else { Self(vec![(monomial, coefficient)]) }
    }

    /// The polynomial of these terms, whose monomials ascend and whose coefficients are not zero.
    pub(super) fn of_ascending(terms: Vec<(Monomial, Rational)>) -> Self {
        debug_assert!(terms.is_sorted_by(|(lighter, _), (heavier, _)| lighter < heavier));
        Self(terms)
    }

    /// Adds coefficient · monomial in place, keeping zeros out.
    pub(super) fn add_term(&mut self, monomial: &Monomial, coefficient: &Rational) {
        match self.0.binary_search_by(|(own, _)| own.cmp(monomial)) {
            Ok(place) => {
                self.0[place].1 += coefficient;
                if self.0[place].1.is_zero() {
                    self.0.remove(place);
                }
            }
            Err(_) if coefficient.is_zero() => {}
            Err(place) => self.0.insert(place, (monomial.clone(), coefficient.clone())),
        }
    }

    /// Monomials and their coefficients, lightest monomial first.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.0.iter().map(|(monomial, coefficient)| (monomial, coefficient))
    }

    /// The number of terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.0.len()
    }

    /// Is it the zero polynomial?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Its value, if no variable occurs.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match self.0.as_slice() {
            [] => Some(Rational::new()),
            [(monomial, value)] if *monomial == Monomial::one() => Some(value.clone()),
            _ => None,
        }
    }

    /// The heaviest term, if there is any.
    pub(crate) fn leading_term(&self) -> Option<(&Monomial, &Rational)> {
        self.0.last().map(|(monomial, coefficient)| (monomial, coefficient))
    }

    /// The variables and functions that it is a polynomial in, in alphabetical order.
    #[must_use]
    pub fn generators(&self) -> BTreeSet<Generator> {
        self.terms().flat_map(|(monomial, _)| monomial.factors().map(|(name, _)| name.clone())).collect()
    }

    /// The variables that occur, those in the arguments of functions too, in alphabetical order.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Symbol> {
        self.generators().iter().flat_map(Generator::variables).collect()
    }

    /// The degree in one variable; 0 for the zero polynomial.
    #[must_use]
    pub fn degree(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> u32 {
        self.terms().map(|(monomial, _)| monomial.exponent(variable)).max().unwrap_or(0)
    }

    /// The highest degree of a term in all variables together; 0 for the zero polynomial.
    pub(crate) fn total_degree(&self) -> u32 {
        let degree = |(monomial, _): &(Monomial, Rational)| {
            monomial.factors().map(|(_, exponent)| exponent).sum::<u32>()
        };
        self.0.iter().map(degree).max().unwrap_or(0)
    }

    /// The coefficients as polynomials in the other variables, by ascending power of `variable` (at least one).
    #[must_use]
    pub fn coefficients(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> Vec<Self> {
        let mut coefficients = vec![Self::zero(); self.degree(variable) as usize + 1];
        for (monomial, coefficient) in &self.0 {
            let power = monomial.exponent(variable) as usize;
            coefficients[power].add_term(&monomial.without(variable), coefficient);
        }
        coefficients
    }

    /// The partial derivative; functions count as constants ([`super::RationalFunction::hides`] names them).
    #[must_use]
    pub fn derivative(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> Self {
        let mut derivative = Self::zero();
        for (monomial, coefficient) in &self.0 {
            let exponent = monomial.exponent(variable);
            if let Some(lowered) = monomial.divided_by(&Monomial::power(variable, 1)) {
                derivative.add_term(&lowered, &Rational::from(coefficient * exponent));
            }
        }
        derivative
    }

    /// This polynomial with another one put in the place of a variable (Horner's rule).
    #[must_use]
    pub fn substitute(&self, variable: &(impl AsRef<Generator> + ?Sized), value: &Self) -> Self {
        if self.degree(variable) == 0 {
            return self.clone();
        }
        self.coefficients(variable)
            .into_iter()
            .rev()
            .fold(Self::zero(), |sum, coefficient| &(&sum * value) + &coefficient)
    }

    /// The exact value at a rational point; `None` when a variable has no value, or a function no rational one.
    #[must_use]
    pub fn evaluate(&self, point: &BTreeMap<Symbol, Rational>) -> Option<Rational> {
        let mut sum = Rational::new();
        for (monomial, coefficient) in &self.0 {
            let mut term = coefficient.clone();
            for (name, exponent) in monomial.factors() {
                let value = match point.get(name) {
                    Some(value) => value.clone(),
                    None => Expression::from(name).rational_value(point)?,
                };
                term *= value.pow(*exponent);
            }
            sum += term;
        }
        Some(sum)
    }

    /// The polynomial to a natural power.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::one(), |product, _| &product * self)
    }

    /// The polynomial times a rational number.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        let scaled =
            |(monomial, value): &(Monomial, Rational)| (monomial.clone(), Rational::from(value * factor));
        Self(self.0.iter().map(scaled).collect())
    }

    /// +1 when every coefficient is positive, −1 when every one is negative, `None` otherwise (and for zero).
    ///
    /// With positive variables this is the polynomial's sign: the certificate behind every inequality here.
    pub(crate) fn coefficient_sign(&self) -> Option<i8> {
        let positive = self.terms().filter(|(_, value)| value.is_positive()).count();
        match positive {
            _ if self.is_zero() => None,
            0 => Some(-1),
            count if count == self.term_count() => Some(1),
            _ => None,
        }
    }
}
