//! The nonlinear slider on a (V, σ) grid (figs 3a, 5 and 6).

pub(crate) mod least_peak;
pub(crate) mod least_peak_figures;
pub(crate) mod map_figure;
pub(crate) mod overshoot_figure;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use least_peak::{FLATNESS_LEVELS, LeastPeak, SIDE_WIDTH, least_peaks};
pub use run::{SimulatedPoint, SimulationsOutcome, simulations};
pub use section::SimulationsSection;
