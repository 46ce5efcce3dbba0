//! Classification and roots of rows, by the routines of `classify --points` and of columns of points.

use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use slipmode::cli::{Derived, unit_warnings};
use slipmode::scene::{Faults, Quantity, Uncertain};
use slipmode_core::friction::Parameters;
use slipmode_core::number::Dd;
use slipmode_core::number::format::exact_text;
use slipmode_core::stability::batch::classify_points as classify_rows;
use slipmode_core::stability::{
    Classification, Frequencies, InertialThreshold, SlipMode, classify, three_roots,
};

use crate::columns::{Given, PART, Rows, Values, fill};
use crate::{input_error, threshold};

/// The numbers of a row.
const NUMBERS: usize = 6;
/// The code of a row with a missing value.
const MISSING: u8 = u8::MAX;

/// What is found of a row. Numbers: max Re(s), max Im(s) in 1/s, frequency in Hz; K_c, K/K_c, ω/ω_n. Codes: transition sign, boundary
/// sign, spectral class, slip mode; precision level.
type Fields = ([f64; NUMBERS], [i8; 5]);

/// Classifies rows. Returns columns one behind the other: the numbers of a row as 64-bit numbers, NaN beyond their range, then the codes
/// of 8 bits; without `is_whole`, K_c, K/K_c, ω/ω_n and the precision level are left out. Codes are -1 where a value is missing. The
/// text is the warning of the first row if every row looks as if it had another unit, or empty.
#[pyfunction]
pub fn classify_points<'py>(
    py: Python<'py>,
    columns: [Given; 7],
    length: usize,
    inertial_threshold: Option<&str>,
    is_whole: bool,
) -> PyResult<(Bound<'py, PyBytes>, String)> {
    let rows = Rows::new(columns, length)?;
    let threshold = threshold(inertial_threshold)?;
    let with_unit = rows.with_unit();
    let look_alike = AtomicBool::new(true);
    let (number, code) = if is_whole { (8, 1) } else { (0, 0) };
    let widths = [8, 8, 8, number, number, number, 1, 1, 1, 1, code];
    let found = fill(py, length, widths, |first, mut cells| {
        let part = read(&rows, first)?;
        cells[NUMBERS..].iter_mut().for_each(|codes| codes.fill(MISSING));
        cells[..NUMBERS]
            .iter_mut()
            .for_each(|numbers| numbers.as_chunks_mut().0.fill(f64::NAN.to_le_bytes()));
        for (row, fields) in classified(&part, &rows, &threshold, is_whole) {
            write(&mut cells, row - first, fields);
        }
        let is_in_doubt = |(_, point): &(usize, Parameters<Dd>)| !of_row(point, &with_unit).is_empty();
        if look_alike.load(Ordering::Relaxed) && !part.iter().all(is_in_doubt) {
            look_alike.store(false, Ordering::Relaxed);
        }
        Ok(())
    })?;
    let first = look_alike.into_inner().then(|| (0..length).find_map(|row| rows.doubled(row).ok()?));
    let warning = |point| of_row(&point, &with_unit).join("; ") + "; every row has a warning";
    Ok((found, first.flatten().map(warning).unwrap_or_default()))
}

/// Classifies one row, of one value in each column; none where a value has an error bar. The text has the warnings about units, a
/// line each.
#[pyfunction]
#[pyo3(signature = (columns, inertial_threshold=None))]
pub fn classify_point(
    columns: [Given; 7],
    inertial_threshold: Option<&str>,
) -> PyResult<Option<(Fields, String)>> {
    let is_wide = |(of, (_, values, _)): (Quantity, &Given)| matches!(values, Values::Text(text) if Uncertain::is_wide(of, text));
    if Quantity::ALL.into_iter().zip(&columns).any(is_wide) {
        return Ok(None);
    }
    let rows = Rows::new(columns, 1)?;
    let threshold = threshold(inertial_threshold)?;
    let part = read(&rows, 0).map_err(|faults| input_error(&faults))?;
    let warnings = part.iter().flat_map(|(_, point)| of_row(point, &rows.with_unit()));
    let warnings = warnings.collect::<Vec<_>>().join("\n");
    let found = classified(&part, &rows, &threshold, false).next().map(|(_, fields)| fields);
    Ok(found.map(|found| (found, warnings)))
}

