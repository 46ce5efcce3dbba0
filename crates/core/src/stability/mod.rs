//! Boundary max Im(s) = 0, its asymptotes and how far off they are.

mod arc_point;
pub mod asymptote;
pub mod batch;
mod binary64;
pub mod boundary;
mod certain_signs;
pub mod curve;
pub mod cusp;
mod decision;
pub mod deviation;
mod distance;
#[cfg(test)]
mod fixtures;
mod logarithm;
mod nearest_place;
mod parameter_coefficients;
mod parameter_equation;
mod parameter_quick;
mod parameter_section;
mod quick;
mod slip_mode;
mod spectral_class;
mod spectrum;
pub mod tolerance;

pub use crate::friction::SlipMode;
pub use arc_point::{ArcFrame, ArcPoint, Sensitivity};
pub use asymptote::Asymptote;
pub use binary64::classify_binary64;
pub use boundary::{BoundaryCurve, BoundaryPoint, Mark, Section};
pub use curve::Arc;
pub use decision::{boundary_sign, transition_sign};
pub use distance::LogDistance;
pub use nearest_place::{NearestPlace, Uncertain, nearest_boundary_point};
pub use quick::classify_quickly;
pub use slip_mode::{InertialThreshold, slip_mode};
pub use spectral_class::SpectralClass;
pub use spectrum::{Classification, classify};
