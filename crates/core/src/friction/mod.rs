//! Rate-and-state friction: parameters in SI, and the three dimensionless groups that are all there is.
//!
//! SI stops here: the floors above work in (η, κ, β) and in the unit of time D_c/V0.
//!
//! ```
//! use slipmode_core::friction::{Groups, Slider};
//!
//! // 64-bit numbers serve where exactness does not matter.
//! let slider = Slider::from([0.004, 0.006, 1e-5, 1e7, 1000.0]);
//! let Groups { inertial_parameter, stiffness_group, effect_ratio } = slider.at(1e6, 0.01).groups();
//! assert!((inertial_parameter - 2.5).abs() < 1e-12);
//! assert!((stiffness_group - 0.025).abs() < 1e-15 && effect_ratio == 1.5);
//! ```

mod evolution;
mod groups;
mod parameter_box;
mod parameters;
mod quantity;
mod slider;
mod slip_mode;

pub use evolution::EvolutionLaw;
pub(crate) use groups::cubic_of_terms;
pub use groups::{Groups, critical_stiffness_group};
pub use parameter_box::ParameterBox;
pub use parameters::{OperatingPoint, Parameters};
pub use quantity::Quantity;
pub use slider::Slider;
pub use slip_mode::SlipMode;

/// The least value that an input of the slider may have: far below any slider, and far inside what the exact arithmetic can do.
pub const LEAST: &str = "1e-300";
/// The largest one.
pub const MOST: &str = "1e300";
