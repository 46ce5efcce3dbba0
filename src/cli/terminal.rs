//! Standard output: written whole or not at all, and silent when its reader has gone.

use std::io::{self, Write};

use crate::cli::failure::Failure;

/// Writes a finished text to standard output.
///
/// # Errors
/// When it cannot be written, also when the reader has gone.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush())
        .map_err(|error| Failure::standard_output(&error))
}

/// Writes a JSON value to standard output, indented.
///
/// # Errors
/// As [`print`].
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    print(&format!("{value:#}\n"))
}
