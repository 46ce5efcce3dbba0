//! Running other programs in the repository's root, never through a shell.

use std::env;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::repository;

/// The cargo that started this program, with the arguments that stand in `words`, separated by spaces.
pub fn cargo(words: &str) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(words.split_whitespace()).current_dir(repository::root());
    command
}

/// What the compiler says of its version; empty when it cannot be asked.
pub fn rustc_version() -> String {
    let mut command = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    let version = output(command.arg("--version").current_dir(repository::root()));
    version.map_or_else(|_| String::new(), |version| version.trim().to_string())
}

/// Builds the command line with the profile `dist` as the lock file says, and returns its path.
///
/// # Errors
/// When the build fails.
pub fn build_dist() -> Result<PathBuf, String> {
    check(&mut cargo("build --profile dist --locked --bin slipmode"))?;
    Ok(repository::root().join("target/dist/slipmode"))
}

/// Runs a command that has to succeed.
///
/// # Errors
/// When it cannot be started or does not exit with 0.
pub fn check(command: &mut Command) -> Result<(), String> {
    let status = command.status().map_err(|error| format!("{}: {error}", words(command)))?;
    if status.success() { Ok(()) } else { Err(format!("`{}`: {status}", words(command))) }
}

/// Runs a command and returns what it printed on standard output.
///
/// # Errors
/// When it cannot be started or does not exit with 0.
pub fn output(command: &mut Command) -> Result<String, String> {
    let output = command.stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("{}: {error}", words(command)))?;
    if !output.status.success() {
        return Err(format!("`{}`: {}", words(command), output.status));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn words(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}
