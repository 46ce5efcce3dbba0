//! Truncated power series in one variable, with rational functions of other variables as coefficients.

use super::{Expression, Polynomial, RationalFunction, Symbol};

/// Σ c_k·x^k for k below the number of coefficients; everything from there on is cut off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Series(Vec<RationalFunction>);

impl Series {
    /// The series of these coefficients, by ascending power.
    #[must_use]
    pub fn new(coefficients: Vec<RationalFunction>) -> Self {
        Self(coefficients)
    }

    /// A constant, to this many coefficients.
    #[must_use]
    pub fn constant(value: RationalFunction, length: usize) -> Self {
        let zeros = std::iter::repeat_with(|| RationalFunction::from(0));
        Self([value].into_iter().chain(zeros).take(length).collect())
    }

    /// The variable itself, to this many coefficients.
    #[must_use]
    pub fn variable(length: usize) -> Self {
        let coefficient = |power: usize| RationalFunction::from(i32::from(power == 1));
        Self((0..length).map(coefficient).collect())
    }

    /// The coefficients, by ascending power.
    #[must_use]
    pub fn coefficients(&self) -> &[RationalFunction] {
        &self.0
    }

    /// Σ `coefficients[k]`·variable^k as an expression, zero terms left out.
    #[must_use]
    pub fn expression(coefficients: &[Expression], variable: &Expression) -> Expression {
        let term =
            |(power, value): (usize, &Expression)| value.clone() * variable.clone().power(power as i32);
        coefficients.iter().enumerate().map(term).fold(Expression::integer(0), |sum, part| sum + part)
    }

    /// The sum, cut to the shorter length.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(left, right)| left + right).collect())
    }

    /// The product, cut to the shorter length.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let length = self.0.len().min(other.0.len());
        let coefficient =
            |power: usize| sum((0..=power).map(|split| &self.0[split] * &other.0[power - split]));
        Self((0..length).map(coefficient).collect())
    }

    /// A polynomial with series put in the place of two variables; other variables stay as they are.
    #[must_use]
    pub fn of_polynomial(polynomial: &Polynomial, places: [(&Symbol, &Self); 2]) -> Self {
        let length = places[0].1.0.len().min(places[1].1.0.len());
        let horner = |coefficients: Vec<Self>, value: &Self| {
            let zero = Self::constant(RationalFunction::from(0), length);
            coefficients.into_iter().rev().fold(zero, |sum, coefficient| sum.times(value).plus(&coefficient))
        };
        let inner = |outer: Polynomial| {
            let constants = outer.coefficients(places[1].0).into_iter();
            horner(constants.map(|value| Self::constant(value.into(), length)).collect(), places[1].1)
        };
        horner(polynomial.coefficients(places[0].0).into_iter().map(inner).collect(), places[0].1)
    }

    /// The series y(x) with y(0) = `start` that solves relation(x, y) = 0, to `length` coefficients.
    ///
    /// `None` when `start` is not a single root of relation(0, y): then y is no power series, or not the only one.
    #[must_use]
    pub fn implicit(
        relation: &Polynomial,
        variable: &Symbol,
        unknown: &Symbol,
        start: RationalFunction,
        length: usize,
    ) -> Option<Self> {
        let mut series = Self::constant(start, length);
        let slope = series.slope(relation, variable, unknown)?;
        let x = Self::variable(length);
        for power in 0..length {
            let rest = Self::of_polynomial(relation, [(variable, &x), (unknown, &series)]);
            let defect = rest.0.get(power)?;
            if power == 0 && !defect.is_zero() {
                return None;
            }
            // Newton's step changes one coefficient at a time, because y's others already solve the lower orders.
            series.0[power] = &series.0[power] - &defect.checked_div(&slope)?;
        }
        Some(series)
    }

    /// ∂relation/∂y at x = 0, y = y(0), if it is not zero.
    fn slope(&self, relation: &Polynomial, variable: &Symbol, unknown: &Symbol) -> Option<RationalFunction> {
        let at_zero = relation.derivative(unknown).coefficients(variable).swap_remove(0);
        let start = Self::constant(self.0.first()?.clone(), 1);
        let zero = Self::constant(RationalFunction::from(0), 1);
        let slope = Self::of_polynomial(&at_zero, [(variable, &zero), (unknown, &start)]);
        slope.0.into_iter().next().filter(|value| !value.is_zero())
    }

    /// The first non-zero coefficient of relation(x, y(x)) within this length, zero when there is none; `None` when
    /// the root at x = 0 is not single.
    pub(super) fn residual(
        &self,
        relation: &Polynomial,
        variable: &Symbol,
        unknown: &Symbol,
    ) -> Option<RationalFunction> {
        self.slope(relation, variable, unknown)?;
        let x = Self::variable(self.0.len());
        let rest = Self::of_polynomial(relation, [(variable, &x), (unknown, self)]);
        Some(rest.0.into_iter().find(|value| !value.is_zero()).unwrap_or_else(|| RationalFunction::from(0)))
    }

    /// 1/series; `None` when it begins with zero.
    #[must_use]
    pub fn reciprocal(&self) -> Option<Self> {
        let first = RationalFunction::from(1).checked_div(self.0.first()?)?;
        let mut inverse = vec![first.clone()];
        for power in 1..self.0.len() {
            let terms = (1..=power).map(|split| &self.0[split] * &inverse[power - split]);
            inverse.push(-(sum(terms) * &first));
        }
        Some(Self(inverse))
    }

    /// The square root that begins with 1; `None` when the series does not begin with 1.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        if self.0.first()?.as_constant()? != 1 {
            return None;
        }
        let mut root = vec![RationalFunction::from(1)];
        for power in 1..self.0.len() {
            let cross = (1..power).map(|split| &root[split] * &root[power - split]);
            let rest = &self.0[power] - &sum(cross);
            root.push(rest / RationalFunction::from(2));
        }
        Some(Self(root))
    }
}

