//! max Im(s), spectral class and slip mode on a (V, σ) grid (figs 1, 6a and 7).

pub(crate) mod figures;
pub(crate) mod run;

pub use run::{MapPoint, classify_rectangle};
