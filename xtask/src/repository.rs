//! Where the repository is, which files it has, and what git says of it.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, thread};

use crate::failure::{Failure, Result, ensure};
use crate::process::{Run, program, root};

/// The failure to read or write a file.
pub fn at(path: &Path) -> impl Fn(io::Error) -> Failure {
    move |error| Failure::bad_input(format!("{}: {error}", path.display()))
}

/// A file's text.
pub fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(at(path))
}

/// Writes a file, and the folders that it is in.
pub fn write(path: &Path, text: &str) -> Result {
    fs::create_dir_all(path.parent().unwrap_or(path)).and_then(|()| fs::write(path, text)).map_err(at(path))
}

/// Writes a file whose text is another by now. Whether it was.
pub fn rewrite(path: &Path, text: &str) -> Result<bool> {
    let differs = read(path).ok().as_deref() != Some(text);
    if differs { write(path, text).map(|()| true) } else { Ok(false) }
}

/// Copies a file, and makes the folders that its copy is in.
pub fn copy(from: &Path, to: &Path) -> Result {
    let copied = fs::create_dir_all(to.parent().unwrap_or(to)).and_then(|()| fs::copy(from, to));
    copied.map(drop).map_err(at(from))
}

/// Makes a folder that is empty.
pub fn make_empty(folder: &Path) -> Result {
    fs::remove_dir_all(folder).ok();
    fs::create_dir_all(folder).map_err(at(folder))
}

/// Runs this, unless the last run that succeeded had the same key.
pub fn once(stamp: &Path, key: &str, run: impl FnOnce() -> Result) -> Result {
    if read(stamp).is_ok_and(|used| used == key) {
        return Ok(());
    }
    // Written last: a run that failed or was killed is repeated.
    run().and_then(|()| write(stamp, key))
}

/// The rows of a list with ` | ` between the fields; lines that begin with `#` are comments.
pub fn rows<const FIELDS: usize>(list: &str) -> impl Iterator<Item = [&str; FIELDS]> {
    let lines = list.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split(" | ").collect::<Vec<_>>().try_into().ok())
}

/// A command of git in a repository.
pub fn git(root: &Path, words: &str) -> Command {
    let mut command = program("git", words);
    command.current_dir(root);
    command
}

/// The commit that is checked out.
pub fn commit(root: &Path) -> Result<String> {
    Ok(git(root, "rev-parse --short=12 HEAD").text()?.trim().to_owned())
}

/// The digest of a text, as git computes that of a file.
pub fn digest(text: &str) -> Result<String> {
    let (input, mut output) = io::pipe().map_err(at("git hash-object".as_ref()))?;
    thread::scope(|scope| {
        scope.spawn(move || output.write_all(text.as_bytes()));
        Ok(git(&root(), "hash-object --stdin").stdin(input).text()?.trim().to_owned())
    })
}

/// Paths of all files below a folder, relative to it, with `/`, sorted; build products and version control left out.
///
/// # Errors
/// When a folder cannot be read.
pub fn below(folder: &Path) -> Result<Vec<String>> {
    let mut found = Vec::new();
    for path in entries(folder)? {
        match file_name(&path) {
            name if ["target", ".git", "__pycache__"].contains(&name.as_str()) => {}
            name if path.is_dir() => {
                found.extend(below(&path)?.iter().map(|inner| format!("{name}/{inner}")))
            }
            name => found.push(name),
        }
    }
    found.sort();
    Ok(found)
}

/// The files below a folder that have this ending: path without it, and text.
///
/// # Errors
/// When a folder or a file cannot be read.
pub fn texts(folder: &Path, ending: &str) -> Result<Vec<(String, String)>> {
    let paths = below(folder)?;
    let found = paths.iter().filter_map(|path| Some((path.strip_suffix(ending)?, path)));
    found.map(|(name, path)| Ok((name.to_owned(), read(&folder.join(path))?))).collect()
}

/// The names of all report folders: those below `reports/` that hold a `report.toml`, sorted.
///
/// # Errors
/// When `reports/` cannot be read or holds no report at all.
pub fn reports() -> Result<Vec<String>> {
    let mut folders = entries(&root().join("reports"))?;
    folders.retain(|folder| folder.join("report.toml").is_file());
    folders.sort();
    ensure(!folders.is_empty(), || Failure::bad_input("reports/ holds no folder with a report.toml"))?;
    Ok(folders.iter().map(|folder| file_name(folder)).collect())
}

/// The paths in a folder, unsorted.
///
/// # Errors
/// When the folder cannot be read.
pub fn entries(folder: &Path) -> Result<Vec<PathBuf>> {
    fs::read_dir(folder).and_then(|all| all.map(|entry| Ok(entry?.path())).collect()).map_err(at(folder))
}

/// The last component of a path as text.
pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_the_lists_is_a_comment_or_a_row() {
        let complete = |name: &str, rows: usize| {
            let list = read(&root().join(name)).unwrap();
            assert_eq!(list.lines().filter(|line| !line.starts_with('#')).count(), rows, "{name}");
        };
        complete("xtask/tools.txt", rows::<3>(include_str!("../tools.txt")).count());
        complete(
            "xtask/validate/validators.txt",
            rows::<3>(include_str!("../validate/validators.txt")).count(),
        );
        complete(
            "xtask/tidy/refused_words.txt",
            rows::<6>(include_str!("../tidy/refused_words.txt")).count(),
        );
        complete("xtask/cluster/daemons.txt", rows::<2>(include_str!("../cluster/daemons.txt")).count());
        complete("xtask/tidy/floors.txt", rows::<2>(include_str!("../tidy/floors.txt")).count());
    }

    #[test]
    fn a_run_that_failed_or_had_another_key_is_repeated_and_one_that_succeeded_is_not() {
        let folder = std::env::temp_dir().join(format!("slipmode-once-{}", std::process::id()));
        let mut runs = 0;
        let mut attempt = |key: &str, result: Result| {
            once(&folder.join("stamp"), key, || {
                runs += 1;
                result
            })
        };
        assert!(attempt("a", Err(Failure::check("no network"))).is_err());
        assert!(attempt("a", Ok(())).is_ok() && attempt("a", Ok(())).is_ok() && attempt("b", Ok(())).is_ok());
        assert_eq!(runs, 3);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn another_text_has_another_digest() {
        assert_eq!(digest("").unwrap(), "e69de29bb2d1d6434b8b29ae775ad8c2e48c5391");
        assert_ne!(digest("a").unwrap(), digest("b").unwrap());
    }

    #[test]
    fn the_listing_has_this_file_and_no_build_products() {
        let files = below(&root()).unwrap();
        assert!(files.contains(&"xtask/src/repository.rs".to_string()));
        assert!(files.iter().all(|path| !path.starts_with("target/") && !path.starts_with(".git/")));
    }
}
