//! What is wrong with an input, in words for people: place, key, value, problem, allowed range.

use std::{fmt, io};

use thiserror::Error;

use crate::scene::{CsvProblem, NameError, shortened, with_short_quotations};
use slipmode_core::number::DecimalError;

/// One fault of an input; printed as `file:line: key = value: problem`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The file's name, or what else the input came from (`command line`).
    pub file: String,
    /// The line in the file, counted from 1.
    pub line: Option<usize>,
    /// The key with its path (`parameters.normal_stress_pa`), or the option or column.
    pub key: String,
    /// The value as written, when there is one.
    pub value: Option<String>,
    /// What is wrong.
    pub problem: Problem,
}

impl serde::Serialize for Fault {
    /// The parts as the text shows them; `value` is null where there is none.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serde_json::json!({
            "file": visible(&shortened(&self.file, LONGEST_FILE)),
            "line": self.line,
            "key": shown(&self.key),
            "value": self.value.as_deref().map(shown),
            "message": self.problem_text(),
        })
        .serialize(serializer)
    }
}

impl Fault {
    /// A fault under a key of a file, without a line and a value.
    pub fn of(file: impl Into<String>, key: impl Into<String>, problem: impl Into<Problem>) -> Self {
        Self { file: file.into(), line: None, key: key.into(), value: None, problem: problem.into() }
    }

    /// The same at a line, if it is known.
    #[must_use]
    pub fn at(self, line: Option<usize>) -> Self {
        Self { line, ..self }
    }

    fn problem_text(&self) -> String {
        with_short_quotations(&self.problem.to_string(), LONGEST_PROBLEM)
    }
}

/// All the faults of one or more inputs; never empty when returned as an error.
pub type Faults = Vec<Fault>;

