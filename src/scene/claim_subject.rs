//! What a claim is about, where a report's answer uses it, and for which sliders it is said.

use crate::scene::section::Entry;

/// What the claims with one letter are about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Subject {
    /// Its place among the subjects of the file, from 0.
    pub place: usize,
    /// The letter of the claims' ids.
    pub letter: String,
    /// The heading of the group.
    pub title: String,
    /// What its claims are about, in a sentence.
    pub words: String,
}

slipmode_algebra::named! {
    /// The sentence of a report's answer that a claim enters besides the counts.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum InAnswer {
        /// What simulations say of the theory.
        Simulations = "simulations",
        /// How far the formulas are off.
        Formulas = "formulas",
    }
}

slipmode_algebra::named! {
    /// The sliders for which a claim is said.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Sliders {
        /// Velocity weakening, with a stability transition.
        Weakening = "a < b",
        /// No transition and no upper boundary.
        Neutral = "a = b",
        /// Velocity strengthening, no transition.
        Strengthening = "a > b",
    }
}

/// `[[subject]]` sections, in order.
pub(super) fn read_subjects(entry: &Entry<'_>) -> Option<Vec<Subject>> {
    let mut place = 0;
    entry.list(|member| {
        place += 1;
        member.table(|section| Subject {
            place: place - 1,
            letter: section.text("letter", "the letter of the claims' ids"),
            title: section.text("title", "a text"),
            words: section.text("words", "a text"),
        })
    })
}
