//! Rate-and-state friction: parameters in SI, and the three dimensionless groups that are all there is.
//!
//! SI stops here: the floors above work in (η, κ, β) and in the unit of time D_c/V0.

mod evolution;
mod groups;
mod parameters;
mod slider;
mod slip_mode;

pub use evolution::EvolutionLaw;
pub use groups::Groups;
pub use parameters::{OperatingPoint, Parameters};
pub use slider::Slider;
pub use slip_mode::SlipMode;
