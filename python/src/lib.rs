//! `_slipmode`: what the Python package takes from the library. `python/slipmode` has everything that Python code can do itself.

mod call;
mod classified;
mod columns;
mod points;
mod table;

use std::ffi::OsString;

use pyo3::prelude::*;
use slipmode::scene::{Fault, Faults, Problem, first_lines};
use slipmode_core::roots::PrecisionLevel;
use slipmode_core::stability::{InertialThreshold, SlipMode, SpectralClass};

pyo3::import_exception!(slipmode._errors, CheckFailed);
pyo3::import_exception!(slipmode._errors, InputError);

/// The native part of the package `slipmode`.
///
/// It needs no lock of Python: it has no state but that of a thread, lists of files behind locks, and tables that are written once.
#[pymodule(gil_used = false)]
mod _slipmode {
    #[pymodule_export]
    use super::call::call;
    #[pymodule_export]
    use super::classified::{describe_point, draw_grid, roots_of_point};
    #[pymodule_export]
    use super::points::{classify_point, classify_points, exact_values, has_error_bar, roots_of_points};
    #[pymodule_export]
    use super::table::{table_columns, table_rows};
    use super::{PrecisionLevel, PyModule, PyModuleMethods, PyResult, SpectralClass, modes};
    #[pymodule_export]
    use super::{fitted_words, main};
    use pyo3::Bound;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        std::sync::LazyLock::force(&super::call::LOADED_BY);
        module.add("PRECISION_LEVELS", PrecisionLevel::ALL.map(|level| level.as_str()))?;
        module.add("RESULT_COLUMNS", slipmode::cli::RESULT_COLUMNS)?;
        module.add("SLIP_MODES", modes())?;
        module.add("SPECTRAL_CLASSES", SpectralClass::ALL.map(|class| class.as_str()))?;
        module.add("VERSION", env!("CARGO_PKG_VERSION"))
    }
}

/// Runs the command line with these arguments, the program's name first; returns the exit code.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| slipmode::cli::main_with(arguments))
}

/// A fitted value with its standard error, and its 95 % interval, as the command line prints them.
#[pyfunction]
fn fitted_words(value: f64, error: f64, low: Option<f64>, high: Option<f64>, unit: &str) -> [String; 2] {
    slipmode::experiments::fit::estimate_words(value, error, [low, high], unit)
}

/// The words of slip modes; a code is an index, as in the other lists. On K = K_c the mode is neutral.
fn modes() -> Vec<&'static str> {
    SlipMode::ALL.iter().map(|mode| mode.as_str()).chain([SpectralClass::Neutral.as_str()]).collect()
}

/// The exception of faults, one a line, the first ones when there are many.
fn input_error(faults: &Faults) -> PyErr {
    let others = |more| format!("and at least {more} more like these");
    // Without the place of a file.
    let message = |fault: &Fault| fault.to_string().trim_start_matches(": ").to_string();
    InputError::new_err(first_lines(faults.iter().map(message), others).join("\n"))
}

/// The threshold of `--inertial-threshold`, that of the command line where none is given.
fn threshold(text: Option<&str>) -> PyResult<InertialThreshold> {
    let Some(text) = text else { return Ok(InertialThreshold::default()) };
    let fault = |problem| fault("inertial_threshold".into(), text.into(), problem);
    slipmode::cli::inertial_threshold(text).map_err(|problem| input_error(&vec![fault(problem)]))
}

/// The fault of an argument.
fn fault(key: String, value: String, problem: Problem) -> Fault {
    Fault { file: String::new(), line: None, key, value: Some(value), problem }
}
