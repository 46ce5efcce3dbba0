//! Transition K = K_c, boundary max Im(s) = 0, its asymptotes and how far off they are.

pub mod curve;
#[cfg(test)]
mod fixtures;
pub mod transition;

pub use curve::Arc;
