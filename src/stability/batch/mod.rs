//! Exact classification of millions of points: a vectorised 64-bit filter with a proven error bound decides nearly all,
//! double-double and rationals the rest. The answers are exact, so they cannot depend on the vector units used.
//!
//! Points are the f64 handed in, taken as the exact binary rationals that they are.

mod dispatch;
mod grid;
mod points;
mod row_filter;
mod sign_pair;
mod values;

pub use grid::{Grid, GridKernel, classify_grid};
pub use points::classify_points;
pub use sign_pair::{RungCounts, SignPair};
pub use values::{LargestPartsPerS, grid_values};
