//! Quotients of polynomials over ℚ in lowest terms.

use std::collections::BTreeSet;
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::Rational;

use super::{Generator, Polynomial, Symbol};
use crate::number::Field;

/// numerator/denominator without common factor, the denominator's leading coefficient 1.
///
/// It is a [`Field`], so that every equation written once for numbers can be run on symbols and compared with the paper.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// numerator/denominator in lowest terms; `None` for a zero denominator.
    #[must_use]
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Option<Self> {
        if denominator.is_zero() {
            return None;
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
        Self::new(&self.numerator * &divisor.denominator, &self.denominator * &divisor.numerator)
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

    /// +1 or −1 when coefficients of one sign decide its sign for positive variables; `None` otherwise.
    #[must_use]
    pub fn coefficient_sign(&self) -> Option<i8> {
        Some(self.numerator.coefficient_sign()? * self.denominator.coefficient_sign()?)
    }
}

/// The quotient in lowest terms of a denominator known to be non-zero: a product of denominators.
fn reduced(numerator: Polynomial, denominator: Polynomial) -> RationalFunction {
    RationalFunction::new(numerator, denominator).unwrap_or_else(|| Polynomial::zero().into())
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
        let numerator = &(&self.numerator * &other.denominator) + &(&other.numerator * &self.denominator);
        reduced(numerator, &self.denominator * &other.denominator)
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
        reduced(&self.numerator * &other.numerator, &self.denominator * &other.denominator)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_factors_cancel() {
        let (x, y) = (RationalFunction::variable("x"), RationalFunction::variable("y"));
        let quotient = (x.square() - y.square()) / (x.clone() - &y);
        assert_eq!(quotient, x + &y);
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
