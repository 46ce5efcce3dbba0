//! The standard streams of a command: those of the process, or texts for a program that calls the command as a function.

use std::cell::{Cell, RefCell};
use std::ffi::OsString;
use std::io::{self, Write};

use clap::Parser;

use crate::cli::failure::{Failure, print_json_usage};
use crate::cli::progress::Progress;
use crate::cli::{Cli, asks_for_json, dispatch, without_usage_of_conflict};

/// What a command would have written, and its exit code.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Captured {
    /// The exit code of the process.
    pub exit_code: u8,
    /// Standard output.
    pub output: Vec<u8>,
    /// Standard error.
    pub messages: Vec<u8>,
}

thread_local! {
    /// The streams of the command that this thread captures.
    static STREAMS: RefCell<Option<Captured>> = const { RefCell::new(None) };
    /// Whether the command of this thread has written to standard output.
    static HAS_OUTPUT: Cell<bool> = const { Cell::new(false) };
}

/// Runs a command as a function: what it would write to the standard streams is returned.
///
/// The first argument is the name of the program. No signal is caught and no thread pool is started. The command must not read
/// standard input.
///
/// ```
/// let slider = "-a 0.004 -b 0.006 -d 10um -k 1e7 -m 1000 -s 1MPa -v 10um/s";
/// let arguments = format!("slipmode classify {slider} --json");
/// let found = slipmode::cli::capture(arguments.split(' ').map(Into::into));
/// assert_eq!(found.exit_code, 0);
/// assert!(String::from_utf8(found.output).unwrap().contains("\"slip_mode\": \"stick-slip\""));
/// ```
pub fn capture(arguments: impl IntoIterator<Item = OsString>) -> Captured {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let cli = match Cli::try_parse_from(&arguments) {
        Ok(cli) => cli,
        Err(error) => {
            let error = without_usage_of_conflict(error);
            let text = crate::cli::shortened_usage(&error).unwrap_or_else(|| error.render().to_string());
            let as_json = || {
                let print = || {
                    print_json_usage(&text);
                    Ok(())
                };
                captured(false, print).1.output
            };
            let (output, messages) = match error.use_stderr() {
                true => (if asks_for_json(&arguments) { as_json() } else { Vec::new() }, text.into_bytes()),
                false => (text.into_bytes(), Vec::new()),
            };
            return Captured { exit_code: crate::cli::exit_code_of_usage(&error), output, messages };
        }
    };
    captured(asks_for_json(&arguments), || dispatch(cli.command, Progress::new(true))).1
}

/// Does a part of a command as a function: returns its result unless it fails, and what it would write to the standard streams.
pub fn capture_work<T>(work: impl FnOnce() -> Result<T, Failure>) -> (Option<T>, Captured) {
    captured(false, work)
}

fn captured<T>(as_json: bool, work: impl FnOnce() -> Result<T, Failure>) -> (Option<T>, Captured) {
    STREAMS.with_borrow_mut(|streams| *streams = Some(Captured::default()));
    HAS_OUTPUT.set(false);
    let (done, exit_code) = match work() {
        Ok(done) => (Some(done), 0),
        Err(failure) => {
            failure.print(as_json);
            (None, failure.exit_code())
        }
    };
    let captured = STREAMS.with_borrow_mut(Option::take).unwrap_or_default();
    (done, Captured { exit_code, ..captured })
}

/// Whether this thread captures what a command writes.
pub fn is_capturing() -> bool {
    STREAMS.with_borrow(Option::is_some)
}

/// Whether the command of this thread has written to standard output.
pub fn has_output() -> bool {
    HAS_OUTPUT.get()
}

/// Standard output.
pub struct StandardOutput;

impl Write for StandardOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        HAS_OUTPUT.set(true);
        let captured = STREAMS.with_borrow_mut(|streams| streams.as_mut().map(|to| to.output.write(bytes)));
        captured.unwrap_or_else(|| io::stdout().lock().write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        if is_capturing() { Ok(()) } else { io::stdout().lock().flush() }
    }
}

/// Standard error.
pub struct StandardError;

impl Write for StandardError {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let captured = STREAMS.with_borrow_mut(|streams| streams.as_mut().map(|to| to.messages.write(bytes)));
        captured.unwrap_or_else(|| io::stderr().lock().write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        if is_capturing() { Ok(()) } else { io::stderr().lock().flush() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn captured(arguments: &str) -> Captured {
        capture(arguments.split(' ').map(OsString::from))
    }

    #[test]
    fn output_and_messages_are_returned_with_the_exit_code() {
        let slider = "-a 0.004 -b 0.006 -d 1e-5 -k 1e7 -m 1000";
        let found = captured(&format!("slipmode boundary {slider} --at-velocity 1e-5 --digits 5"));
        assert_eq!((found.exit_code, found.messages.len()), (0, 0));
        assert!(found.output.starts_with(b"arc,double_root,"));
        let refused = captured(&format!("slipmode roots {slider} -s 1e6 -v -1"));
        assert_eq!((refused.exit_code, refused.output.len()), (2, 0));
        assert!(String::from_utf8(refused.messages).unwrap().contains("--loading-velocity-m-per-s = -1"));
        assert!(!is_capturing());
    }

    #[test]
    fn help_is_output_and_wrong_usage_a_message() {
        let help = captured("slipmode --version");
        assert!(help.exit_code == 0 && help.output.starts_with(b"slipmode "));
        let wrong = captured("slipmode roots --nonsense");
        assert!(wrong.exit_code == 2 && wrong.output.is_empty() && !wrong.messages.is_empty());
        let wrong = captured("slipmode roots --nonsense --json");
        assert!(wrong.exit_code == 2 && wrong.output.starts_with(b"{\n  \"errors\": ["));
    }
}
