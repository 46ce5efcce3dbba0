//! `cargo xtask lines`: lines of Rust code, without blank lines, comments and tests, compared with their bounds.

use crate::failure::Failure;
use crate::repository;
use crate::tidy::{self, TextFile};

/// Files that are counted together.
struct Group {
    name: &'static str,
    includes: fn(&str) -> bool,
    most_lines: usize,
}

const GROUPS: [Group; 2] = [
    Group {
        name: "src and crates, without crates/bench",
        includes: |path| {
            (path.starts_with("src/") || path.starts_with("crates/")) && !path.starts_with("crates/bench/")
        },
        most_lines: 38_000,
    },
    // 460 of them are `prove`, which decides what counts as proved by Coq, 90 are `wheel`, and 30 are `open-fields`.
    Group { name: "xtask", includes: |path| path.starts_with("xtask/"), most_lines: 2_600 },
];

/// Lines of code inside and outside tests.
#[derive(Debug, Default, PartialEq, Eq)]
struct Count {
    tests: usize,
    other: usize,
}

/// Prints the counts.
///
/// # Errors
/// When a file cannot be read, or a group has more lines than its bound.
pub fn run() -> Result<(), Failure> {
    let files = tidy::read(&repository::files()?)?;
    let mut exceeded = Vec::new();
    for Group { name, includes, most_lines } in GROUPS {
        let Count { other: lines, .. } = count(&files, includes);
        println!("{lines:6}  {name} (at most {most_lines})");
        if lines > most_lines {
            exceeded.push(format!("{name}: {lines} lines of code (allowed: at most {most_lines})"));
        }
    }
    println!("{:6}  tests of all packages", count(&files, |_| true).tests);
    if exceeded.is_empty() { Ok(()) } else { Err(Failure::check(exceeded.join("\n"))) }
}

fn count(files: &[TextFile], includes: fn(&str) -> bool) -> Count {
    let mut count = Count::default();
    for source in tidy::rust_sources(files).iter().filter(|source| includes(&source.file.path)) {
        for (number, ..) in source.lines().filter(|(_, _, text)| is_code(text)) {
            let kind = if source.is_test_line(number) { &mut count.tests } else { &mut count.other };
            *kind += 1;
        }
    }
    count
}

/// Whether a line is neither blank nor only a comment.
fn is_code(line: &str) -> bool {
    let line = line.trim_start();
    !line.is_empty() && !line.starts_with("//")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blank_lines_and_comments_are_left_out_and_tests_are_counted_apart() {
        let text = "//! A.\n\nfn a() {} // b\n    // c\n#[cfg(test)]\nmod tests {\n}\n";
        let file = TextFile { path: "src/a.rs".into(), text: text.into() };
        assert_eq!(count(&[file], |_| true), Count { tests: 3, other: 1 });
    }

    #[test]
    fn benchmarks_are_not_counted_with_the_library() {
        let [library, tasks] = GROUPS;
        assert!((library.includes)("src/a.rs") && (library.includes)("crates/core/src/a.rs"));
        assert!(!(library.includes)("crates/bench/src/a.rs") && !(library.includes)("tests/a.rs"));
        assert!((tasks.includes)("xtask/src/a.rs"));
    }
}
