//! Exact algebra over the rationals: polynomials, discriminants, Sturm sequences, symbolic expressions, proofs that can be printed and re-checked.
//!
//! ```
//! use slipmode_algebra::UnivariatePolynomial;
//!
//! // (x − 1)(x² − 2) = x³ − x² − 2x + 2 has two positive roots.
//! let cubic = UnivariatePolynomial::from_integers(&[2, -2, -1, 1]);
//! assert_eq!(cubic.isolate_positive_roots().len(), 2);
//! ```

mod algebraic_root;
mod budget;
mod calculus;
mod certificate;
mod check;
mod condition;
mod conversion;
pub mod coq;
mod division;
mod domain;
mod elementary;
mod enclose;
mod enclosure;
mod expression;
mod forms;
mod latex;
mod limit;
mod linearisation;
mod matrix;
mod monomial;
mod multivariate;
mod named;
mod notation;
pub mod number;
mod operators;
mod parser;
mod printer;
mod proof;
mod rational_function;
mod refutation;
mod root_counts;
mod series;
mod sign_formula;
mod size;
mod source;
mod squares;
mod sturm;
mod univariate;
mod value;

pub use algebraic_root::{AlgebraicRoot, MOST_BITS, in_one_variable, nonzero_real_roots, sign_beside_roots};
pub use budget::{Exhausted, within_budget};
pub use certificate::Certificate;
pub use condition::{Condition, Relation};
pub use domain::{ConversionError, Domain, DomainError};
pub use enclose::{Coefficients, enclose_root};
#[doc(hidden)]
pub use enclose::{derivative, horner, polish};
pub use enclosure::Enclosure;
pub use expression::symbol::{Generator, Symbol};
pub use expression::{Expression, Function};
pub use limit::{End, Toward};
pub use linearisation::{Linearisation, written_out};
pub use matrix::{determinant, discriminant, resultant, sylvester};
pub use monomial::Monomial;
pub use multivariate::Polynomial;
pub use named::{UnknownWord, nearest};
pub use notation::Notation;
pub use parser::{Demand, ParseError};
pub use proof::{Line, Proof, Step};
pub use rational_function::RationalFunction;
pub use refutation::{CounterExample, Refutation};
pub use root_counts::RootCounts;
pub use series::Series;
pub use sign_formula::{Literal, Sign, SignFormula};
pub use size::{Extent, TooLarge};
pub use source::{Comparison, Source};
pub use sturm::{IsolatingInterval, SturmSequence};
pub use univariate::UnivariatePolynomial;
pub use value::unknowns;
