//! Exact algebra over the rationals: polynomials, discriminants, Sturm sequences, symbolic expressions, proofs that can be printed and re-checked.

mod certificate;
mod conversion;
mod division;
mod domain;
mod enclose;
mod expression;
mod latex;
mod matrix;
mod monomial;
mod multivariate;
mod operators;
mod parser;
mod printer;
mod proof;
mod rational_function;
mod refutation;
mod series;
mod sturm;
mod symbol;
mod univariate;

pub use certificate::{Certificate, Toward};
pub use conversion::ConversionError;
pub use domain::Domain;
pub use enclose::{Coefficients, enclose_root};
pub use expression::{Expression, Function};
pub use matrix::{determinant, discriminant, resultant};
pub use monomial::Monomial;
pub use multivariate::Polynomial;
pub use parser::ParseError;
pub use proof::{Proof, Step};
pub use rational_function::RationalFunction;
pub use refutation::{CounterExample, Refutation};
pub use series::Series;
pub use sturm::{IsolatingInterval, Limit, SturmSequence};
pub use symbol::Symbol;
pub use univariate::UnivariatePolynomial;
