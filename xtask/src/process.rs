//! Running other programs: always in the repository's root, never through a shell.

use std::env;
use std::ffi::OsString;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::failure::Failure;
use crate::repository;

/// The cargo that started this program, in the repository's root.
pub fn cargo(arguments: &[&str]) -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(arguments).current_dir(repository::root());
    command
}

/// Runs a command with its streams inherited and returns its exit code (1 when a signal ended it).
///
/// # Errors
/// When the program cannot be started.
pub fn status(command: &mut Command) -> Result<u8, Failure> {
    let status = command.status().map_err(|error| cannot_start(command, &error))?;
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1))
}

/// Runs a command that has to succeed.
///
/// # Errors
/// When it cannot be started or does not exit with 0.
pub fn check(command: &mut Command) -> Result<(), Failure> {
    match status(command)? {
        0 => Ok(()),
        code => Err(Failure::check(format!("`{}` exited with {code}", words(command)))),
    }
}

/// Runs a command quietly and returns what it printed on standard output.
///
/// # Errors
/// When it cannot be started or does not exit with 0; its standard error goes to ours.
pub fn output(command: &mut Command) -> Result<String, Failure> {
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| cannot_start(command, &error))?;
    if !output.status.success() {
        return Err(Failure::check(format!("`{}` failed", words(command))));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Runs a command, passes its standard output on line by line, and hands each line to `listen`.
///
/// # Errors
/// When the program cannot be started.
pub fn listen(command: &mut Command, mut listen: impl FnMut(&str)) -> Result<u8, Failure> {
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|error| cannot_start(command, &error))?;
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).lines().map_while(Result::ok) {
            println!("{line}");
            listen(&line);
        }
    }
    let status = child.wait().map_err(|error| cannot_start(command, &error))?;
    Ok(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1))
}

/// Where a program is, as the shell would find it; the folders of daemons are looked through as well.
pub fn find_program(name: &str) -> Option<PathBuf> {
    let folders = search_path();
    let mut candidates = env::split_paths(&folders).map(|folder| folder.join(name));
    candidates.find(|path| path.is_file() || path.with_extension("exe").is_file())
}

/// The folders of programs, those of daemons included.
pub fn search_path() -> OsString {
    let folders = env::var_os("PATH").unwrap_or_default();
    let daemons = ["/usr/sbin", "/sbin"].map(PathBuf::from);
    env::join_paths(env::split_paths(&folders).chain(daemons)).unwrap_or(folders)
}

fn cannot_start(command: &Command, error: &std::io::Error) -> Failure {
    Failure::bad_input(format!("`{}` cannot be run: {error}", words(command)))
}

fn words(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default();
    let words = std::iter::once(program).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failing_program_is_a_failed_check_and_a_missing_one_is_bad_input() {
        let mut failing = cargo(&["no-such-subcommand"]);
        assert_eq!(check(failing.stderr(Stdio::null())).unwrap_err().code, 1);
        assert_eq!(check(&mut Command::new("no-such-program-anywhere")).unwrap_err().code, 2);
    }

    #[test]
    fn every_line_of_output_is_heard() {
        let mut heard = Vec::new();
        let code = listen(&mut cargo(&["--version"]), |line| heard.push(line.to_string())).unwrap();
        assert_eq!(code, 0);
        assert!(heard.iter().any(|line| line.starts_with("cargo ")));
    }

    #[test]
    fn a_program_is_found_in_the_folders_of_programs_only() {
        assert!(find_program("cargo").is_some() && find_program("no-such-program-anywhere").is_none());
    }
}
