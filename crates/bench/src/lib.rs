//! Benchmarks of slipmode: timings, other programs on the same inputs, costs of larger problems, and test coverage.
//!
//! Errors of these commands are messages for people.

pub mod cost;
pub mod coverage;
mod measured_on;
pub mod peers;
pub mod process;
mod repository;
pub mod sweep_cost;
pub mod timings;
