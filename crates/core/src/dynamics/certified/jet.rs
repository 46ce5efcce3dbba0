//! Polynomials in two small deviations, with interval coefficients: a function of (x, y) with its partial derivatives.

use std::ops::{Add, Mul, Neg, Sub};

use super::interval::Interval;
use super::linear::worse;

/// The degree of a polynomial, and the number of its coefficients.
pub(super) const DEGREE: usize = super::slow::CORRECTIONS + 2;
const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;

/// The place of the coefficient of δx^i δy^j.
pub(super) const fn place(i: usize, j: usize) -> usize {
    (i + j) * (i + j + 1) / 2 + j
}

/// The exponents (i, j) of the coefficients of degree 0 … d, in their order.
pub(super) fn exponents(degree: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=degree).flat_map(|total| (0..=total).map(move |j| (total - j, j)))
}

/// 1/n!, enclosed.
pub(super) fn inverse_factorial(n: usize) -> Interval {
    Interval::point((1..=n).product::<usize>() as f64).reciprocal()
}

/// (−1)^n/n! times a number.
fn alternating(value: Interval, n: usize) -> Interval {
    let size = value * inverse_factorial(n);
    if n % 2 == 1 { -size } else { size }
}

/// Coefficients of δx^i δy^j for i + j ≤ d ≤ [`DEGREE`].
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet {
    degree: usize,
    terms: [Interval; TERMS],
}

impl Jet {
    /// From its coefficients.
    pub fn new(coefficient: impl Fn(usize, usize) -> Interval) -> Self {
        Self::of_degree(DEGREE, coefficient)
    }

    fn of_degree(degree: usize, coefficient: impl Fn(usize, usize) -> Interval) -> Self {
        let mut terms = [Interval::ZERO; TERMS];
        for (term, (i, j)) in terms.iter_mut().zip(exponents(degree)) {
            *term = coefficient(i, j);
        }
        Self { degree, terms }
    }

    /// A number.
    pub fn constant(value: Interval) -> Self {
        Self::new(|i, j| if i + j == 0 { value } else { Interval::ZERO })
    }

    /// e^x, where it is `value`.
    pub fn exponential_of_x(value: Interval) -> Self {
        Self::new(|i, j| if j == 0 { value * inverse_factorial(i) } else { Interval::ZERO })
    }

    /// e^{−x}, where it is `value`.
    pub fn exponential_of_minus_x(value: Interval) -> Self {
        Self::new(|i, j| if j == 0 { alternating(value, i) } else { Interval::ZERO })
    }

    /// e^{−y}, where it is `value`.
    pub fn exponential_of_minus_y(value: Interval) -> Self {
        Self::new(|i, j| if i == 0 { alternating(value, j) } else { Interval::ZERO })
    }

    /// The value.
    pub const fn value(&self) -> Interval {
        self.terms[0]
    }

    /// The first derivatives.
    pub fn gradient(&self) -> [Interval; 2] {
        debug_assert!(self.degree >= 1, "first derivatives are known");
        [self.terms[1], self.terms[2]]
    }

    /// A bound of each second derivative.
    pub fn largest_second(&self) -> f64 {
        debug_assert!(self.degree >= 2, "second derivatives are known");
        self.terms[3..6].iter().map(|c| 2.0 * c.magnitude()).fold(0.0, worse)
    }

    /// The derivative by x; its coefficients of the highest degree are unknown and left out.
    pub fn by_x(&self) -> Self {
        Self::of_degree(self.degree - 1, |i, j| Interval::point((i + 1) as f64) * self.terms[place(i + 1, j)])
    }

    /// The same by y.
    pub fn by_y(&self) -> Self {
        Self::of_degree(self.degree - 1, |i, j| Interval::point((j + 1) as f64) * self.terms[place(i, j + 1)])
    }

    /// All coefficients times a number.
    pub fn scaled(self, by: Interval) -> Self {
        Self { terms: self.terms.map(|term| term * by), ..self }
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let of = |i, j| self.terms[place(i, j)] + other.terms[place(i, j)];
        Self::of_degree(self.degree.min(other.degree), of)
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self { terms: self.terms.map(|term| -term), ..self }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::of_degree(self.degree.min(other.degree), |i, j| {
            let mut sum = Interval::ZERO;
            for p in 0..i + 1 {
                for q in 0..j + 1 {
                    sum = sum + self.terms[place(p, q)] * other.terms[place(i - p, j - q)];
                }
            }
            sum
        })
    }
}
