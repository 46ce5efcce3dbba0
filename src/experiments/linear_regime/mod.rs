//! Small disturbances of the nonlinear slider compared with the roots of eq 8.

pub(crate) mod figures;
pub(crate) mod modes;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod snapshots;
pub(crate) mod steady_sliding;

pub use modes::Direction;
pub use run::{LinearRegimeOutcome, Mismatch, ModeRuns, linear_regime};
pub use section::{LinearRegimeSection, StartSensitivitySection};
pub use steady_sliding::{SteadyRun, steady_sliding};
