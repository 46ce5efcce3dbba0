//! Standard output, written whole or not at all, and standard error; no character of a message acts on the terminal.

use std::io::Write;

use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::Styles;

use slipmode::scene::{LONGEST_MESSAGE, visible, with_short_quotations};

use crate::cli::capture::{StandardError, StandardOutput, is_capturing};
use crate::cli::failure::Failure;

/// Writes a finished text to standard output. A reader that has gone is no failure.
///
/// # Errors
/// When it cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    print_raw(&visible_lines(text))
}

/// Writes a JSON value to standard output, indented.
///
/// # Errors
/// As [`print`].
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    // JSON has escapes of its own for control characters.
    print_raw(&format!("{value:#}\n"))
}

fn print_raw(text: &str) -> Result<(), Failure> {
    let written = StandardOutput.write_all(text.as_bytes()).and_then(|()| StandardOutput.flush());
    written.or_else(|error| Failure::of_standard_output(&error))
}

/// Writes lines to standard error. Where it cannot be written, result and exit code are the same without them.
pub fn message(text: &str) {
    let line = |line: &str| coloured(with_short_quotations(&visible(line), LONGEST_MESSAGE));
    let lines = text.split('\n').map(line).collect::<Vec<_>>().join("\n");
    let _ = StandardError.write_all(format!("{lines}\n").as_bytes());
}

/// A line with the word it begins with in the colours of the command line's own errors, where a terminal shows them.
fn coloured(line: String) -> String {
    let styles = Styles::styled();
    let kinds = [("error:", styles.get_error()), ("warning:", styles.get_context())];
    let found = kinds.into_iter().find_map(|(word, style)| Some((word, style, line.strip_prefix(word)?)));
    let is_plain = is_capturing() || AutoStream::choice(&std::io::stderr()) == ColorChoice::Never;
    match found.filter(|_| !is_plain) {
        Some((word, style, rest)) => format!("{style}{word}{style:#}{rest}"),
        None => line,
    }
}

/// A number of things: `1 row`, `2 rows`.
pub fn count_of(count: usize, thing: &str) -> String {
    match count {
        1 => format!("1 {thing}"),
        count => format!("{count} {thing}s"),
    }
}

/// The text with every character but the ends of lines made visible.
fn visible_lines(text: &str) -> String {
    text.split('\n').map(visible).collect::<Vec<_>>().join("\n")
}
