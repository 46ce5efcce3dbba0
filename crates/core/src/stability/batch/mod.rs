//! Exact classification of millions of points: a vectorised 64-bit filter with a proven error bound decides nearly all,
//! double-double and rationals the rest. The answers are exact, so they cannot depend on the vector units used.
//!
//! Points are the f64 handed in, taken as the exact binary rationals that they are.
//!
//! ```
//! use slipmode_core::stability::SpectralClass;
//! use slipmode_core::stability::batch::SignPair;
//!
//! // Both signs of a point in one byte.
//! let cell = SignPair::new(-1, -1);
//! assert_eq!(cell.spectral_class(), SpectralClass::UnstableComplex);
//! ```

mod dispatch;
mod grid;
mod grid_cell;
mod mode_filter;
mod parallel;
mod points;
mod row_filter;
mod sign_pair;
mod tally;

pub use grid::GridKernel;
pub use grid_cell::GridCell;
pub use points::classify_points;
pub use sign_pair::{PrecisionCounts, SignPair};
pub use tally::{GridAxis, StreamedGrid, Tally};
