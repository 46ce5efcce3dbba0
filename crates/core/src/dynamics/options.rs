//! What to simulate, beyond the parameters of the slider.

use super::Start;

/// What to simulate, beyond the parameters.
///
/// ```
/// use slipmode_core::dynamics::{Options, Start};
///
/// let options = Options { start: Start::VelocityKick, ..Options::at(1e-6) };
/// assert_eq!((options.tolerance, options.velocity_ratio), (1e-6, 0.1));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How the start is completed.
    pub start: Start,
    /// V/V_l at the start; the paper takes 1/10.
    pub velocity_ratio: f64,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: f64,
    /// μ0 of the regularised friction law; none for eq 1 as it stands.
    pub regularised_reference_friction: Option<f64>,
    /// Most steps of one run, refused ones included.
    pub most_steps: u64,
    /// Most oscillations before the long-term behaviour is called undecided.
    pub most_returns: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            start: Start::default(),
            velocity_ratio: 0.1,
            tolerance: 1e-8,
            regularised_reference_friction: None,
            most_steps: 5_000_000,
            most_returns: 4_000,
        }
    }
}

impl Options {
    /// The paper's start, simulated to this relative error of peak velocity and period.
    #[must_use]
    pub fn at(tolerance: f64) -> Self {
        Self { tolerance, ..Self::default() }
    }
}
