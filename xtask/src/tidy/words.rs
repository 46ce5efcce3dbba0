//! Words that have no place, or one place only; and for every Rust file a header and one subject's length.

use super::source::{Source, word_positions};
use crate::prelude::*;

const LONGEST_FILE: usize = 600;

/// Words that are refused in some places.
const RULES: &str = include_str!("../../tidy/refused_words.txt");

/// Folders and files whose every sentence is for readers, as are all messages and comments of the command line.
const READ: &str = "README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md docs/ examples/ templates/ tests/vectors/README.md src/cli/";

/// Complains about refused words.
pub fn check(file: &Source, found: &mut Vec<String>) {
    let mut views = BTreeMap::new();
    for [words, view, places, except, tests, message] in rows(RULES) {
        if !is_in(file, places) || is_in(file, except) {
            continue;
        }
        let text: &String = views.entry(view).or_insert_with(|| seen(file, view));
        let is_checked = |number| tests == "with tests" || !file.is_test_line(number);
        for (number, line) in (1..).zip(text.lines()).filter(|(number, _)| is_checked(*number)) {
            for word in words.split(", ").filter(|word| has_word(line, word, view)) {
                found.push(file.complaint(number, message.replace("{}", word.trim_matches('*'))));
            }
        }
    }
}

/// Whether a file is in one of these places.
fn is_in(file: &Source, places: &str) -> bool {
    let path = file.path.as_str();
    let is_package =
        path.starts_with("crates/") && path.contains("/src/") && !path.starts_with("crates/bench/");
    let is_prose = path.starts_with("reports/") && path.contains("/prose/");
    places.split(' ').any(|place| match place {
        "*" => true,
        "program" => file.is_rust() && (is_package || path.starts_with("src/")),
        "readers" => is_prose || is_in(file, READ),
        // At any depth.
        _ if place.starts_with('/') => path.ends_with(place),
        _ => path.starts_with(place),
    })
}

/// What a rule sees of a file, line by line.
fn seen(file: &Source, view: &str) -> String {
    let text = match view {
        "code" => &file.code,
        "prose" if file.is_rust() => &file.words(),
        _ => &file.text,
    };
    let seen = |line: &str| match view {
        "prose" => line.split('`').step_by(2).collect::<Vec<_>>().join("`").to_lowercase(),
        "before comments" => line.split("//").next().unwrap_or_default().to_lowercase(),
        _ => line.to_owned(),
    };
    text.lines().map(|line| seen(line) + "\n").collect()
}

/// Whether a word occurs whole, and in prose not alone between quotation marks.
fn has_word(line: &str, word: &str, view: &str) -> bool {
    let is_name = |start: usize| line[..start].ends_with('"') && line[start + word.len()..].starts_with('"');
    word_positions(line, word).any(|start| view != "prose" || !is_name(start))
}

/// Complains about a Rust file without a header and about a long one.
pub fn check_file(file: &Source, found: &mut Vec<String>) {
    if !file.text.starts_with("//!") {
        found.push(file.complaint(1, "a file starts with `//!` and its one subject"));
    }
    let lines = file.text.lines().count();
    if lines > LONGEST_FILE {
        let message = format!("{lines} lines (at most {LONGEST_FILE}): split by subject");
        found.push(file.complaint(0, message));
    }
}

/// The first word of the rule whose reason has these words.
#[cfg(test)]
pub fn of(reason: &str) -> &'static str {
    let rule = rows(RULES).find(|[.., message]: &[&str; 6]| message.contains(reason)).unwrap();
    rule[0].split(", ").next().unwrap().trim_matches('*')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn refused(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, check)
    }

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, |file, found| {
            check_file(file, found);
            check(file, found);
        })
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
        for refused in ["todo!", "unimplemented!", "dbg!", "#[ignore"] {
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

    #[test]
    fn private_words_are_refused_where_they_are_read() {
        let private = rows(RULES).filter(|[_, view, ..]: &[&str; 6]| *view == "prose");
        for [private, ..] in private {
            let text = format!("ok\nA {private}, as one says.\n");
            for path in ["README.md", "docs/evidence/a.md", "reports/a/prose/b.md", "templates/report.html"] {
                assert!(refused(path, &text).contains(&2), "{path}: {private}");
            }
            assert_eq!(refused("reports/a/published/report.md", &text), [0; 0]);
        }
        assert_eq!(refused("README.md", "Hard-laps of 3\nLate Behaviour"), [1, 2]);
    }

    #[test]
    fn code_spans_and_parts_of_words_pass() {
        assert_eq!(
            refused("README.md", "overlap, `rung`, lap_count, `cargo xtask bless`, insight\n"),
            [0; 0]
        );
    }

    #[test]
    fn help_texts_messages_and_comments_of_the_command_line_are_checked() {
        assert_eq!(
            refused("src/cli/a.rs", "/// A lap\nlet lap = \"rung\";\nlet x = \"no rung here\"; // told\n"),
            [1, 3, 3]
        );
        assert_eq!(refused("src/roots/a.rs", "/// A lap\n"), [0; 0]);
        assert_eq!(refused("src/cli/a.rs", "#[cfg(test)]\nmod tests {\n    // told\n}\n"), [0; 0]);
    }
}
