//! Exact algebra over the rationals: polynomials, discriminants, Sturm sequences, symbolic expressions, proofs that can be printed and re-checked.

mod enclose;
mod sturm;
mod univariate;

pub use enclose::{Coefficients, enclose_root};
pub use sturm::{IsolatingInterval, Limit, SturmSequence};
pub use univariate::UnivariatePolynomial;
