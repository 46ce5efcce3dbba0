//! Roots of a polynomial over ℚ: counted by Sturm's theorem, so that none is missed and none invented, and enclosed to any number of bits.

use std::cmp::Ordering;

use crate::{Coefficients, IsolatingInterval, Polynomial, Symbol, UnivariatePolynomial, horner};
use rug::Rational;

use crate::number::Ball;

/// The most bits with which a sign is tried.
pub const MOST_BITS: u32 = 1 << 20;
/// Precision of the first attempt at a sign, in bits.
const FIRST_BITS: u32 = 64;

/// A positive root of a polynomial over ℚ.
#[derive(Debug, Clone)]
pub struct AlgebraicRoot {
    polynomial: UnivariatePolynomial,
    interval: IsolatingInterval,
}

impl AlgebraicRoot {
    /// All positive roots, ascending.
    pub fn positive(polynomial: &UnivariatePolynomial) -> Vec<Self> {
        let zeros = polynomial.coefficients().iter().take_while(|value| **value == 0).count();
        let polynomial = UnivariatePolynomial::new(polynomial.coefficients()[zeros..].to_vec());
        let of = |interval| Self { polynomial: polynomial.clone(), interval };
        match polynomial.coefficients() {
            // The root of a linear polynomial is rational.
            [constant, slope] => {
                let root = -Rational::from(constant / slope);
                (root > 0).then(|| of(IsolatingInterval::Exact(root))).into_iter().collect()
            }
            _ => polynomial.isolate_positive_roots().into_iter().map(of).collect(),
        }
    }

    /// The root itself, where it is known to be rational.
    pub fn exact(&self) -> Option<Rational> {
        match &self.interval {
            IsolatingInterval::Exact(root) => Some(root.clone()),
            IsolatingInterval::Between(..) => None,
        }
    }

    /// Rationals between which it is the only root; both are the root itself where it is known to be rational.
    pub fn ends(&self) -> [Rational; 2] {
        match &self.interval {
            IsolatingInterval::Exact(root) => [root.clone(), root.clone()],
            IsolatingInterval::Between(lower, upper) => [lower.clone(), upper.clone()],
        }
    }

    /// The root with a relative radius of at most 2^−bits.
    pub fn enclosed(&self, bits: u32) -> Ball {
        self.polynomial.refine(&self.interval, bits)
    }

    /// Whether another polynomial over ℚ is zero here.
    pub fn is_root_of(&self, other: &UnivariatePolynomial) -> bool {
        self.polynomial.gcd(other).has_root_in(&self.interval)
    }

    /// The sign of another polynomial over ℚ here; none where [`MOST_BITS`] do not tell it.
    pub fn sign_of(&self, other: &UnivariatePolynomial) -> Option<Ordering> {
        if self.is_root_of(other) {
            return Some(Ordering::Equal);
        }
        sign_beside_roots(other, |bits| self.enclosed(bits))
    }
}

/// The sign of a polynomial over ℚ at a number that is none of its roots; none where [`MOST_BITS`] do not tell it.
pub fn sign_beside_roots(
    polynomial: &UnivariatePolynomial,
    enclosed: impl Fn(u32) -> Ball,
) -> Option<Ordering> {
    let precisions = std::iter::successors(Some(FIRST_BITS), |bits| Some(2 * bits));
    let mut tried = precisions.take_while(|bits| *bits <= MOST_BITS);
    tried.find_map(|bits| horner(polynomial.at_precision(bits), &enclosed(bits)).sign())
}

/// All real roots but zero, each with a relative radius of at most 2^−bits.
pub fn nonzero_real_roots(polynomial: &UnivariatePolynomial, bits: u32) -> Vec<Ball> {
    let [positive, negative] = [polynomial, &polynomial.mirrored()].map(AlgebraicRoot::positive);
    let negative = negative.iter().map(|root| -root.enclosed(bits));
    positive.iter().map(|root| root.enclosed(bits)).chain(negative).collect()
}

/// A polynomial as one in this variable over ℚ; none where it has another variable.
pub fn in_one_variable(polynomial: &Polynomial, name: &Symbol) -> Option<UnivariatePolynomial> {
    let coefficients = polynomial.coefficients(name);
    let values: Option<Vec<Rational>> = coefficients.iter().map(Polynomial::as_constant).collect();
    values.map(UnivariatePolynomial::new)
}
