//! Classification and roots of rows, by the routines of `classify --points` and of columns of points.

use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;
use slipmode::cli::unit_warnings;
use slipmode::scene::{Faults, Quantity, Uncertain};
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Dd, Wide};
use slipmode_core::stability::batch::classify_points as classify_rows;
use slipmode_core::stability::{
    Classification, Frequencies, InertialThreshold, SlipMode, classify, three_roots,
};

use crate::columns::{Given, PART, Rows, fill};
use crate::{input_error, threshold};

/// Bytes of a row: max Re(s), max Im(s), frequency; transition sign, boundary sign, spectral class, slip mode.
const WIDTHS: [usize; 7] = [8, 8, 8, 1, 1, 1, 1];
/// The code of a row with a missing value.
const MISSING: u8 = u8::MAX;

/// What is found of a row: two signs, the codes of class and mode, max Re(s), max Im(s) in 1/s and the frequency in Hz.
type Fields = (i8, i8, u8, u8, f64, f64, f64);

/// Classifies rows. Returns columns one behind the other: max Re(s), max Im(s) in 1/s and the frequency in Hz as 64-bit numbers, NaN
/// beyond their range; both signs, spectral class and slip mode as codes of 8 bits. Codes are -1 where a value is missing. The text
/// is the warning of the first row if every row looks as if it had another unit, or empty.
#[pyfunction]
#[pyo3(signature = (columns, length, inertial_threshold=None))]
pub fn classify_points<'py>(
    py: Python<'py>,
    columns: [Given; 7],
    length: usize,
    inertial_threshold: Option<&str>,
) -> PyResult<(Bound<'py, PyByteArray>, String)> {
    let rows = Rows::new(columns, length)?;
    let threshold = threshold(inertial_threshold)?;
    let with_unit = rows.with_unit();
    let look_alike = AtomicBool::new(true);
    let found = fill(py, length, WIDTHS, |first, mut cells| {
        let part = Part::read(&rows, first)?;
        cells[3..].iter_mut().for_each(|codes| codes.fill(MISSING));
        cells[..3].iter_mut().for_each(|numbers| numbers.as_chunks_mut().0.fill(f64::NAN.to_le_bytes()));
        for (row, fields) in part.classified(&rows, &threshold) {
            write(&mut cells, row - first, fields);
        }
        let is_in_doubt = |(_, point): &(usize, Parameters<Dd>)| !of_row(point, &with_unit).is_empty();
        if look_alike.load(Ordering::Relaxed) && !part.points.iter().all(is_in_doubt) {
            look_alike.store(false, Ordering::Relaxed);
        }
        Ok(())
    })?;
    let first = look_alike.into_inner().then(|| (0..length).find_map(|row| rows.doubled(row).ok()?));
    let warnings = first.flatten().map(|point| of_row(&point, &with_unit).join("; "));
    let warning = warnings.map(|text| format!("{text}; every row has a warning"));
    Ok((found, warning.unwrap_or_default()))
}

/// Classifies one row, of one value in each column; none where a value has an error bar. The text has the warnings about units, a
/// line each.
#[pyfunction]
#[pyo3(signature = (columns, inertial_threshold=None))]
pub fn classify_point(
    columns: [Given; 7],
    inertial_threshold: Option<&str>,
) -> PyResult<Option<(Fields, String)>> {
    if columns.iter().any(|(_, values, _)| values.is_uncertain()) {
        return Ok(None);
    }
    let rows = Rows::new(columns, 1)?;
    let threshold = threshold(inertial_threshold)?;
    let part = Part::read(&rows, 0).map_err(|faults| input_error(&faults))?;
    let warnings = part.points.iter().flat_map(|(_, point)| of_row(point, &rows.with_unit()));
    let warnings = warnings.collect::<Vec<_>>().join("\n");
    let found = part.classified(&rows, &threshold).next().map(|(_, fields)| fields);
    Ok(found.map(|found| (found, warnings)))
}

/// The three roots of rows, 1/s, each within `ROOT_ERROR` of its modulus: real and imaginary parts of each root as 64-bit numbers,
/// row by row; NaN where a value is missing and beyond the range of 64-bit numbers.
#[pyfunction]
pub fn roots_of_points<'py>(
    py: Python<'py>,
    columns: [Given; 7],
    length: usize,
) -> PyResult<Bound<'py, PyByteArray>> {
    let rows = Rows::new(columns, length)?;
    let beyond = [Complex::new(f64::NAN, f64::NAN); 3];
    fill(py, length, [48], |first, [cells]| {
        for (row, cell) in (first..).zip(cells.as_chunks_mut::<48>().0) {
            let roots = rows.doubled(row)?.map_or(beyond, |_| {
                let found = match rows.binary(row) {
                    Some(point) => three_roots(&point),
                    None => three_roots(&rows.exact(row)),
                };
                found.map_or(beyond, |found| found.roots)
            });
            let numbers = roots.iter().flat_map(|root| [root.re, root.im]);
            for (bytes, number) in cell.as_chunks_mut().0.iter_mut().zip(numbers) {
                *bytes = number.to_le_bytes();
            }
        }
        Ok(())
    })
}