/// The three roots of rows, 1/s, each within `ROOT_ERROR` of its modulus: real and imaginary parts of each root as 64-bit numbers,
/// row by row; NaN where a value is missing and beyond the range of 64-bit numbers.
#[pyfunction]
pub fn roots_of_points<'py>(
    py: Python<'py>,
    columns: [Given; 7],
    length: usize,
) -> PyResult<Bound<'py, PyBytes>> {
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
type Part = Vec<(usize, Parameters<Dd>)>;

fn read(rows: &Rows, first: usize) -> Result<Part, Faults> {
    let mut points = Vec::with_capacity(PART.min(rows.length - first));
    let mut faults = Faults::new();
    for row in first..rows.length.min(first + PART) {
        match rows.doubled(row) {
            Ok(point) => points.extend(point.map(|point| (row, point))),
            Err(own) => faults.extend(own),
        }
    }
    if faults.is_empty() { Ok(points) } else { Err(faults) }
}

fn classified<'p>(
    part: &'p [(usize, Parameters<Dd>)],
    rows: &'p Rows,
    threshold: &'p InertialThreshold,
    is_whole: bool,
) -> impl Iterator<Item = (usize, Fields)> + 'p {
    let doubled: Vec<Parameters<Dd>> = part.iter().map(|(_, point)| point.clone()).collect();
    let found = classify_rows(&doubled, threshold).into_iter();
    part.iter().zip(found).map(move |((row, doubled), found)| {
        // The exact values, where double-double does not decide.
        let found = found.unwrap_or_else(|| classify(&rows.exact(*row), threshold));
        if !is_whole {
            let frequencies = Frequencies::quickly(doubled, &found)
                .unwrap_or_else(|| Frequencies::of(&rows.exact(*row), &found));
            return (*row, fields(&found, [frequencies.frequency_hz.to_f64(), None, None, None]));
        }
        let derived =
            Derived::quickly(doubled, &found).unwrap_or_else(|| Derived::of(&rows.exact(*row), &found));
        let (critical, ratio) = (derived.critical_stiffness_pa_per_m, derived.stiffness_over_critical);
        let further = [derived.frequency_hz, critical, ratio, derived.frequency_over_natural];
        (*row, fields(&found, further))
    })
}

/// What looks like another unit in a row.
fn of_row(point: &Parameters<Dd>, with_unit: &[Quantity]) -> Vec<String> {
    unit_warnings(<[f64; 7]>::from(point.map(|value| value.hi())).map(Some), with_unit)
}

/// The codes are the places in the lists of all words, which have the order of the declaration.
fn fields(found: &Classification, [hertz, critical, ratio, natural]: [Option<f64>; 4]) -> Fields {
    let mode = if found.transition_sign == 0 { SlipMode::ALL.len() } else { found.slip_mode as usize };
    let [real, imaginary] = [found.max_real_per_s, found.max_imaginary_per_s].map(|rate| rate.to_f64());
    let numbers = [real, imaginary, hertz, critical, ratio, natural].map(|value| value.unwrap_or(f64::NAN));
    let [class, level] = [found.spectral_class as i8, found.precision_level as i8];
    (numbers, [found.transition_sign, found.boundary_sign, class, mode as i8, level])
}

fn write(cells: &mut [&mut [u8]; 11], row: usize, (numbers, codes): Fields) {
    let (of_numbers, of_codes) = cells.split_at_mut(NUMBERS);
    for (cells, value) in of_numbers.iter_mut().zip(numbers) {
        if let Some(cell) = cells.as_chunks_mut().0.get_mut(row) {
            *cell = value.to_le_bytes();
        }
    }
    for (cells, code) in of_codes.iter_mut().zip(codes) {
        if let Some(cell) = cells.get_mut(row) {
            *cell = code.to_le_bytes()[0];
        }
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
