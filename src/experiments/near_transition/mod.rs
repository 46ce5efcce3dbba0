//! The nonlinear slider close to K = K_c.

pub(crate) mod bistability;
pub(crate) mod cycle_families;
pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use bistability::{Edge, Threshold, place_on_transition};
pub use cycle_families::{AmplitudeDeviation, CycleFamilyOutcome, FamilyCycle};
pub use run::{NearRun, NearTransitionOutcome, near_transition};
pub use section::NearTransition;
