//! Cells of tables: rounded numbers, certain digits, counts.

use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_plot::table::Cell;

/// A number rounded to significant digits.
pub(crate) fn rounded(value: f64, digits: usize) -> Cell {
    Cell::number(round_digits(value, digits))
}

/// The same; empty when there is no number.
pub(crate) fn rounded_or_empty(value: Option<f64>, digits: usize) -> Cell {
    value.map_or_else(Cell::empty, |value| rounded(value, digits))
}

/// Digits of an error: enough to compare, few enough to read.
pub(crate) const ERROR_DIGITS: usize = 6;

/// The certain digits of an enclosed error.
pub(crate) fn certain(ball: &Ball) -> Cell {
    Cell::number(certain_digits(ball, ERROR_DIGITS))
}

/// The same; empty when there is no error.
pub(crate) fn certain_or_empty(ball: Option<&Ball>) -> Cell {
    ball.map_or_else(Cell::empty, certain)
}

/// How many.
pub(crate) fn count(number: impl ToString) -> Cell {
    Cell::number(number.to_string())
}
