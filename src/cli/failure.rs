//! How a command ends badly, and with which exit code.

use std::fmt;
use std::io;
use std::path::Path;

use serde_json::{Value, json};
use slipmode::scene::{Fault, Faults, first_lines, visible};

use crate::cli::answer::SCHEMA;
use crate::cli::capture::has_output;
use crate::cli::terminal;

/// Exit code: a check failed.
pub const CHECK_FAILED: u8 = 1;
/// Exit code: bad input, or an output that cannot be written.
pub const BAD_INPUT: u8 = 2;

/// Why a command failed.
#[derive(Debug)]
pub enum Failure {
    /// The input is at fault: every fault found.
    Input(Faults),
    /// A file, a stream or the machine refuses.
    Refused(String),
    /// A check failed; what did is already on standard output.
    Check(String),
}

impl Failure {
    /// An action on a path that the operating system refuses.
    pub fn io(path: &Path, action: &str, error: &io::Error) -> Self {
        Self::Refused(format!("{}: {action}: {error}", path.display()))
    }

    /// Something the machine does not give.
    pub fn machine(what: &str, error: &dyn fmt::Display) -> Self {
        Self::Refused(format!("{what}: {error}"))
    }

    /// A place that is not written, and why.
    pub fn place(place: &Path, why: &str) -> Self {
        Self::Refused(format!("{}: {why}", place.display()))
    }

    /// What a write to standard output that did not succeed means. A reader that has gone wants no more of it, and the command
    /// goes on to its verdict; anything else is a failure.
    ///
    /// # Errors
    /// When the stream is there and does not take the bytes.
    pub fn of_standard_output(error: &io::Error) -> Result<(), Self> {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Ok(())
        } else {
            Err(Self::machine("standard output", error))
        }
    }

    /// Fails with the first of these lines; succeeds where there is none.
    ///
    /// # Errors
    /// When there is a line.
    pub fn check_none(lines: impl IntoIterator<Item = String>) -> Result<(), Self> {
        let lines = first_lines(lines, |more| format!("and {more} more; --json lists all"));
        if lines.is_empty() { Ok(()) } else { Err(Self::Check(lines.join("\n"))) }
    }

    /// The exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Refused(_) => BAD_INPUT,
            Self::Check(_) => CHECK_FAILED,
        }
    }

    /// Tells the user, one line a fault, the first ones when there are many; and the program that requested JSON.
    pub fn print(&self, as_json: bool) {
        match self {
            Self::Input(faults) => print_errors(faults.iter()),
            Self::Refused(message) => print_errors(message.lines()),
            Self::Check(message) => terminal::message(message),
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
        let _ = terminal::print_json(&json!({ "schema": SCHEMA, "errors": errors }));
    }
}

/// Prints the first errors, and how many more there are.
fn print_errors<E: fmt::Display>(errors: impl Iterator<Item = E>) {
    let lines = errors.map(|error| format!("error: {error}"));
    // Readers stop at some number of faults, so that there may be more than were found.
    let others = |more| format!("error: and at least {more} more like these");
    terminal::message(&first_lines(lines, others).join("\n"));
}

impl From<Faults> for Failure {
    fn from(faults: Faults) -> Self {
        Self::Input(faults)
    }
}

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Self {
        Self::Input(vec![fault])
    }
}
