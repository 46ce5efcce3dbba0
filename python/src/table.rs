//! Tables of Python, read as the command line reads files of points.

use pyo3::prelude::*;
use slipmode::cli::{capture_columns, capture_rows};
use slipmode::scene::Quantity;
use slipmode_core::number::format::exact_text;

use crate::call::in_background;
use crate::classified::{Answer, answer};

/// The column and the size in SI of its unit for each quantity, and the columns of errors.
type Columns = (Vec<Option<usize>>, Vec<Option<String>>, Vec<usize>);

/// Finds the seven quantities by the names of columns, a header line of CSV; `unused` has the keys of what may be missing.
#[pyfunction]
pub fn table_columns(header: Vec<u8>, unused: Vec<String>) -> Answer<Columns> {
    let (found, captured) = capture_columns(header, quantities(&unused));
    let columns = found.map(|found| {
        let size = |unit: Option<slipmode_core::number::Rational>| unit.as_ref().map(exact_text);
        (found.positions.to_vec(), found.units.map(size).to_vec(), found.errors)
    });
    answer(columns, captured)
}

/// The seven values of each row of a CSV file in SI, as exact texts; empty ones where a value is missing.
#[pyfunction]
pub fn table_rows(py: Python<'_>, csv: Vec<u8>, unused: Vec<String>) -> PyResult<Answer<Vec<[String; 7]>>> {
    let (rows, captured) = in_background(py, move || capture_rows(csv, quantities(&unused)))?;
    Ok(answer(rows, captured))
}

fn quantities(keys: &[String]) -> Vec<Quantity> {
    Quantity::ALL.into_iter().filter(|quantity| keys.iter().any(|key| key == quantity.as_str())).collect()
}
