//! Words that stand for something, on the command line and in CSV cells alike.

use slipmode::scene::{Problem, nearest};
use slipmode_core::dynamics::Start;
use slipmode_core::friction::EvolutionLaw;

/// The words of the laws, for messages.
pub const LAWS: &str = "slip, aging";
/// The input column that chooses the law.
pub const LAW_COLUMN: &str = "law";

/// The law of a word.
///
/// # Errors
/// When no law has this word.
pub fn law_of_word(text: &str) -> Result<EvolutionLaw, Problem> {
    of_word(text, &["slip", "aging"], EvolutionLaw::from_word)
}

/// The start of a word.
///
/// # Errors
/// When no start has this word.
pub fn start_of_word(text: &str) -> Result<Start, Problem> {
    let find = |text: &str| Start::ALL.into_iter().find(|start| start.as_str() == text);
    of_word(text, &Start::ALL.map(Start::as_str), find)
}

/// What a word out of a list stands for.
///
/// # Errors
/// When the word is not on the list; the nearest one is named.
pub fn of_word<T>(text: &str, words: &[&str], find: impl Fn(&str) -> Option<T>) -> Result<T, Problem> {
    find(text).ok_or_else(|| Problem::UnknownWord {
        nearest: nearest(text, words.iter().copied()).map(str::to_string),
        allowed: words.join(", "),
    })
}
