//! Polynomials in one variable over the rationals: ring operations, division, greatest common divisor.

use rug::Rational;

use crate::division::integer_scale;
use crate::number::Field;

/// A polynomial over ℚ by ascending power; the leading coefficient is not zero (the zero polynomial has none).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnivariatePolynomial {
    coefficients: Vec<Rational>,
}

impl UnivariatePolynomial {
    /// The polynomial with these coefficients, by ascending power; zeros at the end are dropped.
    #[must_use]
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(|last| *last == 0) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The polynomial with these small integer coefficients, by ascending power.
    #[must_use]
    pub fn from_integers(coefficients: &[i64]) -> Self {
        Self::new(coefficients.iter().map(|value| Rational::from(*value)).collect())
    }

    /// The polynomial of least degree with these values at 0, 1, 2, … (Newton's forward differences).
    #[must_use]
    pub fn interpolating(mut values: Vec<Rational>) -> Self {
        let mut sum = Self::new(Vec::new());
        let mut basis = Self::from_integers(&[1]);
        for step in 0_i64.. {
            let Some(first) = values.first() else { break };
            sum = sum.plus(&basis.scaled(first));
            values = values.windows(2).map(|pair| Rational::from(&pair[1] - &pair[0])).collect();
            // (x − step)/(step + 1) turns C(x, step) into C(x, step + 1).
            let next = Self::new(vec![Rational::from((-step, step + 1)), Rational::from((1, step + 1))]);
            basis = basis.times(&next);
        }
        sum
    }

    /// The coefficients by ascending power.
    #[must_use]
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// The degree; none for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// Whether every coefficient is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at a rational, exactly.
    #[must_use]
    pub fn evaluate(&self, x: &Rational) -> Rational {
        self.evaluate_with(x, Rational::clone)
    }

    /// The value at a number of any type, by Horner's rule; `convert` brings the coefficients into that type.
    #[must_use]
    pub fn evaluate_with<R: Field>(&self, x: &R, convert: impl Fn(&Rational) -> R) -> R {
        let descending = self.coefficients.iter().rev().map(convert);
        descending.reduce(|value, coefficient| value * x + coefficient).unwrap_or_else(|| R::from(0))
    }

    /// The sum of two polynomials.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let length = self.coefficients.len().max(other.coefficients.len());
        let at = |p: &Self, power: usize| p.coefficients.get(power).cloned().unwrap_or_default();
        Self::new((0..length).map(|power| at(self, power) + at(other, power)).collect())
    }

    /// The product of two polynomials.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::new(Vec::new());
        }
        let mut product = vec![Rational::new(); self.coefficients.len() + other.coefficients.len() - 1];
        for (i, left) in self.coefficients.iter().enumerate() {
            for (j, right) in other.coefficients.iter().enumerate() {
                product[i + j] += Rational::from(left * right);
            }
        }
        Self::new(product)
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        Self::new(self.coefficients.iter().map(|value| Rational::from(value * factor)).collect())
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let powers = 1_u32..;
        Self::new(self.coefficients.iter().skip(1).zip(powers).map(|(c, power)| c.clone() * power).collect())
    }

    /// Quotient and remainder of the division by `divisor`; dividing by zero leaves everything in the remainder.
    #[must_use]
    pub fn divided_by(&self, divisor: &Self) -> (Self, Self) {
        let Some(leading) = divisor.coefficients.last() else {
            return (Self::new(Vec::new()), self.clone());
        };
        let mut remainder = self.coefficients.clone();
        let steps = (remainder.len() + 1).saturating_sub(divisor.coefficients.len());
        let mut quotient = vec![Rational::new(); steps];
        for shift in (0..steps).rev() {
            let factor = Rational::from(&remainder[shift + divisor.coefficients.len() - 1] / leading);
            for (offset, coefficient) in divisor.coefficients.iter().enumerate() {
                remainder[shift + offset] -= Rational::from(coefficient * &factor);
            }
            quotient[shift] = factor;
        }
        (Self::new(quotient), Self::new(remainder))
    }

    /// The greatest common divisor, with leading coefficient 1 (zero only when both are zero).
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut larger, mut smaller) = (self.clone(), other.clone());
        while !smaller.is_zero() {
            // Primitive parts keep the coefficients from growing at every division.
            let remainder = larger.divided_by(&smaller).1.primitive();
            (larger, smaller) = (smaller, remainder);
        }
        larger.monic()
    }

    /// The polynomial with the same roots, each of them simple.
    #[must_use]
    pub fn squarefree(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        if repeated.degree().unwrap_or(0) == 0 { self.clone() } else { self.divided_by(&repeated).0 }
    }

    /// The polynomial divided by its leading coefficient.
    #[must_use]
    pub fn monic(&self) -> Self {
        self.coefficients.last().map_or_else(|| self.clone(), |leading| self.scaled(&leading.clone().recip()))
    }

    /// A positive multiple of the polynomial whose coefficients are integers without a common factor.
    #[must_use]
    pub fn primitive(&self) -> Self {
        self.scaled(&integer_scale(self.coefficients.iter()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> UnivariatePolynomial {
        UnivariatePolynomial::from_integers(coefficients)
    }

    #[test]
    fn division_leaves_a_remainder_of_lower_degree() {
        let dividend = polynomial(&[1, -2, 0, 3, 5]);
        let divisor = polynomial(&[7, 0, 2]);
        let (quotient, remainder) = dividend.divided_by(&divisor);
        assert_eq!(quotient.times(&divisor).plus(&remainder), dividend);
        assert!(remainder.degree() < divisor.degree());
        assert_eq!(divisor.divided_by(&dividend), (polynomial(&[]), divisor));
    }

    #[test]
    fn the_gcd_is_the_common_factor() {
        let common = polynomial(&[-3, 1]).times(&polynomial(&[1, 1, 1]));
        let left = common.times(&polynomial(&[5, 2]));
        let right = common.times(&polynomial(&[1, 0, 4]));
        assert_eq!(left.gcd(&right), common);
    }

    #[test]
    fn the_squarefree_part_has_every_root_once() {
        let (double, triple) = (polynomial(&[-1, 2]), polynomial(&[3, 1]));
        let product = double.times(&double).times(&triple).times(&triple).times(&triple);
        assert_eq!(product.squarefree().monic(), double.times(&triple).monic());
    }

    #[test]
    fn interpolation_gives_back_a_polynomial_from_its_values() {
        let p = polynomial(&[3, 0, -7, 2, 5]);
        let values = (0..=4).map(|x| p.evaluate(&Rational::from(x))).collect();
        assert_eq!(UnivariatePolynomial::interpolating(values), p);
    }

    #[test]
    fn the_primitive_part_keeps_the_sign() {
        let fractions = UnivariatePolynomial::new(vec![Rational::from((-4, 3)), Rational::from((2, 5))]);
        assert_eq!(fractions.primitive(), polynomial(&[-10, 3]));
    }

    #[test]
    fn derivatives_are_taken_term_by_term() {
        assert_eq!(polynomial(&[1, 2, 3]).derivative(), polynomial(&[2, 6]));
    }
}
