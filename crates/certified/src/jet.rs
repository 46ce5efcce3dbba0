//! Polynomials in two small deviations, with interval coefficients: a function of (x, y) with its partial derivatives.

use std::ops::{Add, Mul, Neg, Sub};

use crate::interval::{Interval, worse};

/// n, how often the slow manifold is corrected for inertia.
pub(super) const CORRECTIONS: usize = 3;

/// The degree of a polynomial, and the number of its coefficients.
pub(super) const DEGREE: usize = CORRECTIONS + 2;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// n!, as a number.
    fn factorial(n: usize) -> f64 {
        (1..=n).map(|k| k as f64).product()
    }

    /// Every coefficient that a polynomial states is that of the function e^{ax + by}, of degree at most `degree`.
    fn is_exponential(jet: &Jet, factor: f64, [a, b]: [f64; 2], degree: usize) {
        assert!(jet.degree <= degree, "{} {degree}", jet.degree);
        for (i, j) in exponents(jet.degree) {
            let value =
                factor * libm::pow(a, i as f64) * libm::pow(b, j as f64) / (factorial(i) * factorial(j));
            let found = jet.terms[place(i, j)];
            assert!(found.widened(1e-15 * value.abs()).may_contain(value), "{i} {j} {found:?} {value}");
            assert!(found.rad <= 1e-13 * (1.0 + value.abs()), "{i} {j} {found:?}");
        }
    }

    /// e^x, e^{−x} and e^{−y} with their products, sums and derivatives: all known coefficients are right, and no unknown one is stated.
    #[test]
    fn polynomials_are_those_of_exponentials() {
        let one = Interval::ONE;
        let (grows, fades) = (Jet::exponential_of_x(one), Jet::exponential_of_minus_x(one));
        let heals = Jet::exponential_of_minus_y(one);
        is_exponential(&grows, 1.0, [1.0, 0.0], DEGREE);
        is_exponential(&fades, 1.0, [-1.0, 0.0], DEGREE);
        is_exponential(&heals, 1.0, [0.0, -1.0], DEGREE);
        let both = grows * heals;
        is_exponential(&both, 1.0, [1.0, -1.0], DEGREE);
        is_exponential(&(grows * grows), 1.0, [2.0, 0.0], DEGREE);
        is_exponential(&(fades * heals), 1.0, [-1.0, -1.0], DEGREE);
        is_exponential(&both.by_x(), 1.0, [1.0, -1.0], DEGREE - 1);
        is_exponential(&both.by_y(), -1.0, [1.0, -1.0], DEGREE - 1);
        is_exponential(&both.by_x().by_y(), -1.0, [1.0, -1.0], DEGREE - 2);
        // The unknown coefficients of a factor or of a term are unknown in the result.
        is_exponential(&(both.by_y() * grows), -1.0, [2.0, -1.0], DEGREE - 1);
        is_exponential(&(grows * both.by_x()), 1.0, [2.0, -1.0], DEGREE - 1);
        is_exponential(&(both.by_x() + both), 2.0, [1.0, -1.0], DEGREE - 1);
        is_exponential(&(both - both.by_y()), 2.0, [1.0, -1.0], DEGREE - 1);
        is_exponential(&both.scaled(Interval::point(-3.0)), -3.0, [1.0, -1.0], DEGREE);
        assert!(both.value().may_contain(1.0) && both.gradient()[0].may_contain(1.0));
        assert!(both.gradient()[1].may_contain(-1.0) && both.gradient()[1].rad < 1e-12);
    }

    /// ax² + bxy + cy² over a box of coefficients: no second derivative is larger than the bound.
    #[test]
    fn each_second_derivative_is_bounded() {
        for [a, b, c] in [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [-2.0, 0.0, 1.0],
            [0.0, -3.0, 0.0],
            [1.0, 0.0, -2.0],
        ] {
            for rad in [0.0, 5.0] {
                let around = |mid: f64| Interval { mid, rad };
                let jet = Jet::new(|i, j| match (i, j) {
                    (2, 0) => around(a),
                    (1, 1) => around(b),
                    (0, 2) => around(c),
                    _ => Interval::ZERO,
                });
                let largest = (2.0 * (a.abs() + rad)).max(b.abs() + rad).max(2.0 * (c.abs() + rad));
                assert!(jet.largest_second() >= largest, "{a} {b} {c} {rad}");
            }
        }
    }

    /// A product of polynomials with errors holds the products of its members.
    #[test]
    fn products_hold_those_of_their_members() {
        let of = |rad: f64, sign: f64| {
            move |i: usize, j: usize| {
                let mid = 1.0 / (1 + i + 2 * j) as f64;
                Interval { mid: mid + sign * rad, rad: if sign == 0.0 { rad } else { 0.0 } }
            }
        };
        let (wide, factor) = (Jet::new(of(0.25, 0.0)), Interval { mid: 0.5, rad: 0.25 });
        let (square, scaled) = (wide * wide, wide.scaled(factor));
        for sign in [1.0, -1.0] {
            let member = Jet::new(of(0.25, sign));
            let (product, part) = (member * member, member.scaled(Interval::point(0.75)));
            for (i, j) in exponents(DEGREE) {
                let holds = |outer: &Jet, inner: &Jet| {
                    outer.terms[place(i, j)].widened(1e-12).may_contain(inner.terms[place(i, j)].mid)
                };
                assert!(holds(&square, &product) && holds(&scaled, &part), "{i} {j}");
            }
        }
    }
}
