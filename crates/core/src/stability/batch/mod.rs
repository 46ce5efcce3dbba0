//! Exact classification of millions of points: a vectorised 64-bit filter with a proven error bound decides nearly all,
//! double-double and rationals the rest. The answers are exact, so they cannot depend on the vector units used.
//!
//! Points are the f64 handed in, taken as the exact binary rationals that they are; [`classify_points`] takes decimals to within
//! the last digit of double-double.
//!
//! | question | item |
//! |---|---|
//! | signs, names and values of decimals, row by row | [`classify_points`] |
//! | the three roots of columns of points | [`three_roots_of_points`] |
//! | both signs of columns of points, nothing else | [`signs_of_points`] |
//! | signs and modes of a grid | [`GridKernel`], [`StreamedGrid`] |
//!
//! ```
//! use slipmode_core::stability::SpectralClass;
//! use slipmode_core::stability::batch::SignPair;
//!
//! // Both signs of a point in one byte.
//! let cell = SignPair::new(-1, -1);
//! assert_eq!(cell.spectral_class(), SpectralClass::UnstableComplex);
//! ```

mod grid;
mod grid_cell;
mod mode_filter;
mod parallel;
mod points;
mod row_filter;
mod rows;
mod sign_pair;
mod tally;
mod values;

pub use grid::GridKernel;
pub use grid_cell::GridCell;
pub use points::signs_of_points;
pub use rows::{PointError, classify_points, three_roots_of_points};
pub use sign_pair::{PrecisionCounts, SignPair};
pub use tally::{GridAxis, StreamedGrid, Tally};
pub(super) use values::one_point;
