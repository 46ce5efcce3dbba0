//! `classify` of a point, and the coordinates and picture of a grid, as functions without a command line.

use pyo3::prelude::*;
use pyo3::types::PyByteArray;
use slipmode::cli::{Captured, ClassifiedPoint, capture_grid, capture_point, has_error_bar};

/// Two signs, spectral class, slip mode, max Re(s), max Im(s) in 1/s and the frequency in Hz.
type Fields = (i8, i8, &'static str, &'static str, f64, f64, f64);
/// Loading velocities and normal stresses as little-endian 64-bit numbers, and the picture as SVG.
type Grid<'py> = (Bound<'py, PyByteArray>, Bound<'py, PyByteArray>, String);
/// The exit code and the messages of the command, and its result unless it fails.
type Answer<T> = (u8, String, Option<T>);

/// Classifies the point of seven values, texts in the grammar of the command line; none where a value has an error bar.
#[pyfunction]
#[pyo3(signature = (values, inertial_threshold=None))]
pub fn classify_point(
    py: Python<'_>,
    values: [String; 7],
    inertial_threshold: Option<&str>,
) -> Option<Answer<Fields>> {
    let values = values.each_ref().map(String::as_str);
    if has_error_bar(values) {
        return None;
    }
    let (point, captured) = py.detach(|| capture_point(values, inertial_threshold));
    Some(answer(point.as_ref().map(fields), captured))
}

/// The object that `classify --json` prints of a point that [`classify_point`] has classified, as a text.
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

/// Draws the slip modes of a grid; each axis is `FROM:TO:N`.
#[pyfunction]
#[pyo3(signature = (slider, loading_velocity, normal_stress, inertial_threshold=None))]
pub fn draw_grid<'py>(
    py: Python<'py>,
    slider: [String; 5],
    loading_velocity: &str,
    normal_stress: &str,
    inertial_threshold: Option<&str>,
) -> Answer<Grid<'py>> {
    let slider = slider.each_ref().map(String::as_str);
    let axes = [loading_velocity, normal_stress];
    let (grid, captured) = py.detach(|| capture_grid(slider, axes, inertial_threshold));
    let bytes = |numbers: &[f64]| {
        PyByteArray::new(py, &numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>())
    };
    let columns =
        grid.map(|grid| (bytes(&grid.loading_velocity_m_per_s), bytes(&grid.normal_stress_pa), grid.svg));
    answer(columns, captured)
}

fn answer<T>(result: Option<T>, captured: Captured) -> Answer<T> {
    (captured.exit_code, String::from_utf8_lossy(&captured.messages).into_owned(), result)
}

fn fields(point: &ClassifiedPoint) -> Fields {
    let found = point.found();
    // Beyond the range of 64-bit numbers: infinity, zero or a number with fewer bits, as Python reads the decimal.
    let number = |value: slipmode_core::number::Wide| {
        value.to_f64().or_else(|| value.to_string().parse().ok()).unwrap_or(f64::NAN)
    };
    (
        found.transition_sign,
        found.boundary_sign,
        found.spectral_class.as_str(),
        point.slip_mode(),
        number(found.max_real_per_s),
        number(found.max_imaginary_per_s),
        point.frequency_hz().unwrap_or(f64::NAN),
    )
}
