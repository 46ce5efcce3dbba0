//! Other people's runs compared with the linear theory and with our own simulation.
//!
//! A run states parameters and what came out of it: values, words, or a trajectory. Each is compared with every reference that
//! can say something of it, within the run's own tolerance plus the errors of both sides. What cannot be compared says why,
//! and is never a pass. Where the parameters have error bars, a value may also agree with the range over them, which is sampled.

mod agreement;
mod findings;
pub mod recording;
mod reference;
mod stated;
mod units;
mod within_errors;

pub use agreement::{Agreement, Finding, Observable, Origin, Reference, Value};
pub use findings::{Comparison, compare_run, simulated};
pub use reference::{Simulate, Theory};
pub use stated::{StatedMode, StatedRun};
pub use within_errors::sampled_range;