/// The ways in which an input can be wrong.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Problem {
    /// The operating system does not let the file be read, or it is none that the command reads.
    #[error("{0}")]
    Unreadable(String),
    /// The file exceeds the cap on its size.
    #[error("{bytes} bytes (allowed: at most {limit})")]
    TooLarge {
        /// The file's size.
        bytes: u64,
        /// The cap.
        limit: u64,
    },
    /// The bytes are not UTF-8.
    #[error("not UTF-8 text (byte {0})")]
    NotUtf8(usize),
    /// The bytes are UTF-16.
    #[error("UTF-16 text (wanted: UTF-8, such as `CSV UTF-8` of a spreadsheet)")]
    Utf16,
    /// A character that is invisible or changes the reading direction.
    #[error("character U+{0:04X} is not allowed (control, invisible or direction-changing)")]
    ForbiddenCharacter(u32),
    /// Not TOML.
    #[error("not valid TOML: {0}")]
    Syntax(String),
    /// A key that the section does not have.
    #[error("unknown key{}", suggestion(.nearest, .known))]
    UnknownKey {
        /// The nearest known key, when one is near.
        nearest: Option<String>,
        /// Every key that the section has.
        known: String,
    },
    /// A key or option that must be there.
    #[error("missing (allowed: {allowed})")]
    Missing {
        /// What may stand there.
        allowed: String,
    },
    /// A value of another type.
    #[error("must be {wanted}, not {found}")]
    WrongType {
        /// What is wanted.
        wanted: String,
        /// What was found.
        found: &'static str,
    },
    /// A text that is not a number of the grammar.
    #[error("{reason}{}", .allowed.as_ref().map(|allowed| format!(" (allowed: {allowed})")).unwrap_or_default())]
    NotANumber {
        /// Why.
        reason: DecimalError,
        /// What a number may be, where that is more than its size.
        allowed: Option<String>,
    },
    /// A number with a decimal comma.
    #[error(
        "not a decimal number: a comma stands in place of the point (in a CSV file, --decimal , reads it)"
    )]
    DecimalComma,
    /// A number with a unit that is none, or one of another dimension, and why.
    #[error("{0}")]
    Unit(String),
    /// A number outside the allowed range.
    #[error("out of range (allowed: {allowed})")]
    OutOfRange {
        /// The range.
        allowed: String,
    },
    /// A quantity that must be positive and is not.
    #[error("must be > 0 (allowed: {allowed})")]
    NotPositive {
        /// The range.
        allowed: String,
    },
    /// A value with an error bar that has no meaning, and why.
    #[error("{0}")]
    ErrorBar(&'static str),
    /// `from` and `to` are equal.
    #[error("empty range: from and to are equal (allowed: from < to)")]
    EmptyRange,
    /// `from` is greater than `to`.
    #[error("reversed range: from is greater than to (allowed: from < to)")]
    ReversedRange,
    /// More points than the limit.
    #[error("{points} points exceed the limit of {limit} (--max-points N raises it)")]
    TooManyPoints {
        /// The points requested.
        points: String,
        /// The limit.
        limit: u64,
    },
    /// A name that is not safe in every file system.
    #[error(transparent)]
    BadName(#[from] NameError),
    /// An equation that cannot be read.
    #[error("{0}")]
    Equation(String),
    /// A fault of a CSV file's form.
    #[error(transparent)]
    Csv(#[from] CsvProblem),
    /// A name or id for the second time.
    #[error("the same as {of}{}", if *.folded { " when case is ignored" } else { "" })]
    Duplicate {
        /// Where it was first.
        of: String,
        /// Whether the two differ in case only.
        folded: bool,
    },
    /// A word outside a fixed list.
    #[error("unknown{}", suggestion(.nearest, .allowed))]
    UnknownWord {
        /// The nearest word of the list, when one is near.
        nearest: Option<String>,
        /// The list.
        allowed: String,
    },
    /// A text without content, or a list without members; what may stand there.
    #[error("empty (allowed: {0})")]
    Empty(String),
    /// A section that needs another one, or parameters that the scene does not state.
    #[error("needs {0}")]
    Needs(String),
    /// Parameters for which the section has no meaning.
    #[error("needs evolution_effect > direct_effect: otherwise no critical normal stress exists")]
    NoCriticalNormalStress,
}

impl From<&io::Error> for Problem {
    /// A reason of our own stands as it is: `is a folder`.
    fn from(error: &io::Error) -> Self {
        let action = if error.get_ref().is_some() { "" } else { "cannot be read: " };
        Self::Unreadable(format!("{action}{error}"))
    }
}

fn suggestion(nearest: &Option<String>, known: &str) -> String {
    match nearest {
        Some(nearest) => format!("; did you mean `{nearest}`? (allowed: {known})"),
        None => format!(" (allowed: {known})"),
    }
}

/// The longest piece of a value that a message repeats.
const LONGEST_VALUE: usize = 60;

/// The longest name of a file that a message repeats.
const LONGEST_FILE: usize = 300;

/// The longest description of what is wrong.
const LONGEST_PROBLEM: usize = 700;

/// A value as a message shows it: control characters escaped, shortened when long.
fn shown(value: &str) -> String {
    visible(&shortened(value, LONGEST_VALUE))
}

/// A value between quotation marks, unless it is one plain word or number.
fn quoted(value: &str) -> String {
    let is_plain = |character: char| character.is_alphanumeric() || "._-+/^*@%".contains(character);
    let shown = shown(value);
    // A value of TOML has quotation marks of its own.
    let is_quoted = value.len() > 1 && value.starts_with('"') && value.ends_with('"');
    let is_one_word = !value.is_empty() && value.chars().all(is_plain);
    if is_quoted || is_one_word { shown } else { format!("\"{shown}\"") }
}

/// A text from outside as a message shows it: characters that act on a terminal or cannot be seen are escaped.
#[must_use]
pub fn visible(text: &str) -> String {
    let shown = |character: char| match character.is_control() || is_forbidden(character) {
        true => character.escape_unicode().to_string(),
        false => character.to_string(),
    };
    text.chars().map(shown).collect()
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = visible(&shortened(&self.file, LONGEST_FILE));
        let line = self.line.map_or_else(String::new, |line| format!(":{line}"));
        let value = self.value.as_ref().map_or_else(String::new, |value| format!(" = {}", quoted(value)));
        let key = if self.key.is_empty() { String::new() } else { shown(&self.key) + &value + ": " };
        write!(formatter, "{file}{line}: {key}{}", self.problem_text())
    }
}

/// Characters that no input file may hold: they hide text or reorder what a reader sees.
#[must_use]
pub fn is_forbidden(character: char) -> bool {
    match character {
        '\t' | '\n' | '\r' => false,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{2028}' | '\u{2029}' | '\u{feff}' => true,
        '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' => true,
        '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}' => true,
        other => other.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_prints_file_line_key_value_and_range() {
        let fault = Fault {
            file: "scene.toml".into(),
            line: Some(7),
            key: "parameters.stiffness_pa_per_m".into(),
            value: Some("-1e7".into()),
            problem: Problem::NotPositive { allowed: "1e-300 to 1e300".into() },
        };
        assert_eq!(
            fault.to_string(),
            "scene.toml:7: parameters.stiffness_pa_per_m = -1e7: must be > 0 (allowed: 1e-300 to 1e300)"
        );
    }

    #[test]
    fn a_hostile_value_is_shown_escaped_and_cut() {
        assert_eq!(shown("a\u{1b}[31m\u{202e}"), "a\\u{1b}[31m\\u{202e}");
        let long = shown(&"9".repeat(1000));
        assert!(long.contains("9 …[961 characters]… 9") && long.chars().count() <= LONGEST_VALUE, "{long}");
    }
}
