//! The one error of this program: a message for people and the exit code that goes with it.

/// What a task gives.
pub type Result<T = (), E = Failure> = std::result::Result<T, E>;

/// Why a command did not succeed.
#[derive(Debug)]
pub struct Failure {
    /// 1 when a check failed, 2 on bad input or a machine that lacks something.
    pub code: u8,
    /// One or more lines for standard error.
    pub message: String,
}

/// The failure, unless this is so.
pub fn ensure(is_so: bool, failure: impl FnOnce() -> Failure) -> Result {
    if is_so { Ok(()) } else { Err(failure()) }
}

impl Failure {
    /// A check failed (exit code 1).
    pub fn check(message: impl Into<String>) -> Self {
        Self { code: 1, message: message.into() }
    }

    /// Bad usage, or a machine or repository that lacks something (exit code 2).
    pub fn bad_input(message: impl Into<String>) -> Self {
        Self { code: 2, message: message.into() }
    }

    /// Success when an exit code is 0; otherwise a failure with the same code.
    pub fn of_exit(code: u8, what: &str) -> Result {
        ensure(code == 0, || Self { code, message: format!("{what} exited with {code}") })
    }
}
