//! A command of the command line as a function that Ctrl-C stops waiting for.

use std::ffi::OsString;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use slipmode::cli::capture;

/// Between two looks at signals.
const TICK: Duration = Duration::from_millis(20);
/// The stack of a command, as large as that of a process.
const STACK_BYTES: usize = 8 << 20;

/// Runs a command; returns its exit code, its standard output, and its standard error.
///
/// Other threads of Python run meanwhile. Ctrl-C raises `KeyboardInterrupt` at once; the command then ends in the background, and
/// its result is dropped.
#[pyfunction]
pub fn call(py: Python<'_>, arguments: Vec<OsString>) -> PyResult<(u8, Bound<'_, PyBytes>, String)> {
    let program = OsString::from("slipmode");
    let found = in_background(py, move || capture([program].into_iter().chain(arguments)))?;
    let messages = String::from_utf8_lossy(&found.messages).into_owned();
    Ok((found.exit_code, PyBytes::new(py, &found.output), messages))
}

/// Does work on a thread of its own, for which Ctrl-C does not wait.
pub fn in_background<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (to_us, mut answer) = channel();
    let builder = std::thread::Builder::new().name("slipmode".into()).stack_size(STACK_BYTES);
    // Nobody waits for the answer after Ctrl-C.
    let spawned = builder.spawn(move || drop(to_us.send(work())));
    spawned.map_err(|error| PyRuntimeError::new_err(format!("no thread: {error}")))?;
    loop {
        let received;
        (answer, received) = py.detach(move || {
            let received = answer.recv_timeout(TICK);
            (answer, received)
        });
        match received {
            Ok(found) => return Ok(found),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the command ended without an answer"));
            }
        }
    }
}
