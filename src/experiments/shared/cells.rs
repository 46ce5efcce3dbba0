//! Cells of tables: rounded numbers, certain digits, decimals.

use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::table::{Cell, TableRows};

/// A number rounded to significant digits; empty when there is none.
pub(crate) fn rounded(value: impl Into<Option<f64>>, digits: usize) -> Cell {
    value.into().map_or_else(Cell::empty, |value| Cell::number(round_digits(value, digits)))
}

/// Digits of an error: enough to compare, few enough to read.
pub(crate) const ERROR_DIGITS: usize = 6;

/// The certain digits of an enclosed error; empty when there is none.
pub(crate) fn certain<'b>(ball: impl Into<Option<&'b Ball>>) -> Cell {
    ball.into().map_or_else(Cell::empty, |ball| Cell::number(certain_digits(ball, ERROR_DIGITS)))
}

/// A rational number as a decimal with significant digits.
pub(crate) fn decimal(value: &Rational, digits: usize) -> Cell {
    Cell::number(rational_to_decimal(value, digits))
}

/// How many.
pub(crate) fn count(number: impl ToString) -> Cell {
    Cell::number(number.to_string())
}

/// Columns of values that are rounded alike.
pub(crate) trait RoundedColumns<R>: Sized {
    /// One more column of numbers, rounded to significant digits; empty where there is none.
    #[must_use]
    fn rounded<V: Into<Option<f64>>>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> V,
    ) -> Self;
}

impl<R: Copy> RoundedColumns<R> for TableRows<R> {
    fn rounded<V: Into<Option<f64>>>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> V,
    ) -> Self {
        self.number(name, header, unit, |row| rounded(value(row), digits))
    }
}
