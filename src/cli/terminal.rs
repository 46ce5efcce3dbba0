//! Standard output, written whole or not at all, and standard error, with the errors of a command; no character of a message acts on
//! the terminal.

use std::fmt;
use std::io::Write;

use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::Styles;

use serde_json::{Value, json};
use slipmode::scene::{LONGEST_MESSAGE, first_lines, visible, with_short_quotations};

use crate::cli::failure::Failure;
use crate::cli::streams::{StandardOutput, has_output, is_capturing, write_messages};

/// The version of the JSON objects.
pub const SCHEMA: u32 = 1;

/// Writes a finished text to standard output. A reader that has gone is no failure.
///
/// # Errors
/// When it cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    // Every character but the ends of lines is made visible.
    print_raw(&text.split('\n').map(visible).collect::<Vec<_>>().join("\n"))
}

/// Writes a JSON value to standard output, indented.
///
/// # Errors
/// As [`print`].
pub fn print_json(value: &Value) -> Result<(), Failure> {
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
    let _ = write_messages(format!("{lines}\n").as_bytes());
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
pub fn count_of(count: impl fmt::Display + Copy, thing: &str) -> String {
    let count = count.to_string();
    let plural = if count == "1" { "" } else { "s" };
    format!("{count} {thing}{plural}")
}

impl Failure {
    /// Tells the user, one line a fault, the first ones when there are many; and the program that requested JSON.
    pub fn print(&self, as_json: bool) {
        match self {
            Self::Input(faults) => print_errors(faults.iter()),
            Self::Refused(message) => print_errors(message.lines()),
            Self::Check(text) => message(text),
        }
        if as_json {
            print_json_errors(match self {
                Self::Input(faults) => faults.iter().map(|fault| json!(fault)).collect(),
                Self::Refused(message) | Self::Check(message) => message.lines().map(json_error).collect(),
            });
        }
    }
}

/// An error without file, key and value.
fn json_error(line: &str) -> Value {
    json!({ "message": visible(line.trim_start_matches("error: ")) })
}

/// Prints wrong usage for the program that requested JSON.
pub fn print_json_usage(text: &str) {
    let is_said = |part: &&str| !part.starts_with("Usage:") && !part.starts_with("For more information");
    let plain = |part: &str| part.split_whitespace().collect::<Vec<_>>().join(" ");
    let parts: Vec<String> = text.trim().split("\n\n").take_while(is_said).map(plain).collect();
    print_json_errors(vec![json_error(&parts.join("; "))]);
}

/// What a command with `--json` prints in the place of its answer. One that has answered already prints no second value.
fn print_json_errors(errors: Vec<Value>) {
    if !has_output() {
        // Where standard output cannot be written, the messages and the exit code say enough.
        let _ = print_json(&json!({ "schema": SCHEMA, "errors": errors }));
    }
}

/// Prints the first errors, and how many more there are.
fn print_errors<E: fmt::Display>(errors: impl Iterator<Item = E>) {
    let lines = errors.map(|error| format!("error: {error}"));
    // Readers stop at some number of faults, so that there may be more than were found.
    let others = |more| format!("error: and at least {more} more like these");
    message(&first_lines(lines, others).join("\n"));
}
