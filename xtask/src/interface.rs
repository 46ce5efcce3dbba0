//! The interface of `slipmode-core`: how many functions it has, and `cargo xtask semver`, which compares it with the last release.

use std::path::Path;

use crate::failure::Failure;
use crate::process;
use crate::repository::{entries, git, read, root};

/// More functions than these are no front page.
const MOST_FUNCTIONS: usize = 120;
/// How a page of rustdoc begins a method of the type itself.
const METHOD: &str = "class=\"method\">";

/// Counts the functions on the pages that rustdoc has made of the library. It makes none of hidden modules.
///
/// # Errors
/// When there are too many, or no page can be read.
pub fn count(target: &Path) -> Result<(), Failure> {
    let mut functions = 0;
    for page in entries(&target.join("doc/slipmode_core"))? {
        let name = crate::repository::file_name(&page);
        if name.starts_with("fn.") {
            functions += 1;
        } else if name.ends_with(".html") {
            functions += read(&page)?.matches(METHOD).count();
        }
    }
    println!("slipmode-core has {functions} public functions (at most {MOST_FUNCTIONS})");
    if (1..=MOST_FUNCTIONS).contains(&functions) {
        return Ok(());
    }
    Err(Failure::check(format!("slipmode-core: {functions} public functions, wanted: 1 to {MOST_FUNCTIONS}")))
}

/// Has `cargo-semver-checks` compare the interface with that of the last release before this commit.
///
/// # Errors
/// With exit code 1 when something was changed that the version does not permit.
pub fn semver() -> Result<(), Failure> {
    let words = ["describe", "--tags", "--abbrev=0", "--match", "v[0-9]*", "HEAD^"];
    let found = git(&root(), &words).output().map_err(|error| Failure::bad_input(format!("git: {error}")))?;
    let release = String::from_utf8_lossy(&found.stdout).trim().to_owned();
    if !found.status.success() || release.is_empty() {
        println!("semver: nothing to compare with: no release before this commit has a tag");
        return Ok(());
    }
    if process::find_program("cargo-semver-checks").is_none() {
        println!("semver: not compared with {release}: cargo-semver-checks is not installed");
        return Ok(());
    }
    let check = ["semver-checks", "--package", "slipmode-core", "--baseline-rev", &release];
    process::check(&mut process::cargo(&check))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_of_types_are_counted_and_those_of_traits_are_not() {
        let target = std::env::temp_dir().join(format!("slipmode-interface-{}", std::process::id()));
        let write = |name: &str, text: &str| {
            crate::repository::write(&target.join("doc/slipmode_core").join(name), text).unwrap();
        };
        write("index.html", "");
        assert!(count(&target).is_err(), "pages of another form");
        write("struct.A.html", "<section id=\"new\" class=\"method\"><section class=\"method trait-impl\">");
        assert!(count(&target).is_ok());
        write("struct.B.html", &"<section class=\"method\">".repeat(MOST_FUNCTIONS));
        assert_eq!(count(&target).unwrap_err().code, 1);
        std::fs::remove_dir_all(target).unwrap();
    }
}
