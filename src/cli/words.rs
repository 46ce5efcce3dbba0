//! Words that stand for something, on the command line and in CSV cells alike.

use slipmode::scene::{Problem, of_word};
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
    of_word(text, &[EvolutionLaw::Slip, EvolutionLaw::Aging], EvolutionLaw::as_str)
}

/// The start of a word.
///
/// # Errors
/// When no start has this word.
pub fn start_of_word(text: &str) -> Result<Start, Problem> {
    of_word(text, &Start::ALL, Start::as_str)
}
