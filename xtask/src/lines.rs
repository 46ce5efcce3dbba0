//! `cargo xtask lines`: lines of Rust code of each folder, without blank lines, comments and tests, compared with their bounds.
//!
//! `xtask/lines.csv` has the bounds. They only fall: `--lower` sets each to today's count, and refuses a count above it.

use crate::prelude::*;
use crate::tidy::{self, Source};

const TABLE: &str = "xtask/lines.csv";
const HEADER: &str = "folder,at_most\n";

/// Prints the counts; lowers the bounds when asked.
///
/// # Errors
/// When a file cannot be read, or a folder has more lines than its bound.
pub fn run(option: &str) -> Result {
    let (counts, tests) = count(&tidy::read(&below(&root())?)?);
    let table = root().join(TABLE);
    compare(&counts, &read(&table)?)?;
    if option == "--lower" {
        let rows = counts.iter().map(|(folder, count)| format!("{folder},{count}\n"));
        write(&table, &format!("{HEADER}{}", rows.collect::<String>()))?;
    }
    let (all, folders) = (counts.values().sum::<usize>(), counts.len());
    println!("lines: {all} of code in {folders} folders, {tests} of tests");
    Ok(())
}

/// Prints each count with its bound.
fn compare(counts: &BTreeMap<String, usize>, table: &str) -> Result {
    let mut exceeded = Vec::new();
    for (folder, lines) in counts {
        let bound = |row: &str| row.strip_prefix(&format!("{folder},"))?.parse::<usize>().ok();
        let bound = table.lines().find_map(bound);
        let allowed = bound.map_or("no bound".to_owned(), |most| format!("at most {most}"));
        if bound.is_some_and(|most| *lines <= most) {
            println!("{lines:6}  {folder} ({allowed})");
        } else {
            exceeded.push(format!("{folder}: {lines} lines of code, {allowed} in {TABLE}"));
        }
    }
    ensure(exceeded.is_empty(), || Failure::check(exceeded.join("\n")))
}

/// Lines of code of each folder, and lines of tests.
fn count(files: &[Source]) -> (BTreeMap<String, usize>, usize) {
    let (mut folders, mut tests) = (BTreeMap::new(), 0);
    for source in files.iter().filter(|file| file.is_rust()) {
        let folder = folder(&source.path);
        for (number, ..) in source.lines().filter(|(_, _, text)| is_code(text)) {
            let is_test = source.is_test_line(number);
            *if is_test { &mut tests } else { folders.entry(folder.clone()).or_insert(0) } += 1;
        }
    }
    (folders, tests)
}

/// The folder with whose files a file is counted: one of the root's, or one below `src` and `crates`.
fn folder(path: &str) -> String {
    let folders: Vec<&str> = path.rsplit_once('/').map_or(".", |(folder, _)| folder).split('/').collect();
    let depth = if ["src", "crates"].contains(&folders[0]) { 2 } else { 1 };
    folders[..depth.min(folders.len())].join("/")
}

/// Whether a line is neither blank nor only a comment.
fn is_code(line: &str) -> bool {
    !line.trim_start().is_empty() && !line.trim_start().starts_with("//")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blank_lines_and_comments_are_left_out_and_tests_are_counted_apart() {
        let text = "//! A.\n\nfn a() {} // b\n    // c\n#[cfg(test)]\nmod tests {\n}\n";
        assert_eq!(count(&[Source::new("src/a/b.rs", text)]), (BTreeMap::from([("src/a".to_owned(), 1)]), 3));
    }

    #[test]
    fn a_file_is_counted_with_its_module_its_package_or_its_folder() {
        let paths =
            ["src/a/b/c.rs", "src/main.rs", "crates/core/src/a.rs", "xtask/src/tidy/a.rs", "build.rs"];
        assert_eq!(paths.map(folder), ["src/a", "src", "crates/core", "xtask", "."]);
    }

    #[test]
    fn more_lines_than_the_bound_and_a_folder_without_one_are_refused() {
        let counts = BTreeMap::from([("src/a".to_owned(), 7)]);
        let code = |table: &str| compare(&counts, table).map_err(|failure| failure.code);
        assert_eq!(code("folder,at_most\nsrc/a,7\n"), Ok(()));
        assert_eq!(code("folder,at_most\nsrc/a,6\n"), Err(1));
        assert_eq!(code("folder,at_most\nsrc,7\n"), Err(1));
    }
}
