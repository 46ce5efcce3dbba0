//! Cells of tables with a given number of digits: rounded doubles, decimals of rationals, certain digits of enclosures.

use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::table::Cell;

/// A value that is shown with some significant digits.
pub trait Digits {
    /// Its cell.
    fn cell(self, digits: usize) -> Cell;
}

impl Digits for f64 {
    fn cell(self, digits: usize) -> Cell {
        Cell::rounded(round_digits(self, digits), digits)
    }
}

impl Digits for &Rational {
    fn cell(self, digits: usize) -> Cell {
        Cell::rounded(rational_to_decimal(self, digits), digits).certain()
    }
}

/// A number that was rounded from an exact one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rounded(pub f64);

impl Digits for Rounded {
    fn cell(self, digits: usize) -> Cell {
        self.0.cell(digits).certain()
    }
}

/// Only digits that are certain.
impl Digits for &Ball {
    fn cell(self, digits: usize) -> Cell {
        let text = certain_digits(self, digits);
        let shown = text.split('e').next().unwrap_or_default().trim_start_matches(['-', '0', '.']);
        let shown = shown.bytes().filter(u8::is_ascii_digit).count();
        Cell::rounded(text, shown).certain()
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
