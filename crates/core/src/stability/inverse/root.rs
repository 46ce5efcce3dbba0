//! A positive solution: enclosed to any number of bits, with exact signs of other polynomials at it.

use std::cmp::Ordering;
use std::sync::Arc;

use rug::Rational;

use crate::number::Ball;
use crate::stability::inverse::Undecided;
use crate::stability::inverse::frequency::{FrequencyCondition, squared_angular_frequency};
use slipmode_algebra::{IsolatingInterval, UnivariatePolynomial, enclose_root, horner};

/// The most bits with which a sign is tried.
pub(super) const MOST_BITS: u32 = 1 << 20;
/// Precision of the first attempt at a sign, in bits.
const FIRST_BITS: u32 = 64;

/// A positive solution.
pub(super) enum Root {
    /// The root of a polynomial over ℚ in an isolating interval.
    Algebraic { polynomial: UnivariatePolynomial, interval: IsolatingInterval },
    /// The one root between these numbers of a condition at ω = 2πf.
    AtHertz { condition: Arc<FrequencyCondition>, frequency: Rational, lower: Rational, upper: Rational },
}

impl Root {
    /// All positive roots of a polynomial over ℚ.
    pub(super) fn all_of(polynomial: &UnivariatePolynomial) -> Vec<Self> {
        let zeros = polynomial.coefficients().iter().take_while(|value| **value == 0).count();
        let polynomial = UnivariatePolynomial::new(polynomial.coefficients()[zeros..].to_vec());
        let of = |interval| Self::Algebraic { polynomial: polynomial.clone(), interval };
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
    pub(super) fn exact(&self) -> Option<Rational> {
        match self {
            Self::Algebraic { interval: IsolatingInterval::Exact(root), .. } => Some(root.clone()),
            _ => None,
        }
    }

    /// The root with a relative radius of at most 2^−bits.
    pub(super) fn enclosed(&self, bits: u32) -> Ball {
        match self {
            Self::Algebraic { polynomial, interval } => polynomial.refine(interval, bits),
            Self::AtHertz { condition, frequency, lower, upper } => {
                let coefficients =
                    |precision: u32| condition.enclosed(&squared_angular_frequency(frequency, precision));
                enclose_root(&coefficients, lower, upper, bits)
            }
        }
    }

    /// Whether a polynomial over ℚ is zero here; at the transcendental ω only the zero polynomial is.
    pub(super) fn is_root_of(&self, other: &UnivariatePolynomial) -> bool {
        match self {
            Self::Algebraic { polynomial, interval } => polynomial.gcd(other).has_root_in(interval),
            Self::AtHertz { .. } => other.is_zero(),
        }
    }

    /// The sign of a polynomial over ℚ here.
    ///
    /// At ω = 2πf the solution is algebraic nowhere: ω would be.
    pub(super) fn sign_of(&self, other: &UnivariatePolynomial) -> Result<Ordering, Undecided> {
        if self.is_root_of(other) {
            return Ok(Ordering::Equal);
        }
        let mut bits = FIRST_BITS;
        while bits <= MOST_BITS {
            let coefficients = other.coefficients().iter().map(|value| Ball::from_rational(value, bits));
            if let Some(sign) = horner(coefficients.collect(), &self.enclosed(bits)).sign() {
                return Ok(sign);
            }
            bits *= 2;
        }
        Err(Undecided)
    }
}
