//! The nonlinear slider, integrated.

mod arrow;
mod collocation;
mod dense_matrix;
mod double_double_exp;
pub mod events;
mod failure;
mod integrator;
mod lap;
mod model;
mod multi;
mod radau;
mod rodas;
mod scalar;
mod settle;
mod start;
mod stepper;
mod taylor;

pub use arrow::Arrow;
pub use failure::Failure;
pub use integrator::{Control, Integrator};
pub use lap::{Lap, LapEnd, run_lap};
pub use model::{Balance, Model, State};
pub use multi::Multi;
pub use radau::Radau;
pub use rodas::Rodas5P;
pub use scalar::Scalar;
pub use settle::{Cycle, Decay, Late, settle};
pub use start::Start;
pub use stepper::{Stepper, Trial, Weight, increment, velocity_slopes};
pub use taylor::Taylor;
