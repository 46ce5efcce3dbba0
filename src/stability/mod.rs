//! Transition K = K_c, boundary max Im(s) = 0, its asymptotes and how far off they are.

pub mod curve;
#[cfg(test)]
mod fixtures;
pub mod transition;

pub use curve::Arc;
mod decision;
mod slip_mode;
mod spectral_class;
mod spectrum;

pub use decision::{boundary_sign, transition_sign};
pub use slip_mode::{InertialThreshold, SlipMode, slip_mode};
pub use spectral_class::SpectralClass;
pub use spectrum::{Classification, classify};
