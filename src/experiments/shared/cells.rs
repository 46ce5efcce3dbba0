//! Cells of tables with a given number of digits: rounded doubles, decimals of rationals, certain digits of enclosures.

use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::table::{Cell, TableRows};

/// A value that is shown with some significant digits.
pub trait Digits {
    /// Its cell.
    fn cell(self, digits: usize) -> Cell;
}

impl Digits for f64 {
    fn cell(self, digits: usize) -> Cell {
        Cell::number(round_digits(self, digits))
    }
}

impl Digits for &Rational {
    fn cell(self, digits: usize) -> Cell {
        Cell::number(rational_to_decimal(self, digits))
    }
}

/// Only digits that are certain.
impl Digits for &Ball {
    fn cell(self, digits: usize) -> Cell {
        Cell::number(certain_digits(self, digits))
    }
}

/// Empty where there is none.
impl<D: Digits> Digits for Option<D> {
    fn cell(self, digits: usize) -> Cell {
        self.map_or_else(Cell::empty, |value| value.cell(digits))
    }
}

/// Digits of an error: enough to compare, few enough to read.
pub(crate) const ERROR_DIGITS: usize = 6;

/// Columns of numbers with the same digits in every row.
pub trait DigitColumns<R>: Sized {
    /// One more column, with its unit and its significant digits.
    #[must_use]
    fn digits<D: Digits>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> D,
    ) -> Self;
}

impl<R: Copy> DigitColumns<R> for TableRows<R> {
    fn digits<D: Digits>(
        self,
        name: &str,
        header: &str,
        unit: &str,
        digits: usize,
        value: impl Fn(R) -> D,
    ) -> Self {
        self.number(name, header, unit, |row| value(row).cell(digits))
    }
}
