//! The standard streams of a command: those of the process, or texts for a program that calls the command as a function.

use std::cell::{Cell, RefCell};
use std::io::{self, Write};

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

/// Does work, and returns what it writes to the standard streams with exit code 0.
pub fn written_by<T>(work: impl FnOnce() -> T) -> (T, Captured) {
    STREAMS.with_borrow_mut(|streams| *streams = Some(Captured::default()));
    HAS_OUTPUT.set(false);
    (work(), STREAMS.with_borrow_mut(Option::take).unwrap_or_default())
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

/// Writes to standard error.
pub fn write_messages(bytes: &[u8]) -> io::Result<()> {
    let captured = STREAMS.with_borrow_mut(|streams| streams.as_mut().map(|to| to.messages.write_all(bytes)));
    captured.unwrap_or_else(|| io::stderr().lock().write_all(bytes))
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;

    use super::*;
    use crate::cli::capture;

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
