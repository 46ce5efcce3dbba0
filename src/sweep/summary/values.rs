//! The cells of summaries: bins, numbers, statistics, and the order of keys.

use std::cmp::Ordering;

use crate::sweep::Statistic;
use crate::sweep::csv_records::cells;
use slipmode_core::number::format::shortest;

/// The bin of a number, counted from 1; 0 below the first edge, one more than there are bins beyond the last, which belongs to its bin.
pub(crate) fn bin(edges: &[f64], number: f64) -> usize {
    if edges.last() == Some(&number) {
        edges.len() - 1
    } else {
        edges.partition_point(|edge| *edge <= number)
    }
}

impl Statistic {
    /// Takes a number in: of a row, or what another summary has.
    pub(crate) fn combine(self, value: &mut Option<f64>, number: f64) {
        *value = Some(match (self, *value) {
            (_, None) => number,
            (Self::Least, Some(old)) => old.min(number),
            (Self::Greatest, Some(old)) => old.max(number),
            // A sum beyond 64-bit stays at the end of the range: the sum of two infinities might be no number.
            (Self::Count | Self::Sum, Some(old)) => (old + number).clamp(-f64::MAX, f64::MAX),
        });
    }

    /// A cell of a key with so many rows as a number; none where it is no value of this statistic.
    pub(crate) fn read(self, cell: &[u8], rows: u64) -> Option<f64> {
        let is_count = |value: f64| (0.0..=rows as f64).contains(&value) && value.fract() == 0.0;
        number(cell).filter(|value| self != Self::Count || is_count(*value))
    }

    /// As a cell.
    pub(crate) fn written(self, value: Option<f64>) -> String {
        match (self, value) {
            // Counts stay far below 2⁵³, where 64-bit numbers are whole.
            (Self::Count, value) => (value.unwrap_or(0.0) as u64).to_string(),
            (_, Some(value)) => shortest(value),
            (_, None) => String::new(),
        }
    }
}

/// A cell as a finite number.
pub(crate) fn number(cell: &[u8]) -> Option<f64> {
    std::str::from_utf8(cell).ok()?.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Cell by cell; numbers of bins before words.
pub(crate) fn key_order(one: &[u8], other: &[u8]) -> Ordering {
    let order = |(one, other): (&[u8], &[u8])| {
        let bin = |cell: &[u8]| std::str::from_utf8(cell).ok()?.parse::<u64>().ok();
        match (bin(one), bin(other)) {
            (Some(one), Some(other)) => one.cmp(&other),
            _ => one.cmp(other),
        }
    };
    cells(one).zip(cells(other)).map(order).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}
