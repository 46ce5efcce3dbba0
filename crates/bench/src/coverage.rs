//! `cargo xtask coverage`: how many lines of each module the tests run, and `verify` of the reports beside them, by
//! cargo-llvm-cov, into `crates/bench/results/coverage.csv`.
//!
//! A unit test runs all of its own lines, so they are left out: files and modules under `#[cfg(test)]`, which stand
//! at the end of a file. Examples in the documentation, benchmarks and this package are not run for it.
//! `cargo xtask timings` makes the result an input of the report on the paper.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use crate::{measured_on, process, repository};

const TOOL: &str = "cargo-llvm-cov";
const FILE: &str = "coverage.csv";
const HEADER: &str = "module,lines,by_tests,with_verify,most_left_in";

/// Of so many files of a module it is said how many lines are left.
const FILES_NAMED: usize = 3;

/// Runs all tests on an instrumented build, then `verify` of every report, and writes which lines they ran.
///
/// # Errors
/// Without the tool, or when the build fails or the file cannot be written. A test that fails is named, and no error:
/// slower code exceeds a limit of time first, and it ran its lines all the same.
pub fn run() -> Result<(), String> {
    if tool("--version").output().is_ok_and(|output| !output.status.success()) {
        return Err(format!(
            "coverage wants {TOOL}: `cargo install {TOOL}` and `rustup component add llvm-tools`"
        ));
    }
    process::check(&mut tool("clean --workspace"))?;
    let measured = "--no-report --ignore-run-fail --locked";
    let packages = "--package slipmode --package slipmode-core --package slipmode-plot";
    process::check(&mut tool(&format!("--lib --bins --test suite {packages} {measured}")))?;
    let by_tests = record()?;
    for report in repository::reports()? {
        let verify = format!("verify reports/{report} -o target/coverage-report");
        process::check(&mut tool(&format!("run {measured} -- {verify}")))?;
    }
    write(&by_tests, &record()?)
}

fn tool(words: &str) -> Command {
    let mut command = process::cargo(&format!("llvm-cov {words}"));
    // The suite starts thousands of processes: four files between them instead of one each.
    command.env("LLVM_PROFILE_FILE_NAME", "slipmode-%4m.profraw");
    command
}

/// What was run until now, in the format LCOV.
fn record() -> Result<String, String> {
    let path = repository::root().join("target/coverage.lcov");
    process::check(tool("report --lcov --output-path").arg(&path))?;
    fs::read_to_string(path).map_err(failed)
}

fn failed(error: std::io::Error) -> String {
    format!("coverage: {error}")
}

/// Writes the table, and the day, the compiler and the tool to the facts beside it.
fn write(by_tests: &str, with_verify: &str) -> Result<(), String> {
    let sources = sources()?;
    let root = repository::root().to_string_lossy().into_owned();
    let table = table(&files([by_tests, with_verify], &root, &sources));
    fs::create_dir_all(measured_on::folder())
        .and_then(|()| fs::write(measured_on::folder().join(FILE), &table))
        .map_err(failed)?;
    let mut facts = measured_on::facts();
    // Which lines run does not depend on the processor.
    facts.retain(|(key, _)| key == "date" || key == "compiler");
    let version = process::output(&mut tool("--version"))?;
    let version = version.trim().trim_start_matches(TOOL).trim().to_string();
    facts.extend([(TOOL.to_string(), version), ("command".to_string(), "cargo xtask coverage".to_string())]);
    measured_on::write(FILE, &facts)?;
    print!("{table}");
    Ok(())
}

/// The program's sources by path.
fn sources() -> Result<BTreeMap<String, String>, String> {
    let read = |path: String| {
        let text = fs::read_to_string(repository::root().join(&path));
        text.map(|text| (path.clone(), text)).map_err(|error| format!("{path}: {error}"))
    };
    repository::sources()?.into_iter().map(read).collect()
}

/// How many lines of a file can be run, how many were by tests, and how many with `verify` besides.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Lines {
    all: u64,
    run: [u64; 2],
}

impl Lines {
    fn left(&self) -> u64 {
        self.all - self.run[1]
    }
}

/// The lines of each file of sources in two LCOV records, of which the later goes on from the earlier; tests left out.
fn files<'s>(
    records: [&str; 2],
    root: &str,
    sources: &'s BTreeMap<String, String>,
) -> BTreeMap<&'s str, Lines> {
    let tests = test_modules(sources);
    let ends = |path: &str| sources.get_key_value(path).map(|(path, text)| (path.as_str(), first_test(text)));
    let mut found: BTreeMap<&str, Lines> = BTreeMap::new();
    for (which, record) in records.into_iter().enumerate() {
        let mut current = None;
        for line in record.lines() {
            if let Some(path) = line.strip_prefix("SF:") {
                let path = path.strip_prefix(root).unwrap_or(path).trim_start_matches('/');
                let is_test = tests.iter().any(|test| path.starts_with(test.as_str()));
                current = ends(path).filter(|_| !is_test);
            } else if let (Some((path, end)), Some(data)) = (current, line.strip_prefix("DA:")) {
                let mut numbers = data.split(',').map(|number| number.parse::<usize>().unwrap_or(0));
                let (at, times) = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0));
                if at < end {
                    let lines = found.entry(path).or_default();
                    lines.all += u64::from(which == 0);
                    lines.run[which] += u64::from(times > 0);
                }
            }
        }
    }
    found
}

