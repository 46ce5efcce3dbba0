//! A command of the command line as a function that Ctrl-C stops waiting for.

use std::ffi::OsString;
use std::sync::LazyLock;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rayon::ThreadPoolBuilder;
use slipmode::cli::capture;

use crate::CheckFailed;

/// Between two looks at signals.
const TICK: Duration = Duration::from_millis(20);
/// The stack of a command, as large as that of a process.
const STACK_BYTES: usize = 8 << 20;
/// The process that loaded the module.
pub static LOADED_BY: LazyLock<u32> = LazyLock::new(std::process::id);

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
    builder.spawn(move || drop(to_us.send(on_own_threads(work)))).map_err(no_thread)?;
    loop {
        let received;
        (answer, received) = py.detach(move || {
            let received = answer.recv_timeout(TICK);
            (answer, received)
        });
        match received {
            Ok(found) => return found,
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(CheckFailed::new_err("the command ended without an answer"));
            }
        }
    }
}

/// Does work whose loops run on all processors; in a forked child on one. A child does not have the threads of its parent's pool,
/// for which such a loop would wait for ever.
pub fn on_own_threads<T: Send>(work: impl FnOnce() -> T + Send) -> PyResult<T> {
    if std::process::id() == *LOADED_BY {
        return Ok(work());
    }
    let pool = ThreadPoolBuilder::new().num_threads(1).stack_size(STACK_BYTES).build();
    pool.map(|pool| pool.install(work)).map_err(no_thread)
}

fn no_thread(error: impl std::error::Error) -> PyErr {
    CheckFailed::new_err(format!("no thread: {error}"))
}
