//! All that `classify` states of a point, its roots, and the coordinates and picture of a grid, as functions without a command line.

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use slipmode::cli::{Captured, capture_grid, capture_point, capture_roots};

use crate::call::in_background;

/// Loading velocities and normal stresses as little-endian 64-bit numbers, and the picture as SVG.
type Grid<'py> = (Bound<'py, PyBytes>, Bound<'py, PyBytes>, String);
/// The exit code and the messages of the command, and its result unless it fails.
pub type Answer<T> = (u8, String, Option<T>);

/// The object that `classify --json` prints of a point without error bars, as a text.
#[pyfunction]
#[pyo3(signature = (values, inertial_threshold=None))]
pub fn describe_point(
    py: Python<'_>,
    values: [String; 7],
    inertial_threshold: Option<&str>,
) -> Option<String> {
    let values = values.each_ref().map(String::as_str);
    py.detach(|| Some(capture_point(values, inertial_threshold).0?.json().to_string()))
}

/// The list that `roots --json` prints of a point; [`crate::call::call`] says how Ctrl-C ends it.
#[pyfunction]
pub fn roots_of_point(py: Python<'_>, values: [String; 7], digits: String) -> PyResult<Answer<String>> {
    let work = move || capture_roots(values.each_ref().map(String::as_str), &digits);
    let (roots, captured) = in_background(py, work)?;
    Ok(answer(roots, captured))
}

/// Draws the slip modes of a grid, whose axes, V0 and σ, are `FROM:TO:N`.
#[pyfunction]
#[pyo3(signature = (slider, axes, inertial_threshold=None))]
pub fn draw_grid(
    py: Python<'_>,
    slider: [String; 5],
    axes: [String; 2],
    inertial_threshold: Option<String>,
) -> PyResult<Answer<Grid<'_>>> {
    let work = move || {
        let (slider, axes) = (slider.each_ref().map(String::as_str), axes.each_ref().map(String::as_str));
        capture_grid(slider, axes, inertial_threshold.as_deref())
    };
    let (grid, captured) = in_background(py, work)?;
    let bytes = |numbers: &[f64]| {
        PyBytes::new(py, &numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>())
    };
    let columns =
        grid.map(|grid| (bytes(&grid.loading_velocity_m_per_s), bytes(&grid.normal_stress_pa), grid.svg));
    Ok(answer(columns, captured))
}

/// A result with the exit code and the messages of the command.
pub fn answer<T>(result: Option<T>, captured: Captured) -> Answer<T> {
    (captured.exit_code, String::from_utf8_lossy(&captured.messages).into_owned(), result)
}
