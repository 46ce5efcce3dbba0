//! The command line's readers of CSV, without the command line.

#[path = "../../../src/cli/input.rs"]
pub mod input;

pub mod compare;
pub mod points;
