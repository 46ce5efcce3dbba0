//! What several experiments use: grids, searches for zeros, and the (V, σ) plane of the maps.

pub(crate) mod axes;
pub mod bands;
pub mod cells;
#[cfg(test)]
pub(crate) mod fixtures;
pub(crate) mod grid;
pub(crate) mod map_readout;

pub use grid::Grid;
