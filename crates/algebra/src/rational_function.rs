//! Quotients of polynomials over ℚ in lowest terms.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Rational;

use super::division::integer_scale;
use super::size::Extent;
use super::{Expression, Generator, Monomial, Polynomial, Symbol};
use crate::number::Field;

/// numerator/denominator without common factor, the denominator's leading coefficient 1.
///
/// It is a [`Field`], so that every equation written once for numbers can be run on symbols and compared with the paper.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// numerator/denominator in lowest terms; `None` for a zero denominator.
    #[must_use]
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Option<Self> {
        if let Some(value) = denominator.as_constant() {
            return (!value.is_zero()).then(|| numerator.scale(&value.recip()).into());
        }
        let divisor = numerator.gcd(&denominator);
        let numerator = numerator.divide_exact(&divisor)?;
        let denominator = denominator.divide_exact(&divisor)?;
        let (_, leading) = denominator.leading_term()?;
        let scale = Rational::from(leading.recip_ref());
        Some(Self { numerator: numerator.scale(&scale), denominator: denominator.scale(&scale) })
    }

    /// A rational number.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        Polynomial::constant(value).into()
    }

    /// A variable.
    #[must_use]
    pub fn variable(name: impl Into<Symbol>) -> Self {
        Polynomial::variable(name).into()
    }

    /// A variable or function.
    #[must_use]
    pub fn generator(generator: &(impl AsRef<Generator> + ?Sized)) -> Self {
        Polynomial::generator(generator).into()
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator, never zero.
    #[must_use]
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Is it zero?
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Its value, if no variable occurs.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        Some(self.numerator.as_constant()? / self.denominator.as_constant()?)
    }

    /// The variables and functions that it is a quotient in.
    #[must_use]
    pub fn generators(&self) -> BTreeSet<Generator> {
        &self.numerator.generators() | &self.denominator.generators()
    }

    /// The variables that occur, those in the arguments of functions too.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Symbol> {
        &self.numerator.variables() | &self.denominator.variables()
    }

    /// A function in it of this variable, such as `exp(1/V)`; derivatives, degrees and limits do not see it.
    #[must_use]
    pub fn hides(&self, variable: &Symbol) -> Option<Generator> {
        self.generators().into_iter().find(|generator| generator.hides(variable))
    }

    /// The quotient; `None` when `divisor` is zero.
    #[must_use]
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        let (_, leading) = divisor.numerator.leading_term()?;
        let scale = Rational::from(leading.recip_ref());
        let [numerator, denominator] =
            [&divisor.denominator, &divisor.numerator].map(|side| side.scale(&scale));
        Some(self * &Self { numerator, denominator })
    }

    /// A natural power; the power 0 is 1.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        // Powers of coprime polynomials are coprime.
        Self { numerator: self.numerator.pow(exponent), denominator: self.denominator.pow(exponent) }
    }

    /// The partial derivative; functions count as constants.
    #[must_use]
    pub fn derivative(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> Self {
        let numerator = &(&self.numerator.derivative(variable) * &self.denominator)
            - &(&self.numerator * &self.denominator.derivative(variable));
        reduced(numerator, self.denominator.pow(2))
    }
}

/// The quotient in lowest terms of a denominator known to be non-zero: a product of denominators.
fn reduced(numerator: Polynomial, denominator: Polynomial) -> RationalFunction {
    RationalFunction::new(numerator, denominator).unwrap_or_else(|| Polynomial::zero().into())
}

impl RationalFunction {
    /// The sum, where `allows` permits the size that numerator and denominator may come to.
    ///
    /// # Errors
    /// What `allows` says.
    pub(super) fn checked_sum<E>(
        &self,
        other: &Self,
        allows: impl Fn(Extent) -> Result<(), E>,
    ) -> Result<Self, E> {
        // Knuth, The art of computer programming, 4.5.1: with g the common divisor of the denominators, only a divisor of g cancels.
        let [left, right, shared] = cancelled(&self.denominator, &other.denominator);
        let crossed = Extent::of_product(&self.numerator, &right);
        allows(crossed.plus(Extent::of_product(&other.numerator, &left)))?;
        allows(Extent::of_product(&left, &other.denominator))?;
        let numerator = &(&self.numerator * &right) + &(&other.numerator * &left);
        if numerator.is_zero() {
            return Ok(numerator.into());
        }
        let [numerator, rest, _] = cancelled(&numerator, &shared);
        Ok(Self { numerator: numerator.into_owned(), denominator: &(&*left * &right) * &rest })
    }
}

/// Both divided by their greatest common divisor, and this divisor. The second one and the divisor have the leading coefficient 1.
fn cancelled<'p>(one: &'p Polynomial, other: &'p Polynomial) -> [Cow<'p, Polynomial>; 3] {
    let unit = || Cow::Owned(Polynomial::one());
    if one.as_constant().is_some() || other.as_constant().is_some() {
        return [Cow::Borrowed(one), Cow::Borrowed(other), unit()];
    }
    if one == other {
        return [unit(), unit(), Cow::Borrowed(one)];
    }
    let divisor = one.gcd(other);
    match (one.divide_exact(&divisor), other.divide_exact(&divisor)) {
        (Some(one), Some(other)) => [Cow::Owned(one), Cow::Owned(other), Cow::Owned(divisor)],
        _ => [Cow::Borrowed(one), Cow::Borrowed(other), unit()],
    }
}

impl From<Polynomial> for RationalFunction {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

impl From<i32> for RationalFunction {
    fn from(value: i32) -> Self {
        Self::constant(Rational::from(value))
    }
}

impl Add<&RationalFunction> for &RationalFunction {
    type Output = RationalFunction;