/// The line on which a file's own tests begin, counted from 1.
fn first_test(text: &str) -> usize {
    let lines: Vec<&str> = text.lines().collect();
    let is_start =
        |pair: &[&str]| pair[0] == "#[cfg(test)]" && pair[1].starts_with("mod ") && pair[1].ends_with('{');
    lines.windows(2).position(is_start).map_or(usize::MAX, |index| index + 1)
}

/// How the paths of modules begin that only tests have: `src/a/tests.` and `src/a/tests/`.
fn test_modules(sources: &BTreeMap<String, String>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (path, text) in sources {
        let home = path.strip_suffix(".rs").unwrap_or(path);
        let home = ["/mod", "/lib", "/main"].iter().find_map(|end| home.strip_suffix(end)).unwrap_or(home);
        let lines: Vec<&str> = text.lines().collect();
        for pair in lines.windows(2).filter(|pair| pair[0] == "#[cfg(test)]") {
            let declared = pair[1].split_once("mod ").and_then(|(_, name)| name.strip_suffix(';'));
            for end in [".", "/"] {
                found.extend(declared.map(|name| format!("{home}/{name}{end}")));
            }
        }
    }
    found
}

/// A row a module: its lines, those that were run, and the files with the most lines that were not.
fn table(files: &BTreeMap<&str, Lines>) -> String {
    let mut modules: BTreeMap<&str, Vec<(&str, Lines)>> = BTreeMap::new();
    for (&path, &lines) in files {
        let path = repository::inside_package(path).unwrap_or(path);
        let name = path.split('/').next().unwrap_or(path);
        modules.entry(name).or_default().push((path, lines));
    }
    let mut text = format!("{HEADER}\n");
    for (module, files) in modules {
        let sum = |count: fn(&Lines) -> u64| files.iter().map(|(_, lines)| count(lines)).sum::<u64>();
        let [all, by_tests, with_verify] =
            [sum(|lines| lines.all), sum(|lines| lines.run[0]), sum(|lines| lines.run[1])];
        let _ = writeln!(text, "{module},{all},{by_tests},{with_verify},{}", most_left(files));
    }
    text
}

/// The files with the most lines that were not run, the worst first: `a/b.rs 12; a/c.rs 3`.
fn most_left(mut files: Vec<(&str, Lines)>) -> String {
    files.retain(|(_, lines)| lines.left() > 0);
    files.sort_by_key(|(path, lines)| (Reverse(lines.left()), *path));
    let named = files.iter().take(FILES_NAMED).map(|(path, lines)| format!("{path} {}", lines.left()));
    named.collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sources() -> BTreeMap<String, String> {
        [
            ("src/a/mod.rs", "//! A.\n\nfn f() {}\n\n#[cfg(test)]\nmod tests;\nmod b;\n"),
            ("src/a/tests.rs", "//! T.\n"),
            ("src/a/b.rs", "//! B.\nfn g() {}\n#[cfg(test)]\nmod tests {\nfn t() {}\n}\n"),
            ("src/lib.rs", "//! L.\n#[cfg(test)]\nmod shared;\n"),
            ("src/shared.rs", "//! S.\n"),
        ]
        .map(|(path, text)| (path.to_string(), text.to_string()))
        .into()
    }

    #[test]
    fn lines_of_tests_and_of_other_packages_are_not_counted() {
        let record = "SF:/r/src/a/mod.rs\nDA:3,7\nDA:4,0\nend_of_record\nSF:/r/src/a/tests.rs\nDA:1,1\nend_of_record\n\
            SF:/r/src/a/b.rs\nDA:2,0\nDA:5,9\nend_of_record\nSF:/r/src/shared.rs\nDA:1,1\nend_of_record\nSF:/other/x.rs\nDA:1,1\n";
        let sources = sources();
        let later = record.replace("DA:4,0", "DA:4,2");
        let found = files([record, &later], "/r", &sources);
        let lines = |all, run| Lines { all, run };
        let wanted = [("src/a/b.rs", lines(1, [0, 0])), ("src/a/mod.rs", lines(2, [1, 2]))];
        assert_eq!(found, BTreeMap::from(wanted));
        assert_eq!(table(&found), format!("{HEADER}\na,3,1,2,a/b.rs 1\n"));
    }

    #[test]
    fn three_files_are_named_with_the_most_lines_left_first_and_none_of_which_every_line_ran() {
        let with = |left: u64| Lines { all: 9, run: [0, 9 - left] };
        let files = ["src/a/a.rs", "src/a/b.rs", "src/a/c.rs", "src/a/d.rs", "src/main.rs"];
        let files = files.into_iter().zip([0, 2, 5, 1, 0].map(with)).collect();
        assert_eq!(
            table(&files),
            format!("{HEADER}\na,36,0,28,a/c.rs 5; a/b.rs 2; a/d.rs 1\nmain.rs,9,0,9,\n")
        );
    }
}
