//! How a command ends badly, and with which exit code.

use std::fmt;
use std::io;
use std::path::Path;

use slipmode::scene::{Fault, Faults};

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
    /// The reader of our output has gone; nothing is left to do or say.
    ReaderGone,
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

    /// A write to standard output that did not succeed.
    pub fn standard_output(error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::ReaderGone
        } else {
            Self::machine("standard output", error)
        }
    }

    /// The exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Refused(_) => BAD_INPUT,
            Self::Check(_) => CHECK_FAILED,
            Self::ReaderGone => 0,
        }
    }

    /// Tells the user, one line a fault.
    pub fn print(&self) {
        match self {
            Self::Input(faults) => {
                for fault in faults {
                    eprintln!("error: {fault}");
                }
            }
            Self::Refused(message) => {
                for line in message.lines() {
                    eprintln!("error: {line}");
                }
            }
            Self::Check(message) => eprintln!("{message}"),
            Self::ReaderGone => {}
        }
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
