//! Charts of what the equations of a report say: lines, and maps of where the roots of a polynomial lie. Each comes with a table of
//! its numbers.

mod lines;
mod modes;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use crate::experiments::Figure;
use crate::scene::{EquationChart, Sampled};
use slipmode_algebra::{Literal, Symbol};
use slipmode_core::number::Rational;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_plot::table::{Cell, Column, Table};

/// The figure of a chart, and the table of its numbers, which has the figure's id.
#[must_use]
pub fn draw(chart: &EquationChart) -> (Figure, Table) {
    let (svg, table) = match &chart.map {
        None => lines::draw(chart),
        Some(map) => modes::draw(chart, map),
    };
    let figure = Figure::new(&chart.caption, "", &chart.caption_markdown, svg);
    (figure.with_data(std::slice::from_ref(&chart.caption.id)), table)
}

/// Values of variables.
type Point = BTreeMap<Symbol, Rational>;

impl Sampled {
    fn column(&self) -> Column {
        Column::number(self.variable.as_str(), &self.axis.title, &self.axis.unit)
    }
}

fn point<'s>(values: impl IntoIterator<Item = (&'s Sampled, &'s Rational)>) -> Point {
    values.into_iter().map(|(axis, value)| (axis.variable.clone(), value.clone())).collect()
}

/// A value of an axis in the table.
fn coordinate(value: &Rational) -> Cell {
    Cell::number(rational_to_decimal(value, 17))
}

/// Whether all conditions hold at a point with certainty.
fn hold(conditions: &[Literal], at: &Point) -> bool {
    conditions.iter().all(|one| one.holds_at(at) == Some(true))
}
