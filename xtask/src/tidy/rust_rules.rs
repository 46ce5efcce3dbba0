//! Rules for every Rust file: a header, one subject's length, and words that have no place, or one place only.

use super::Complaint;
use super::rust_source::{RustSource, word_positions};
use crate::prelude::*;

const LONGEST_FILE: usize = 600;

/// Words of code that are refused in some places.
const RULES: &str = include_str!("../../tidy/refused_words.txt");

const NO_CLAIM: &str = "the program knows no claim: its words, criterion and procedure stand in claims.toml";
const NO_EQUATION: &str =
    "the program knows no number of an equation: texts name its role in braces (`scene::cited`)";

/// Checks all rules of this file.
pub fn check(source: &RustSource, found: &mut Vec<Complaint>) {
    let path = source.file.path.as_str();
    if !source.file.text.starts_with("//!") {
        found.push(source.file.complaint(1, "a file starts with `//!` and its one subject"));
    }
    let lines = source.file.text.lines().count();
    if lines > LONGEST_FILE {
        let message = format!("{lines} lines (at most {LONGEST_FILE}): split by subject");
        found.push(source.file.complaint(0, message));
    }
    let is_library =
        path.starts_with("crates/") && path.contains("/src/") && !path.starts_with("crates/bench/");
    let is_program = is_library || path.starts_with("src/");
    let is_in = |places: &str| {
        let is_below = |place| place == "*" || path.starts_with(place) || place == "program" && is_program;
        places.split(' ').any(is_below)
    };
    for [words, places, except, tests, message] in rows(RULES) {
        if !is_in(places) || is_in(except) {
            continue;
        }
        let is_checked = |number| tests == "with tests" || !source.is_test_line(number);
        for (number, code, _) in source.lines().filter(|(number, ..)| is_checked(*number)) {
            for word in words.split(' ').filter(|word| word_positions(code, word).next().is_some()) {
                found.push(source.file.complaint(number, format!("`{word}`: {message}")));
            }
        }
    }
    for (number, _, text) in source.lines_outside_tests().filter(|_| is_program) {
        let claim = names_claim(text).then_some(NO_CLAIM);
        let messages = claim.into_iter().chain(cites_equation(text).then_some(NO_EQUATION));
        found.extend(messages.map(|message| source.file.complaint(number, message)));
    }
}

/// Whether a claim of the first paper's report is named: `"B8"`, or `claim B8`.
fn names_claim(text: &str) -> bool {
    ["\"", "claim ", "claims "].iter().any(|mark| text.split(mark).skip(1).any(is_claim))
}

/// Whether a text cites an equation of the first paper by its number. A comment may: it says where a formula comes from.
fn cites_equation(text: &str) -> bool {
    let text = text.split("//").next().unwrap_or_default().to_lowercase();
    ["eq ", "eqs ", "equation ", "equations "].iter().any(|mark| {
        text.match_indices(mark).any(|(at, _)| {
            let is_whole = !text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
            is_whole && text[at + mark.len()..].starts_with(|c: char| c.is_ascii_digit())
        })
    })
}

