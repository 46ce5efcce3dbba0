//! Benchmarks of slipmode: timings, other programs and textbook methods on the same inputs, the fixed-step scheme of the original
//! simulations, work against error by counts, costs of larger problems, and test coverage.
//!
//! Errors of these commands are messages for people.

pub mod certified;
pub mod chart;
pub mod contents;
pub mod copied;
pub mod cost;
pub mod counts;
pub mod coverage;
pub mod cpu_clock;
mod digit_columns;
pub mod error_bound;
pub mod integrators;
mod least_squares;
mod measured_on;
pub mod methods;
mod paper;
pub mod peers;
pub mod process;
mod repository;
pub mod scheme;
pub mod sweep_cost;
pub mod tables;
pub mod textbook;
pub mod times;

pub use slipmode_core::number::split_mix;
