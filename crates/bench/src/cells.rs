//! Columns of tables with a given number of significant digits.

use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, TableRows};

/// A number with some significant digits; empty when there is none.
pub(crate) fn rounded(value: impl Into<Option<f64>>, digits: usize) -> Cell {
    value.into().map_or_else(Cell::empty, |value| Cell::number(round_digits(value, digits)))
}

/// Columns of numbers with the same digits in every row.
pub(crate) trait DigitColumns<R>: Sized {
    /// One more column, with its unit and its significant digits.
    #[must_use]
    fn digits<V: Into<Option<f64>>>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> V,
    ) -> Self;
}

impl<R: Copy> DigitColumns<R> for TableRows<R> {
    fn digits<V: Into<Option<f64>>>(
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
