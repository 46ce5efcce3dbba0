//! Where the roots of a polynomial of degree 1 to 6 lie, as signs of its coefficients, with the proofs of the general lemmas.
//!
//! The leading coefficient may have either sign and may vanish: then the statement is that on the polynomial of lower degree.
//! The polynomial zero has every number as a root.

mod crossing;
mod half_plane;
mod quadratic_factors;
mod real;

pub use crossing::pair_crosses;
pub(super) use half_plane::positive_coefficients;

use super::notation::polynomial_coefficients;
use slipmode_algebra::{Domain, Expression, Proof, RationalFunction, Refutation, Sign, SignFormula, Symbol};

/// The largest degree of a polynomial whose roots are located in a half plane.
pub const MOST_DEGREE: usize = 6;

/// The largest degree of one whose roots are all real or not, or of which a pair crosses the axis.
pub const MOST_DEGREE_OF_OTHERS: usize = 3;

slipmode_algebra::named! {
    /// What is said of the roots of a polynomial.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum RootStatement {
        /// Every root has a negative real part.
        Stable = "stable",
        /// A root has a positive real part.
        Unstable = "unstable",
        /// Every root is real.
        AllReal = "all_real",
    }
}

/// The coefficients of a polynomial in a variable by ascending power; none when it is no polynomial in it of degree 1 to
/// `most`.
#[must_use]
pub fn coefficients(function: &RationalFunction, variable: &Symbol, most: usize) -> Option<Vec<Expression>> {
    let parts = polynomial_coefficients(function, variable)?;
    (2..=most + 1).contains(&parts.len()).then(|| parts.iter().map(Expression::from).collect())
}

/// The polynomial with these coefficients, by ascending power.
#[must_use]
pub fn polynomial(coefficients: &[Expression], variable: impl Into<Symbol>) -> Expression {
    let variable = Expression::variable(variable);
    let term = |(coefficient, power): (&Expression, i32)| match power {
        0 => coefficient.clone(),
        _ => coefficient.clone() * variable.clone().power(power),
    };
    coefficients.iter().zip(0..).map(term).fold(Expression::integer(0), |sum, term| term + sum)
}

impl RootStatement {
    /// The statement on the polynomial with these coefficients, by ascending power, as signs of expressions in them.
    #[must_use]
    pub fn signs(self, coefficients: &[Expression]) -> SignFormula {
        let Some((leading, lower)) = coefficients.split_last() else {
            // The polynomial zero.
            return match self {
                Self::Unstable => SignFormula::All(Vec::new()),
                Self::Stable | Self::AllReal => SignFormula::Any(Vec::new()),
            };
        };
        let vanishing = SignFormula::All(vec![SignFormula::sign(leading, Sign::Zero), self.signs(lower)]);
        let with_leading = match self {
            Self::AllReal => vec![SignFormula::All(vec![
                SignFormula::sign(leading, Sign::NonZero),
                real::signs(coefficients),
            ])],
            _ => {
                let negated: Vec<Expression> = coefficients.iter().map(|one| -one.clone()).collect();
                vec![self.for_positive_leading(coefficients), self.for_positive_leading(&negated)]
            }
        };
        SignFormula::Any(with_leading.into_iter().chain([vanishing]).collect())
    }

    /// The leading coefficient is positive, and the statement holds.
    fn for_positive_leading(self, coefficients: &[Expression]) -> SignFormula {
        let leading = coefficients.last().map(|leading| SignFormula::sign(leading, Sign::Positive));
        let positive = |one: &Expression| SignFormula::sign(one, Sign::Positive);
        let lower = match self {
            Self::Unstable => half_plane::unstable(coefficients),
            _ => SignFormula::All(half_plane::stable(coefficients).iter().map(positive).collect()),
        };
        SignFormula::All(leading.into_iter().chain([lower]).collect())
    }

    /// The largest degree of a polynomial of which it is decided.
    #[must_use]
    pub fn most_degree(self) -> usize {
        if self == Self::AllReal { MOST_DEGREE_OF_OTHERS } else { MOST_DEGREE }
    }

    /// The general lemma behind [`Self::signs`] for polynomials of this degree, which has to be 1 to [`Self::most_degree`].
    ///
    /// # Errors
    /// Never, unless a step is at fault; the tests prove all of them.
    pub fn lemma(self, degree: usize) -> Result<Proof, Refutation> {
        match self {
            Self::AllReal => real::lemma(degree),
            Self::Stable | Self::Unstable => half_plane::lemma(degree),
        }
    }
}

/// No assumption at all.
fn free() -> Domain {
    Domain::default()
}

/// The expression is negative.
fn below_zero(expression: &Expression) -> SignFormula {
    SignFormula::sign(&-expression.clone(), Sign::Positive)
}

/// Adds the step that an expression is not negative: its square root is real.
fn not_negative_step(
    proof: Proof,
    says: &str,
    expression: &Expression,
    domain: &Domain,
) -> Result<Proof, Refutation> {
    let root = expression.clone().call(slipmode_algebra::Function::Sqrt).power(2);
    proof.identity(says, &[], &root, expression, domain)
}

#[cfg(test)]
mod tests;
