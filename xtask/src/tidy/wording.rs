//! Plain words: private words of this project are refused where users and reviewers read.

use super::source::{Source, word_positions};
use crate::prelude::*;

/// Private words, each with the words that readers know.
const PRIVATE: &str = include_str!("../../tidy/private_words.txt");

/// Folders and files whose every sentence is for readers.
const READ: &str = "README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md docs/ examples/ templates/ tests/vectors/README.md";

/// Complains about private words in documentation, prose and templates, and in the help texts, messages and comments of the command line.
///
/// Code spans are exempt, and a string that is a single word: it names a column or a key.
pub fn check(file: &Source, found: &mut Vec<String>) {
    let path = file.path.as_str();
    let is_prose = path.starts_with("reports/") && path.contains("/prose/");
    if is_prose || READ.split(' ').any(|place| path.starts_with(place)) {
        (1..).zip(file.text.lines()).for_each(|(number, line)| complain(file, number, line, found));
    } else if path.starts_with("src/cli/") {
        for (number, code, text) in file.lines_outside_tests() {
            complain(file, number, &words_of(code, text), found);
        }
    }
}

/// The comments and strings of a line, which are blank in its code.
fn words_of(code: &str, text: &str) -> String {
    let kept = |(code, text): (char, char)| if code == ' ' { text } else { ' ' };
    code.chars().zip(text.chars()).map(kept).collect()
}

fn complain(file: &Source, number: usize, line: &str, found: &mut Vec<String>) {
    let prose = line.split('`').step_by(2).collect::<Vec<_>>().join("`").to_lowercase();
    for [private, plain] in rows(PRIVATE).filter(|[private, _]| has_words(&prose, private)) {
        found.push(file.complaint(number, format!("`{private}` is a private word: write {plain}")));
    }
}

/// Whether the words occur whole, and not alone between quotation marks.
fn has_words(prose: &str, words: &str) -> bool {
    let is_name =
        |start: usize| prose[..start].ends_with('"') && prose[start + words.len()..].starts_with('"');
    word_positions(prose, words).any(|start| !is_name(start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, check)
    }

    #[test]
    fn private_words_are_refused_where_they_are_read() {
        for [private, _] in rows(PRIVATE) {
            let text = format!("ok\nA {private}, as one says.\n");
            for path in ["README.md", "docs/evidence/a.md", "reports/a/prose/b.md", "templates/report.html"] {
                assert!(complaints(path, &text).contains(&2), "{path}: {private}");
            }
            assert_eq!(complaints("reports/a/published/report.md", &text), [0; 0]);
        }
        assert_eq!(complaints("README.md", "Hard-laps of 3\nLate Behaviour"), [1, 2]);
    }

    #[test]
    fn code_spans_and_parts_of_words_pass() {
        assert_eq!(
            complaints("README.md", "overlap, `rung`, lap_count, `cargo xtask bless`, insight\n"),
            [0; 0]
        );
    }

    #[test]
    fn help_texts_messages_and_comments_of_the_command_line_are_checked() {
        assert_eq!(
            complaints("src/cli/a.rs", "/// A lap\nlet lap = \"rung\";\nlet x = \"no rung here\"; // told\n"),
            [1, 3, 3]
        );
        assert_eq!(complaints("src/roots/a.rs", "/// A lap\n"), [0; 0]);
        assert_eq!(complaints("src/cli/a.rs", "#[cfg(test)]\nmod tests {\n    // told\n}\n"), [0; 0]);
    }
}
