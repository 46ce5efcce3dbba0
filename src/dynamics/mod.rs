//! The nonlinear slider, integrated.

mod arrow;
#[cfg(test)]
mod checks;
mod collocation;
mod dense_matrix;
mod deviations;
mod double_double_exp;
pub mod events;
mod failure;
mod floquet;
mod integrator;
mod lap;
mod model;
mod multi;
mod original_scheme;
mod quasi_static;
mod radau;
mod rodas;
mod scalar;
mod settle;
mod simulation;
mod start;
mod stepper;
mod taylor;
mod trajectory;

pub use arrow::Arrow;
pub use deviations::oscillation_of_small_deviations;
pub use failure::Failure;
pub use floquet::floquet_multipliers;
pub use integrator::{Control, Integrator};
pub use lap::{Lap, LapEnd, run_lap};
pub use model::{Balance, Model, State};
pub use multi::Multi;
pub use original_scheme::OriginalScheme;
pub use quasi_static::{QuasiStatic, simulate_quasi_statically};
pub use radau::Radau;
pub use rodas::Rodas5P;
pub use scalar::Scalar;
pub use settle::{Cycle, Decay, Late, settle};
pub use simulation::{Behaviour, Options, Outcome, Simulation, simulate, simulate_model};
pub use start::Start;
pub use stepper::{Stepper, Trial, Weight, increment, velocity_slopes};
pub use taylor::Taylor;
pub use trajectory::{Sample, Trajectory, trajectory};
