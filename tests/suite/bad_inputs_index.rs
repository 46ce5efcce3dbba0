//! The list of hostile inputs in `bad_inputs.rs` holds what it says: every row names tests, and every test that it names is there.

use std::fs;
use std::path::PathBuf;

/// Rows of the list; one that is taken out has to be taken out here too.
const ROWS: usize = 41;

/// The rows: what is thrown at the program, and the cell with the tests.
fn rows() -> Vec<(&'static str, &'static str)> {
    let lines = include_str!("bad_inputs.rs").lines();
    let cells = lines.filter_map(|line| line.strip_prefix("//! | ")?.strip_suffix(" |")?.rsplit_once(" | "));
    cells.filter(|(input, _)| *input != "row").collect()
}

/// The text of a module's file, in the tests or in the sources.
fn module(path: &[&str]) -> Option<String> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = path.join("/");
    let sources = [
        "tests/suite",
        "src",
        "crates/algebra/src",
        "crates/certified/src",
        "crates/core/src",
        "crates/plot/src",
    ];
    let places = sources.iter().flat_map(|source| ["", "/mod"].map(|end| format!("{source}/{path}{end}.rs")));
    places.into_iter().find_map(|place| fs::read_to_string(root.join(place)).ok())
}

/// Whether there is a test of this name, or a module of this name that has tests.
fn exists(name: &str) -> bool {
    let parts: Vec<&str> = name.split("::").collect();
    let Some((last, before)) = parts.split_last() else { return false };
    let has = |path: &[&str], what: &str| module(path).is_some_and(|text| text.contains(what));
    let test = format!("#[test]\n    fn {last}(");
    has(&parts, "#[test]")
        || has(before, &format!("#[test]\nfn {last}("))
        || has(before, &format!("mod {last} {{"))
        || before.split_last().is_some_and(|(tests, outer)| *tests == "tests" && has(outer, &test))
}

#[test]
fn every_kind_of_hostile_input_names_tests_that_exist() {
    let rows = rows();
    assert_eq!(rows.len(), ROWS);
    for (input, tests) in rows {
        let names: Vec<&str> = tests.split('`').skip(1).step_by(2).collect();
        assert!(!names.is_empty() || tests == "the same", "{input} has no test");
        for name in names {
            assert!(exists(name), "{input}: there is no `{name}`");
        }
    }
    assert!(!exists("bad_inputs::no_such_test") && !exists("no_such_module"));
}
