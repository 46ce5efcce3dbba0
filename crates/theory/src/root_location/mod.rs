//! Where the roots of a polynomial of degree 1 to 6 lie, as signs of its coefficients, with the proofs of the general lemmas.
//!
//! The leading coefficient may have either sign and may vanish: then the statement is that on the polynomial of lower degree.
//! The polynomial zero has every number as a root.

mod crossing;
mod half_plane;

pub use crossing::pair_crosses;

use super::notation::polynomial_coefficients;
use super::stated_proofs::{lemma, named};
use slipmode_algebra::{Expression, Proof, RationalFunction, Refutation, Sign, SignFormula, Symbol};

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
            Self::AllReal => {
                let not_negative =
                    |name| SignFormula::sign(&of_coefficients(name, coefficients), Sign::NonNegative);
                let signs = match coefficients.len() {
                    3 => not_negative("discriminant_of_quadratic"),
                    4 => not_negative("discriminant_of_cubic"),
                    _ => SignFormula::All(Vec::new()),
                };
                vec![SignFormula::All(vec![SignFormula::sign(leading, Sign::NonZero), signs])]
            }
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
            Self::AllReal => lemma(&format!("real-roots-of-degree-{}", degree.min(MOST_DEGREE_OF_OTHERS))),
            Self::Stable | Self::Unstable => lemma(&format!("roots-of-degree-{degree}")),
        }
    }
}

/// The expression is negative.
fn below_zero(expression: &Expression) -> SignFormula {
    SignFormula::sign(&-expression.clone(), Sign::Positive)
}

/// What a name of the lemmas or a formula in c_0, c_1, … says of these coefficients.
fn of_coefficients(text: &str, coefficients: &[Expression]) -> Expression {
    let names = ["c_0", "c_1", "c_2", "c_3", "c_4", "c_5", "c_6"].map(Symbol::from);
    named(text).substitute(&names.into_iter().zip(coefficients.iter().cloned()).collect())
}

#[cfg(test)]
mod tests;
