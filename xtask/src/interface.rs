//! The interface of `slipmode-core`: how many functions it has, and `cargo xtask semver`, which compares it with the last release.

use crate::prelude::*;

/// More functions than these are no front page.
const MOST_FUNCTIONS: usize = 120;
/// How a page of rustdoc begins a method of the type itself.
const METHOD: &str = "class=\"method\">";

/// Counts the functions on the pages that rustdoc has made of the library. It makes none of hidden modules.
///
/// # Errors
/// When there are too many, or no page can be read.
pub fn count(target: &Path) -> Result {
    let on_page = |page: &PathBuf| match file_name(page) {
        name if name.starts_with("fn.") => Ok(1),
        name if name.ends_with(".html") => Ok(read(page)?.matches(METHOD).count()),
        _ => Ok(0),
    };
    let functions = entries(&target.join("doc/slipmode_core"))?.iter().map(on_page).sum::<Result<usize>>()?;
    println!("slipmode-core has {functions} public functions (at most {MOST_FUNCTIONS})");
    let wrong = || format!("slipmode-core: {functions} public functions, wanted: 1 to {MOST_FUNCTIONS}");
    ensure((1..=MOST_FUNCTIONS).contains(&functions), || Failure::check(wrong()))
}

/// Has `cargo-semver-checks` compare the interface with that of the last release before this commit.
///
/// # Errors
/// With exit code 1 when something was changed that the version does not permit.
pub fn semver() -> Result {
    let found = git(&root(), "describe --tags --abbrev=0 --match v[0-9]* HEAD^").output();
    // Without such a tag, git prints nothing on standard output.
    let found = found.map_err(at("git".as_ref()))?.stdout;
    match String::from_utf8_lossy(&found).trim() {
        "" => println!("semver: nothing to compare with: no release before this commit has a tag"),
        release if find_program("cargo-semver-checks").is_none() => {
            println!("semver: not compared with {release}: cargo-semver-checks is not installed");
        }
        release => {
            let words = format!("semver-checks --package slipmode-core --baseline-rev {release}");
            cargo(&words).check()?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_of_types_are_counted_and_those_of_traits_are_not() {
        let target = std::env::temp_dir().join(format!("slipmode-interface-{}", std::process::id()));
        let page = |name: &str, text: &str| {
            write(&target.join("doc/slipmode_core").join(name), text).unwrap();
        };
        page("index.html", "");
        assert!(count(&target).is_err(), "pages of another form");
        page("struct.A.html", "<section id=\"new\" class=\"method\"><section class=\"method trait-impl\">");
        assert!(count(&target).is_ok());
        page("struct.B.html", &"<section class=\"method\">".repeat(MOST_FUNCTIONS));
        assert_eq!(count(&target).unwrap_err().code, 1);
        std::fs::remove_dir_all(target).unwrap();
    }
}
