//! How a command ends badly, and with which exit code.

use std::fmt;
use std::io;
use std::path::Path;

use slipmode::scene::{Fault, Faults, first_lines};

use crate::cli::path_text::shown_path;

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
    pub fn io(path: &Path, action: &str) -> impl Fn(io::Error) -> Self {
        move |error| Self::Refused(format!("{}: {action}: {error}", shown_path(path)))
    }

    /// Something the machine does not give.
    pub fn machine(what: &str, error: &dyn fmt::Display) -> Self {
        Self::Refused(format!("{what}: {error}"))
    }

    /// A place that is not written, and why.
    pub fn place(place: &Path, why: &str) -> Self {
        Self::Refused(format!("{}: {why}", shown_path(place)))
    }

    /// Faults of a place, a line each.
    pub fn place_lines(place: &Path, faults: impl IntoIterator<Item = impl fmt::Display>) -> Self {
        let lines = faults.into_iter().map(|fault| format!("{}: {fault}", shown_path(place)));
        Self::Refused(lines.collect::<Vec<_>>().join("\n"))
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
}

/// A write to an output that did not succeed; the error names the output.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Refused(error.to_string())
    }
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
