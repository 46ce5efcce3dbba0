//! Exact algebra over the rationals: polynomials, discriminants, Sturm sequences, symbolic expressions, proofs that can be printed and re-checked.

mod sturm;
mod univariate;

pub use sturm::{IsolatingInterval, Limit, SturmSequence};
pub use univariate::UnivariatePolynomial;
