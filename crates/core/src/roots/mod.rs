//! The three roots of a real cubic: 64-bit, double-double and certified, and which of them decided.
//!
//! Cubics are `[c0, c1, c2, c3]` by ascending power. Whether roots are real, and whether any coincide, is never read off
//! rounded roots: the sign of the discriminant decides it exactly, and enclosures are computed afterwards.
//!
//! ```
//! use slipmode_core::number::Rational;
//! use slipmode_core::roots::{certified_roots, discriminant};
//!
//! // (x − 1)²(x + 2) = x³ − 3x + 2: the double root is found as one, because the discriminant is exactly zero.
//! let cubic = [2, -3, 0, 1].map(Rational::from);
//! assert_eq!(discriminant(&cubic), 0);
//! let roots = certified_roots(&cubic, 30).roots;
//! assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [1, 2]);
//! ```

mod bracket;
mod certified;
mod depressed;
mod discriminant;
mod forward;
mod kahan;
mod precision_level;

pub use certified::{CertifiedRoot, CertifiedRoots, certified_roots};
pub(crate) use depressed::Depressed;
pub use discriminant::discriminant;
pub use forward::{Bounded, BoundedCubic, BranchlessRoots, Pair, Spectrum, Working, bounded_roots};
pub use precision_level::PrecisionLevel;
