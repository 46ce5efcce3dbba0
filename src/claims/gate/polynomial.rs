//! Polynomials with rational coefficients in one variable, for roots that discs alone leave open.

use slipmode_core::number::Rational;

use super::number::Number;

/// Coefficients by ascending power, the last one not zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Exact(Vec<Rational>);

impl Exact {
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub fn numbers(&self) -> Vec<Number> {
        self.0.iter().cloned().map(Number::Exact).collect()
    }

    fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The quotient and the rest of a division.
    fn divided(&self, divisor: &Self) -> (Self, Self) {
        let mut rest = self.0.clone();
        let mut quotient = vec![Rational::new(); (self.0.len() + 1).saturating_sub(divisor.0.len())];
        if let Some(leading) = divisor.0.last() {
            for shift in (0..quotient.len()).rev() {
                let factor = Rational::from(&rest[shift + divisor.degree()] / leading);
                for (at, coefficient) in divisor.0.iter().enumerate() {
                    rest[shift + at] -= Rational::from(coefficient * &factor);
                }
                quotient[shift] = factor;
            }
        }
        (Self::new(quotient), Self::new(rest))
    }

    /// The greatest common divisor, with 1 as its leading coefficient.
    fn common(&self, other: &Self) -> Self {
        let (mut one, mut two) = (self.clone(), other.clone());
        while !two.is_zero() {
            (one, two) = (two.clone(), one.divided(&two).1);
        }
        let leading = one.0.last().cloned().unwrap_or_else(|| Rational::from(1));
        Self(one.0.into_iter().map(|coefficient| coefficient / &leading).collect())
    }

    /// Each root once.
    pub fn squarefree(&self) -> Self {
        let slope = self.0.iter().zip(0_u32..).skip(1);
        let slope = slope.map(|(coefficient, power)| Rational::from(coefficient * power));
        let repeated = self.common(&Self::new(slope.collect()));
        if repeated.degree() == 0 { self.clone() } else { self.divided(&repeated).0 }
    }

    /// Whether 0 is a root, and the polynomial without this root. Each root occurs once.
    pub fn without_zero(&self) -> (bool, Self) {
        match self.0.split_first() {
            Some((first, rest)) if first.is_zero() => (true, Self(rest.to_vec())),
            _ => (false, self.clone()),
        }
    }

    /// The polynomial of the squares of those roots whose opposites are roots too, and the polynomial without them. Each root occurs
    /// once, and 0 is none.
    pub fn without_opposite_roots(&self) -> (Self, Self) {
        // P(s) = A(s²) + s·B(s²): s and −s are roots where A and B vanish at s².
        let part = |start: usize| Self::new(self.0.iter().skip(start).step_by(2).cloned().collect());
        let squares = part(0).common(&part(1));
        if squares.degree() == 0 {
            return (squares, self.clone());
        }
        let mut in_squares = Vec::new();
        for coefficient in &squares.0 {
            in_squares.extend([coefficient.clone(), Rational::new()]);
        }
        let rest = self.divided(&Self::new(in_squares)).0;
        (squares, rest)
    }
}
