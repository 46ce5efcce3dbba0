//! Boundary max Im(s) = 0, its asymptotes and how far off they are.
//!
//! ```
//! use slipmode_core::stability::{boundary_sign, transition_sign};
//! use slipmode_core::{friction::Groups, number::Rational};
//!
//! // η = 1, κ = 1, β = 3/2: κ_c = (β − 1)(1 + η) is exactly 1, so this is a point of the transition K = K_c.
//! let groups = Groups {
//!     inertial_parameter: Rational::from(1),
//!     stiffness_group: Rational::from(1),
//!     effect_ratio: Rational::from((3, 2)),
//! };
//! assert_eq!(transition_sign(&groups), 0);
//! assert_eq!(boundary_sign(&groups), -1); // a complex pair: the slider oscillates
//! ```

mod arc_point;
pub mod asymptote;
pub mod batch;
pub mod boundary;
mod certain_signs;
pub mod curve;
pub mod cusp;
mod deciding_signs;
mod decision;
pub mod deviation;
mod distance;
mod double_root;
#[cfg(test)]
mod fixtures;
mod frequencies;
mod integer_cubic;
pub mod inverse;
mod logarithm;
mod nearest_place;
mod over_box;
mod pair_line;
mod parameter_coefficients;
mod parameter_equation;
mod point_values;
mod quick;
mod slip_mode;
mod spectral_class;
mod spectrum;
mod three_roots;
pub mod tolerance;

pub use crate::friction::SlipMode;
pub use arc_point::{ArcFrame, ArcPoint};
pub use asymptote::Asymptote;
pub use boundary::{BoundaryCurve, BoundaryPoint, Mark, Section};
pub use curve::Arc;
pub use deciding_signs::{DECIDING, deciding_quantities, slip_mode_of_signs};
pub use decision::{boundary_sign, transition_sign};
pub use distance::LogDistance;
pub use frequencies::Frequencies;
pub use nearest_place::{NearestPlace, Uncertain, nearest_boundary_point};
pub use over_box::{
    Distribution, Effort, OverBox, ParameterBox, Possible, Ranges, SampledShare, ValueRange,
    extremes_of_critical_stiffness, is_allowed_over_box, over_box, ranges_over_box, sampled_shares,
};
pub use pair_line::{DampingRatio, PairLine, PairLinePoint, PairRatio};
pub use quick::classify_quickly;
pub use slip_mode::{InertialThreshold, slip_mode};
pub use spectral_class::SpectralClass;
pub use spectrum::{Classification, classify};
pub use three_roots::{ExactInput, ROOT_ERROR, RootsError, ThreeRoots, three_roots};
