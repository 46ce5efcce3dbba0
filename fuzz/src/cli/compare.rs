//! Trajectories.

#[path = "../../../src/cli/compare/recording.rs"]
pub mod recording;