/// The rows of a part that have all values.
struct Part {
    points: Vec<(usize, Parameters<Dd>)>,
}

impl Part {
    fn read(rows: &Rows, first: usize) -> Result<Self, Faults> {
        let mut points = Vec::with_capacity(PART.min(rows.length() - first));
        let mut faults = Faults::new();
        for row in first..rows.length().min(first + PART) {
            match rows.doubled(row) {
                Ok(point) => points.extend(point.map(|point| (row, point))),
                Err(own) => faults.extend(own),
            }
        }
        if faults.is_empty() { Ok(Self { points }) } else { Err(faults) }
    }

    fn classified<'p>(
        &'p self,
        rows: &'p Rows,
        threshold: &'p InertialThreshold,
    ) -> impl Iterator<Item = (usize, Fields)> + 'p {
        let doubled: Vec<Parameters<Dd>> = self.points.iter().map(|(_, point)| point.clone()).collect();
        let found = classify_rows(&doubled, threshold).into_iter();
        self.points.iter().zip(found).map(move |((row, doubled), found)| {
            // The exact values, where double-double does not decide.
            let found = found.unwrap_or_else(|| classify(&rows.exact(*row), threshold));
            let frequencies = Frequencies::quickly(doubled, &found)
                .unwrap_or_else(|| Frequencies::of(&rows.exact(*row), &found));
            (*row, fields(&found, &frequencies))
        })
    }
}

/// What looks like another unit in a row.
fn of_row(point: &Parameters<Dd>, with_unit: &[Quantity]) -> Vec<String> {
    unit_warnings(<[f64; 7]>::from(point.map(|value| value.hi())).map(Some), with_unit)
}

/// The codes are the places in the lists of all classes and all modes, which have the order of the declaration.
fn fields(found: &Classification, frequencies: &Frequencies) -> Fields {
    let mode = if found.transition_sign == 0 { SlipMode::ALL.len() } else { found.slip_mode as usize };
    let number = |value: Wide| value.to_f64().unwrap_or(f64::NAN);
    (
        found.transition_sign,
        found.boundary_sign,
        found.spectral_class as u8,
        mode as u8,
        number(found.max_real_per_s),
        number(found.max_imaginary_per_s),
        number(frequencies.frequency_hz),
    )
}

fn write(cells: &mut [&mut [u8]; 7], row: usize, (transition, boundary, class, mode, re, im, hz): Fields) {
    for (numbers, value) in cells.iter_mut().zip([re, im, hz]) {
        numbers.as_chunks_mut().0[row] = value.to_le_bytes();
    }
    let [_, _, _, codes @ ..] = cells;
    let [transition, boundary] = [transition, boundary].map(|sign| sign.to_le_bytes()[0]);
    for (codes, code) in codes.iter_mut().zip([transition, boundary, class, mode]) {
        codes[row] = code;
    }
}

/// Reads values of quantities, texts in the grammar of the command line, by these names in messages. Returns each as exact text in SI:
/// a decimal or a fraction, or `[lower, upper]` with an error bar.
#[pyfunction]
pub fn exact_values(names: Vec<String>, texts: Vec<String>, first: usize) -> PyResult<Vec<String>> {
    let mut faults = Faults::new();
    let quantities = &Quantity::ALL[first.min(Quantity::ALL.len())..];
    let read = |((of, name), text): ((&Quantity, String), String)| match Uncertain::of(*of, &text) {
        Ok(value) if value.is_certain() => exact_text(&value.lower),
        Ok(Uncertain { lower, upper }) => format!("[{}, {}]", exact_text(&lower), exact_text(&upper)),
        Err(problem) => {
            faults.push(crate::fault(name, text, problem));
            String::new()
        }
    };
    let values = quantities.iter().zip(names).zip(texts).map(read).collect();
    if faults.is_empty() { Ok(values) } else { Err(input_error(&faults)) }
}

/// Whether a text has the form of a value with an error bar.
#[pyfunction]
pub fn has_error_bar(text: &str) -> bool {
    Uncertain::is_meant(text)
}