/// Whether a text begins with the id of such a claim.
fn is_claim(text: &str) -> bool {
    let digits = text.strip_prefix(['F', 'L', 'S', 'B', 'Q', 'Z', 'N', 'X']).unwrap_or_default();
    let rest = digits.trim_start_matches(|c: char| c.is_ascii_digit());
    (1..=2).contains(&(digits.len() - rest.len()))
        && !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, check)
    }

    #[test]
    fn a_plain_file_has_no_complaint() {
        let good = "//! Subject.\n/// todo! std::fs\nfn f() -> u8 { debug!(\"dbg!\"); 1 }\n";
        assert_eq!(complaints("crates/core/src/roots/x.rs", good), [0; 0]);
    }

    #[test]
    fn a_header_is_wanted_and_length_is_limited() {
        assert_eq!(complaints("tests/suite/main.rs", "mod a;\n"), [1]);
        assert_eq!(complaints("crates/bench/benches/a.rs", &format!("//! A.\n{}", "\n".repeat(600))), [0]);
        assert_eq!(complaints("crates/bench/benches/a.rs", &format!("//! A.\n{}", "\n".repeat(599))), [0; 0]);
    }

    #[test]
    fn unfinished_code_is_refused_in_tests_too() {
        let [refused, ..]: [&str; 5] = rows(RULES).next().unwrap();
        for refused in refused.split(' ') {
            let bad = format!("//!\nfn f() {{ {refused}() }}");
            assert_eq!(complaints("tests/suite/a.rs", &bad), [2], "{bad}");
        }
    }

    #[test]
    fn panics_are_refused_outside_tests_and_near_input() {
        let unwraps = "//!\nfn f() { g().unwrap(); }\n#[cfg(test)]\nmod tests { fn t() { g().unwrap(); } }\n";
        assert_eq!(complaints("crates/core/src/roots/x.rs", unwraps), [2]);
        let expects = "//!\nfn f() { g().expect(\"a reason\"); }\n";
        assert_eq!(complaints("src/scene/x.rs", expects), [2]);
        assert_eq!(complaints("crates/core/src/roots/x.rs", expects), [0; 0]);
    }

    #[test]
    fn the_world_is_for_the_command_line() {
        let bad = "//!\nuse std::fs;\nfn f() { std::time::Instant::now(); }\n";
        assert_eq!(complaints("src/experiments/x.rs", bad), [2, 3]);
        assert_eq!(complaints("src/cli/x.rs", bad), [0; 0]);
    }

    #[test]
    fn report_has_no_floating_point_type() {
        assert_eq!(complaints("src/report/view.rs", "//!\nfn f(x: &str) {}\nfn g(x: f64) {}"), [3]);
        assert_eq!(complaints("src/table/view.rs", "//!\nfn g(x: f64) {}"), [0; 0]);
    }

    #[test]
    fn unsafe_has_one_place() {
        let code = "//!\nfn f() { unsafe { g() } }\n";
        assert_eq!(complaints("crates/core/src/number/dd.rs", code), [2]);
        assert_eq!(complaints("crates/core/src/number/dispatch.rs", code), [0; 0]);
        assert_eq!(
            complaints("crates/core/src/number/dd.rs", "//! unsafe\n#![forbid(unsafe_code)]\n"),
            [0; 0]
        );
    }

    #[test]
    fn an_equation_is_cited_by_its_number_in_comments_and_tests_only() {
        let bad = "//! Eq 8.\nconst A: &str = \"Eqs 15 and 16\";\nconst B: &str = \"by eq 8\"; // eq 9\n";
        assert_eq!(complaints("src/cli/a.rs", bad), [2, 3]);
        let good = "//! Subject.\nconst A: &str = \"{characteristic} of eq15\"; // eq 9\n#[cfg(test)]\nmod tests { const A: &str = \"eq 8\"; }\n";
        assert_eq!(complaints("src/cli/a.rs", good), Vec::<usize>::new());
    }

    #[test]
    fn a_claim_is_named_in_data_and_in_tests_only() {
        let bad = "//! Subject.\n//! Claims N7 and N8.\nconst A: &str = \"Z5\";\n// See claim B8.\n";
        assert_eq!(complaints("src/claims/a.rs", &bad.replace("Claims", "claims")), [2, 3, 4]);
        let good = "//! Subject.\nconst A: &str = \"N7b\";\nconst S1: &str = \"S\";\n";
        assert_eq!(complaints("src/claims/a.rs", good), Vec::<usize>::new());
        let test = "//! Subject.\n#[cfg(test)]\nmod tests { const A: &str = \"Z5\"; }\n";
        assert_eq!(complaints("src/claims/a.rs", test), Vec::<usize>::new());
    }
}