fn sum(terms: impl Iterator<Item = RationalFunction>) -> RationalFunction {
    terms.fold(RationalFunction::from(0), |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;
    use crate::UnivariatePolynomial;

    fn numbers(values: &[i32]) -> Series {
        Series::new(values.iter().map(|value| RationalFunction::from(*value)).collect())
    }

    #[test]
    fn geometric_series_is_the_reciprocal() {
        assert_eq!(numbers(&[1, -1, 0, 0]).reciprocal(), Some(numbers(&[1, 1, 1, 1])));
        assert_eq!(numbers(&[0, 1]).reciprocal(), None);
    }

    #[test]
    fn square_of_the_square_root_returns() {
        let series = numbers(&[1, 3, -2, 5]);
        let root = series.square_root().expect("begins with 1");
        assert_eq!(root.times(&root), series);
    }

    #[test]
    fn implicit_root_of_a_quadratic() {
        // y² = 1 + x: y = 1 + x/2 − x²/8 + …
        let (x, y) = (Symbol::from("x"), Symbol::from("y"));
        let relation = &(&Polynomial::variable("y").pow(2) - &Polynomial::one()) - &Polynomial::variable("x");
        let series = Series::implicit(&relation, &x, &y, RationalFunction::from(1), 3).expect("single root");
        let eighth = RationalFunction::from(1) / RationalFunction::from(8);
        assert_eq!(series.coefficients()[2], -eighth);
        assert_eq!(Series::implicit(&relation, &x, &y, RationalFunction::from(2), 3), None);
    }

    #[test]
    fn double_roots_have_no_unique_series() {
        let (x, y) = (Symbol::from("x"), Symbol::from("y"));
        let relation = &Polynomial::variable("y").pow(2) - &Polynomial::variable("x");
        assert_eq!(Series::implicit(&relation, &x, &y, RationalFunction::from(0), 3), None);
    }

    proptest! {
        #[test]
        fn sums_products_and_values_are_those_of_polynomials(
            one in prop::collection::vec(-4..5, 1..6), other in prop::collection::vec(-4..5, 1..6), at in -3_i32..4
        ) {
            let length = one.len().min(other.len());
            let whole = |values: &[i32]| UnivariatePolynomial::new(values.iter().map(|value| Rational::from(*value)).collect());
            let cut = |polynomial: UnivariatePolynomial| {
                let all = polynomial.coefficients().iter().cloned().chain(std::iter::repeat_with(Rational::new));
                Series::new(all.take(length).map(RationalFunction::constant).collect())
            };
            prop_assert_eq!(numbers(&one).plus(&numbers(&other)), cut(whole(&one).plus(&whole(&other))));
            prop_assert_eq!(numbers(&one).times(&numbers(&other)), cut(whole(&one).times(&whole(&other))));
            let written: Vec<Expression> = one.iter().map(|value| Expression::integer(*value)).collect();
            let value = Series::expression(&written, &Expression::variable("x")).rational_value(&[(Symbol::from("x"), Rational::from(at))].into());
            prop_assert!(value == Some(whole(&one).evaluate(&at.into())) || at == 0);
            if let Some(inverse) = numbers(&one).reciprocal() {
                prop_assert_eq!(numbers(&one).times(&inverse), Series::constant(RationalFunction::from(1), one.len()));
            }
        }

        /// The series of a root makes its relation zero, a changed coefficient does not, and a root that is not single has none.
        #[test]
        fn a_series_solves_its_relation(factors in prop::collection::vec(-2_i32..3, 9), start in -2_i32..3, length in 1..5_usize, changed in 0..5_usize) {
            let (x, y) = (Symbol::from("x"), Symbol::from("y"));
            let term = |(at, factor): (u32, &i32)| {
                let powers = &Polynomial::variable("x").pow(at / 3) * &Polynomial::variable("y").pow(at % 3);
                powers.scale(&(*factor).into())
            };
            let relation = (0..).zip(&factors).map(term).fold(Polynomial::zero(), |sum, term| &sum + &term);
            let at_start = |polynomial: &Polynomial| polynomial.evaluate(&[(x.clone(), Rational::new()), (y.clone(), Rational::from(start))].into()).expect("numbers");
            let relation = &relation - &Polynomial::constant(at_start(&relation));
            let slope = at_start(&relation.derivative(&y));
            let found = Series::implicit(&relation, &x, &y, start.into(), length);
            prop_assert_eq!(found.is_some(), !slope.is_zero());
            if let Some(mut series) = found {
                let zero = RationalFunction::from(0);
                prop_assert_eq!(series.residual(&relation, &x, &y), Some(zero.clone()));
                prop_assert_eq!(&series.coefficients()[0], &RationalFunction::from(start));
                let place = changed % length;
                series.0[place] = &series.0[place] + &RationalFunction::from(7);
                prop_assert!(place == 0 || series.residual(&relation, &x, &y) != Some(zero));
            }
        }
    }
}
