//! Rules for every Rust file: a header, one subject's length, no left-overs, no panics, one place for side effects.

use super::Complaint;
use super::rust_source::{RustSource, word_positions};
use crate::repository;

const LONGEST_FILE: usize = 600;

/// Macros and attributes that must not be committed.
const REFUSED_CODE: [&str; 4] = ["todo!", "unimplemented!", "dbg!", "#[ignore"];

/// Only the command line opens files, reads the clock and the environment, or ends the process.
const SIDE_EFFECTS: [&str; 7] =
    ["std::fs", "std::env", "std::process", "std::net", "SystemTime", "Instant", "std::io::stdin"];

/// Where text from outside is handled: a panic there could be reached by input.
const NEAR_INPUT: [&str; 7] = [
    "src/cli",
    "src/main.rs",
    "src/scene",
    "src/report",
    "src/archive",
    "crates/plot/src/table",
    "crates/algebra/src/number/decimal.rs",
];

/// The one place for `unsafe`: the dispatch to a function compiled for the machine's vector unit.
const UNSAFE_ALLOWED: &str = "crates/core/src/stability/batch";

/// Checks all rules of this file.
pub fn check(source: &RustSource, found: &mut Vec<Complaint>) {
    check_header(source, found);
    check_length(source, found);
    check_refused_code(source, found);
    if repository::is_product(&source.file.path) {
        check_panics(source, found);
        check_side_effects(source, found);
        check_unsafe(source, found);
        check_claims(source, found);
    }
}

fn check_header(source: &RustSource, found: &mut Vec<Complaint>) {
    if !source.file.text.starts_with("//!") {
        found.push(source.file.complaint(1, "a file starts with `//!` and its one subject"));
    }
}

fn check_length(source: &RustSource, found: &mut Vec<Complaint>) {
    let lines = source.file.text.lines().count();
    if lines > LONGEST_FILE {
        let message = format!("{lines} lines (at most {LONGEST_FILE}): split by subject");
        found.push(source.file.complaint(0, message));
    }
}

fn check_refused_code(source: &RustSource, found: &mut Vec<Complaint>) {
    for (number, code, _) in source.lines() {
        for refused in REFUSED_CODE {
            if code.match_indices(refused).any(|(at, _)| !code[..at].ends_with(|c: char| c.is_alphanumeric()))
            {
                found.push(source.file.complaint(number, format!("`{refused}` must not be committed")));
            }
        }
    }
}

fn check_panics(source: &RustSource, found: &mut Vec<Complaint>) {
    let near_input = NEAR_INPUT.iter().any(|part| source.file.path.starts_with(part));
    for (number, code, _) in source.lines_outside_tests() {
        if code.contains(".unwrap()") {
            found.push(
                source.file.complaint(number, "`.unwrap()` outside tests: handle it, or `expect` a reason"),
            );
        }
        if near_input && [".expect(", "panic!(", "unreachable!("].iter().any(|panic| code.contains(panic)) {
            found.push(source.file.complaint(number, "a panic that input could reach: return an error"));
        }
    }
}

fn check_side_effects(source: &RustSource, found: &mut Vec<Complaint>) {
    let path = &source.file.path;
    if path.starts_with("src/cli/") || path == "src/main.rs" {
        return;
    }
    for (number, code, _) in source.lines_outside_tests() {
        for effect in SIDE_EFFECTS {
            if word_positions(code, effect).next().is_some() {
                let message = format!("`{effect}` belongs to `cli`, the only floor that touches the world");
                found.push(source.file.complaint(number, message));
            }
        }
    }
}

fn check_unsafe(source: &RustSource, found: &mut Vec<Complaint>) {
    if source.file.path.starts_with(UNSAFE_ALLOWED) {
        return;
    }
    for (number, code, _) in source.lines() {
        if word_positions(code, "unsafe").next().is_some() {
            found.push(source.file.complaint(number, format!("`unsafe` is for {UNSAFE_ALLOWED} only")));
        }
    }
}

/// Whether a claim of the first paper's report is named: `"B8"`, or `claim B8`.
fn check_claims(source: &RustSource, found: &mut Vec<Complaint>) {
    for (number, _, text) in source.lines_outside_tests() {
        let after =
            |mark: &str| text.match_indices(mark).map(|(at, mark)| at + mark.len()).collect::<Vec<_>>();
        let starts = [after("\""), after("claim "), after("claims ")].concat();
        if starts.into_iter().any(|at| is_claim(&text[at..])) {
            let message =
                "the program knows no claim: its words, criterion and procedure stand in claims.toml";
            found.push(source.file.complaint(number, message));
        }
    }
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
        for refused in REFUSED_CODE {
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
    fn unsafe_has_one_place() {
        let code = "//!\nfn f() { unsafe { g() } }\n";
        assert_eq!(complaints("crates/core/src/number/dd.rs", code), [2]);
        assert_eq!(complaints("crates/core/src/stability/batch_grid.rs", code), [0; 0]);
        assert_eq!(
            complaints("crates/core/src/number/dd.rs", "//! unsafe\n#![forbid(unsafe_code)]\n"),
            [0; 0]
        );
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
