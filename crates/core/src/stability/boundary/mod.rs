//! The boundary max Im(s) = 0 in SI: certified points on it, by three routes that share nothing but eq 8.
//!
//! * [`BoundaryCurve`]: the rational curve in its positive parameter (`arc_point`), any number of points at the cost of
//!   a dozen multiplications each, and single points at given V0 or σ from their double root (`double_root`);
//! * `by_discriminant`: isolated real roots of the discriminant over ℚ, refined, as `slipmode solve` finds them;
//! * `by_bisection`: halving between two points of different exact class.
//!
//! [`compare_routes`] puts the three side by side.

mod by_bisection;
mod by_curve;
mod by_discriminant;
mod comparison;
mod crossing;
pub mod hard_sections;
mod point;
mod sampling;
mod section_line;

pub use crate::stability::double_root::Work;
pub use by_bisection::by_bisection;
pub use by_curve::BoundaryCurve;
pub use by_discriminant::by_discriminant;
pub use comparison::{RouteComparison, compare_routes};
pub use crossing::{BoundaryCrossing, Section};
pub(in crate::stability) use point::stretch;
pub use point::{BoundaryPoint, ErrorPair, Mark};
pub(in crate::stability) use sampling::{log2, power_of_two};
