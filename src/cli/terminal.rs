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

/// Lines of name, value and remark.
pub fn named_values(lines: &[(&str, String, &str)]) -> String {
    let line = |(name, value, note): &(&str, String, &str)| format!("{name:<26} {value}  {note}");
    lines.iter().map(line).map(|line| format!("{}\n", line.trim_end())).collect()
}
