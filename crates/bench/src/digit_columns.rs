//! Columns of numbers with the same digits in every row.

use slipmode::experiments::shared::cells::Digits;
use slipmode_plot::table::TableRows;

/// Columns of numbers with the same digits in every row.
pub trait DigitColumns<R: Copy>: Into<TableRows<R>> + From<TableRows<R>> {
    /// One more column, with its unit and its significant digits.
    #[must_use]
    fn digits<D: Digits>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> D,
    ) -> Self {
        self.into().number(name, header, unit, |row| value(row).cell(digits)).into()
    }
}

impl<R: Copy> DigitColumns<R> for TableRows<R> {}
