//! When does a slider with rate-and-state friction stick, creep, oscillate or vibrate - and how sure are we?
//!
//! `slipmode` proves the linear theory of Im & Avouac, *Linear stability analysis of the condition for
//! vibration during frictional slip*, in exact arithmetic, measures how far its asymptotes are from the exact
//! boundary, and gives every claim of the paper a verdict that the program computes.
//!
//! Modules stand on floors and import lower floors only (`cargo xtask tidy` enforces it); ARCHITECTURE.md has the map.

// Tests compare with the system's elementary functions.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

// `cli` names the library by the path that the program and the Python module use.
extern crate self as slipmode;

pub mod archive;
pub mod charts;
pub mod claims;
pub mod cli;
pub mod comparison;
pub mod csv;
pub mod experiments;
pub mod explorer;
pub mod fitting;
pub mod parallel;
pub mod report;
pub mod scene;
pub mod sweep;
pub mod theorems;

pub use slipmode_core as core;
pub use slipmode_plot as plot;
