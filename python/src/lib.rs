//! `_slipmode`: what the Python package takes from the library. `python/slipmode` has everything that Python code can do itself.

mod call;
mod classified;
mod points;

use std::ffi::OsString;

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use slipmode::scene::{Fault, Faults, first_lines};
use slipmode_core::stability::{InertialThreshold, SlipMode, SpectralClass};

pyo3::create_exception!(_slipmode, InputError, PyValueError, "The input is at fault.");
pyo3::create_exception!(
    _slipmode,
    CheckFailed,
    PyRuntimeError,
    "A check failed, or a computation has no result."
);

/// The native part of the package `slipmode`.
#[pymodule]
mod _slipmode {
    #[pymodule_export]
    use super::call::call;
    #[pymodule_export]
    use super::classified::{classify_point, describe_point, draw_grid};
    #[pymodule_export]
    use super::points::{check_slider, classify_points};
    #[pymodule_export]
    use super::{CheckFailed, InputError, main};
    use super::{PyModule, PyModuleMethods, PyResult, classes, modes};
    use pyo3::Bound;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("SLIP_MODES", modes())?;
        module.add("SPECTRAL_CLASSES", classes())?;
        module.add("VERSION", env!("CARGO_PKG_VERSION"))
    }
}

/// Runs the command line with these arguments, the program's name first; returns the exit code.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| slipmode::cli::main_with(arguments))
}

/// The words of slip modes; a code is an index. On K = K_c the mode is neutral.
fn modes() -> Vec<&'static str> {
    SlipMode::ALL.iter().map(|mode| mode.as_str()).chain([SpectralClass::Neutral.as_str()]).collect()
}

/// The words of spectral classes; a code is an index.
fn classes() -> Vec<&'static str> {
    SpectralClass::ALL.iter().map(|class| class.as_str()).collect()
}

/// The exception of faults, one a line, the first ones when there are many.
fn input_error(faults: &Faults) -> PyErr {
    let others = |more| format!("and at least {more} more like these");
    InputError::new_err(first_lines(faults.iter().map(Fault::to_string), others).join("\n"))
}

/// The threshold of `--inertial-threshold`, that of the command line where none is given.
fn threshold(text: Option<&str>) -> PyResult<InertialThreshold> {
    let Some(text) = text else { return Ok(InertialThreshold::default()) };
    let fault = |problem| Fault {
        file: "classify".into(),
        line: None,
        key: "inertial_threshold".into(),
        value: Some(text.into()),
        problem,
    };
    slipmode::cli::inertial_threshold(text).map_err(|problem| input_error(&vec![fault(problem)]))
}
