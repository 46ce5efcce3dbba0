//! A positive solution: enclosed to any number of bits, with exact signs of other polynomials at it.

use std::cmp::Ordering;
use std::sync::Arc;

use rug::Rational;

use crate::number::Ball;
use crate::stability::inverse::Undecided;
use crate::stability::inverse::frequency::{FrequencyCondition, squared_angular_frequency};
use slipmode_algebra::{AlgebraicRoot, UnivariatePolynomial, enclose_root, sign_beside_roots};

/// A positive solution.
pub(super) enum Root {
    /// The root of a polynomial over ℚ.
    Algebraic(AlgebraicRoot),
    /// The one root between these numbers of a condition at ω = 2πf.
    AtHertz { condition: Arc<FrequencyCondition>, frequency: Rational, lower: Rational, upper: Rational },
}

impl Root {
    /// All positive roots of a polynomial over ℚ.
    pub(super) fn all_of(polynomial: &UnivariatePolynomial) -> Vec<Self> {
        AlgebraicRoot::positive(polynomial).into_iter().map(Self::Algebraic).collect()
    }

    /// The root itself, where it is known to be rational.
    pub(super) fn exact(&self) -> Option<Rational> {
        match self {
            Self::Algebraic(root) => root.exact(),
            Self::AtHertz { .. } => None,
        }
    }

    /// The root with a relative radius of at most 2^−bits.
    pub(super) fn enclosed(&self, bits: u32) -> Ball {
        match self {
            Self::Algebraic(root) => root.enclosed(bits),
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
            Self::Algebraic(root) => root.is_root_of(other),
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
        sign_beside_roots(other, |bits| self.enclosed(bits)).ok_or(Undecided)
    }
}
