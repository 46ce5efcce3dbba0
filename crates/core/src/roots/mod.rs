//! The three roots of a real cubic: 64-bit, double-double and certified, and which of them decided.
//!
//! Cubics are `[c0, c1, c2, c3]` by ascending power. Whether roots are real, and whether any coincide, is never read off
//! rounded roots: the sign of the [`discriminant`] decides it exactly, and enclosures are computed afterwards.

pub mod binary64;
mod bracket;
mod certified;
mod depressed;
mod discriminant;
pub mod double_double;
mod forward;
mod kahan;
mod multiple;
mod precision_level;
mod short;
pub mod textbook;

pub use certified::{CertifiedRoot, CertifiedRoots, certified_roots};
pub(crate) use depressed::Depressed;
pub use discriminant::discriminant;
pub use forward::{Bounded, BoundedCubic, Pair, Spectrum, Working};
pub use precision_level::PrecisionLevel;
pub(crate) use short::ShortCubic;
