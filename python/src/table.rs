//! Tables of Python, read as the command line reads files of points.

use pyo3::prelude::*;
use slipmode::cli::{capture_columns, capture_rows};
use slipmode::scene::Quantity;
use slipmode_core::number::format::exact_text;

use crate::classified::{Answer, answer};

/// The column and the size in SI of its unit for each quantity, and the columns of errors.
type Columns = (Vec<Option<usize>>, Vec<Option<String>>, Vec<usize>);

/// Finds the seven quantities by the names of columns, a header line of CSV; `unknown` is the key of what may be missing.
#[pyfunction]
#[pyo3(signature = (header, unknown=None))]
pub fn table_columns(header: Vec<u8>, unknown: Option<&str>) -> Answer<Columns> {
    let (found, captured) = capture_columns(header, quantity(unknown));
    let columns = found.map(|found| {
        let size = |unit: Option<slipmode_core::number::Rational>| unit.as_ref().map(exact_text);
        (found.positions.to_vec(), found.units.map(size).to_vec(), found.errors)
    });
    answer(columns, captured)
}

/// The seven values of each row of a CSV file in SI, as exact texts; empty ones where a value is missing.
#[pyfunction]
#[pyo3(signature = (csv, unknown=None))]
pub fn table_rows(py: Python<'_>, csv: Vec<u8>, unknown: Option<&str>) -> Answer<Vec<[String; 7]>> {
    let (rows, captured) = py.detach(|| capture_rows(csv, quantity(unknown)));
    answer(rows, captured)
}

fn quantity(key: Option<&str>) -> Option<Quantity> {
    Quantity::ALL.into_iter().find(|quantity| Some(quantity.key()) == key)
}
