//! Running other programs: always in the repository's root, never through a shell.

use std::env;
use std::ffi::{OsStr, OsString};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

use crate::failure::{Failure, Result, ensure};

/// The repository's root: the folder above this package.
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.parent().unwrap_or(package).to_path_buf()
}

/// A program in the repository's root, with the arguments that stand in `words`, separated by spaces.
pub fn program(program: impl AsRef<OsStr>, words: &str) -> Command {
    let mut command = Command::new(program);
    command.args(words.split_whitespace()).current_dir(root());
    command
}

/// The cargo that started this program.
pub fn cargo(words: &str) -> Command {
    program(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()), words)
}

/// The ways to run a command. Each fails when the program cannot be started.
pub trait Run {
    /// Runs it with its streams inherited and returns its exit code (1 when a signal ended it).
    fn code(&mut self) -> Result<u8>;

    /// Runs it; it has to succeed.
    fn check(&mut self) -> Result;

    /// Runs it quietly and returns what it printed on standard output; it has to succeed. Its standard error goes to ours.
    fn text(&mut self) -> Result<String>;

    /// Runs it, passes its standard output on line by line, hands each line to `listen`, and returns its exit code.
    fn listen(&mut self, listen: impl FnMut(&str)) -> Result<u8>;
}

impl Run for Command {
    fn code(&mut self) -> Result<u8> {
        self.status().map(code_of).map_err(|error| cannot_start(self, &error))
    }

    fn check(&mut self) -> Result {
        let code = self.code()?;
        ensure(code == 0, || Failure::check(format!("`{}` exited with {code}", words(self))))
    }

    fn text(&mut self) -> Result<String> {
        let output = self.stderr(Stdio::inherit()).output().map_err(|error| cannot_start(self, &error))?;
        ensure(output.status.success(), || Failure::check(format!("`{}` failed", words(self))))?;
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }

    fn listen(&mut self, mut listen: impl FnMut(&str)) -> Result<u8> {
        let mut child = self.stdout(Stdio::piped()).spawn().map_err(|error| cannot_start(self, &error))?;
        let lines = child.stdout.take().into_iter().flat_map(|output| BufReader::new(output).lines());
        for line in lines.map_while(|line| line.ok()) {
            println!("{line}");
            listen(&line);
        }
        child.wait().map(code_of).map_err(|error| cannot_start(self, &error))
    }
}

fn code_of(status: ExitStatus) -> u8 {
    status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)
}

/// Where a program is, as the shell would find it; the folders of daemons are looked through as well.
pub fn find_program(name: &str) -> Option<PathBuf> {
    let folders = search_path(None);
    let mut candidates = env::split_paths(&folders).map(|folder| folder.join(name));
    candidates.find(|path| path.is_file() || path.with_extension("exe").is_file())
}

/// The folders of programs, those of daemons included; the first may be another one.
pub fn search_path(first: Option<&Path>) -> OsString {
    let folders = env::var_os("PATH").unwrap_or_default();
    let daemons = ["/usr/sbin", "/sbin"].map(PathBuf::from);
    let all = first.map(PathBuf::from).into_iter().chain(env::split_paths(&folders)).chain(daemons);
    env::join_paths(all).unwrap_or(folders)
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
        assert_eq!(cargo("no-such-subcommand").stderr(Stdio::null()).check().unwrap_err().code, 1);
        assert_eq!(program("no-such-program-anywhere", "").check().unwrap_err().code, 2);
    }

    #[test]
    fn every_line_of_output_is_heard() {
        let mut heard = Vec::new();
        let code = cargo("--version").listen(|line| heard.push(line.to_string())).unwrap();
        assert_eq!(code, 0);
        assert!(heard.iter().any(|line| line.starts_with("cargo ")));
    }

    #[test]
    fn a_program_is_found_in_the_folders_of_programs_only() {
        assert!(find_program("cargo").is_some() && find_program("no-such-program-anywhere").is_none());
    }
}
