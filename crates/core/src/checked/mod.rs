//! The front door: values that are checked where they are made, and the questions that can be asked of them.
//!
//! A [`Slider`] and an [`OperatingPoint`] cannot hold what is no slider, so that no answer is wrong for that reason and none panics.
//! Numbers are [`Exact`]; results are 64-bit numbers with their errors, or [`Enclosed`]. No type of another library is visible.

mod answers;
mod enclosed;
mod exact;
mod input_error;
mod slider;

pub use answers::{Boundary, BoundaryPoint, Classification, Root};
pub use enclosed::Enclosed;
pub use exact::{Exact, NumberError};
pub use input_error::{InputError, InputErrors, QuantityError};
pub use slider::{OperatingPoint, Slider};

#[cfg(test)]
mod tests;