    fn add(self, other: &RationalFunction) -> RationalFunction {
        let sum: Result<_, Infallible> = self.checked_sum(other, |_| Ok(()));
        sum.unwrap_or_else(|never| match never {})
    }
}

impl Neg for RationalFunction {
    type Output = Self;

    fn neg(self) -> Self {
        Self { numerator: -&self.numerator, denominator: self.denominator }
    }
}

impl Sub<&RationalFunction> for &RationalFunction {
    type Output = RationalFunction;

    fn sub(self, other: &RationalFunction) -> RationalFunction {
        self + &-other.clone()
    }
}

impl Mul<&RationalFunction> for &RationalFunction {
    type Output = RationalFunction;

    fn mul(self, other: &RationalFunction) -> RationalFunction {
        if self.is_zero() || other.is_zero() {
            return Polynomial::zero().into();
        }
        // Each side is in lowest terms, so that a numerator shares factors with the other side's denominator only.
        let [left, right_divisor, _] = cancelled(&self.numerator, &other.denominator);
        let [right, left_divisor, _] = cancelled(&other.numerator, &self.denominator);
        RationalFunction { numerator: &*left * &right, denominator: &*left_divisor * &right_divisor }
    }
}

impl Div<&RationalFunction> for &RationalFunction {
    type Output = RationalFunction;

    /// # Panics
    /// On division by zero, like the rationals; [`RationalFunction::checked_div`] answers `None` instead.
    fn div(self, other: &RationalFunction) -> RationalFunction {
        self.checked_div(other).unwrap_or_else(|| panic!("division of a rational function by zero"))
    }
}

macro_rules! owned_operators {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for RationalFunction {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                (&self).$method(&other)
            }
        }

        impl $trait<&RationalFunction> for RationalFunction {
            type Output = Self;

            fn $method(self, other: &Self) -> Self {
                (&self).$method(other)
            }
        }
    )*};
}

owned_operators!(Add add, Sub sub, Mul mul, Div div);

impl Field for RationalFunction {}

/// The exact value at a point, unless a variable is missing or the denominator vanishes.
pub(super) fn evaluate(function: &RationalFunction, point: &BTreeMap<Symbol, Rational>) -> Option<Rational> {
    let denominator = function.denominator().evaluate(point)?;
    if denominator.is_zero() { None } else { Some(function.numerator().evaluate(point)? / denominator) }
}

impl From<&Polynomial> for Expression {
    fn from(polynomial: &Polynomial) -> Self {
        let term = |(monomial, coefficient): (&Monomial, &Rational)| {
            let size = monomial.factors().fold(
                Self::Number(coefficient.clone().abs()),
                |product, (name, exponent)| {
                    // Exponents here stay far below i32's limit: they come from equations of a dozen terms.
                    product * Self::from(name).power(*exponent as i32)
                },
            );
            if coefficient.is_negative() { -size } else { size }
        };
        polynomial.terms().rev().map(term).fold(Self::integer(0), Add::add)
    }
}

impl From<&RationalFunction> for Expression {
    fn from(function: &RationalFunction) -> Self {
        let both = [function.numerator(), function.denominator()];
        let scale =
            integer_scale(both.iter().flat_map(|side| side.terms().map(|(_, coefficient)| coefficient)));
        let [numerator, denominator] = both.map(|side| Self::from(&side.scale(&scale)));
        numerator / denominator
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Quotients of small polynomials in x and y.
    fn quotient() -> impl Strategy<Value = RationalFunction> {
        let term = (-3..=3_i32, prop::array::uniform2(0..=2_u32));
        let polynomial = prop::collection::vec(term, 1..4).prop_map(|terms| {
            terms.iter().fold(Polynomial::zero(), |sum, (coefficient, [first, second])| {
                let powers = &Polynomial::variable("x").pow(*first) * &Polynomial::variable("y").pow(*second);
                &sum + &powers.scale(&Rational::from((*coefficient, 2)))
            })
        });
        let quotient = (polynomial.clone(), polynomial);
        quotient.prop_filter_map("a divisor", |(one, other)| RationalFunction::new(one, other))
    }

    proptest! {
        #[test]
        fn sums_products_and_quotients_are_those_of_cross_multiplication(one in quotient(), other in quotient()) {
            let [(n, d), (m, e)] = [&one, &other].map(|side| (side.numerator(), side.denominator()));
            prop_assert_eq!(Some(&one + &other), RationalFunction::new(&(n * e) + &(m * d), d * e));
            prop_assert_eq!(Some(&one - &other), RationalFunction::new(&(n * e) - &(m * d), d * e));
            prop_assert_eq!(Some(&one * &other), RationalFunction::new(n * m, d * e));
            prop_assert_eq!(one.checked_div(&other), RationalFunction::new(n * e, d * m));
        }
    }

    #[test]
    fn common_factors_cancel() {
        let (x, y) = (RationalFunction::variable("x"), RationalFunction::variable("y"));
        let quotient = (x.square() - y.square()) / (x.clone() - &y);
        assert_eq!(quotient, x.clone() + &y);
        assert_eq!((x.clone() / (x + &y)).variables(), ["x", "y"].map(Symbol::from).into());
    }

    #[test]
    fn derivative_of_a_reciprocal() {
        let x = RationalFunction::variable("x");
        let reciprocal = RationalFunction::from(1) / &x;
        assert_eq!(reciprocal.derivative(&Symbol::from("x")), RationalFunction::from(-1) / x.square());
    }

    #[test]
    fn no_quotient_by_zero() {
        let x = RationalFunction::variable("x");
        assert_eq!(x.checked_div(&(x.clone() - &x)), None);
    }
}
