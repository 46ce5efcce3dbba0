//! What kind of sentence a claim is, whose it is, and what its author would change: the keys of a claim beside its formulas.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::scene::section::{Entry, ReadSection, Section, keys};

slipmode_algebra::named! {
    /// What a sentence says, by the paper's own words. The kind decides the verdict before any number is computed.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Kind {
        /// "every", "always", "is", an equation: one counter-example refutes it.
        #[default]
        Universal = "universal",
        /// "approximately", "near", "asymptotic": it may be off by the tolerance of all such sentences.
        Approximate = "approximate",
        /// "low", "wide", "rapidly": the weakest statement that the word cannot be denied to mean.
        Qualitative = "qualitative",
    }
}

slipmode_algebra::named! {
    /// Whose sentence it is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Source {
        /// The paper's text has it.
        #[default]
        Paper = "paper",
        /// A result that the field knows and that the paper builds on.
        Standard = "standard",
        /// A question of the report, which the paper does not answer.
        Question = "question",
        /// What the report assumes of the paper's work where its text is silent.
        Assumption = "assumption",
        /// A result of the report.
        Result = "result",
    }
}

/// A sentence: its kind with the words that make it so, whose it is, and what would be true in its place.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Sentence {
    /// Its kind.
    pub kind: Kind,
    /// A few words of the paper that make it of this kind; may be empty.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub quote: String,
    /// Whose it is.
    pub source: Source,
    /// The earlier claim with which it forms one finding: it repeats that claim, or has the same counter-example.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub same_as: Option<String>,
    /// Those of the things it is about that the report decides, where the sentence is about more; it holds within them at most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub decided_for: Option<String>,
    /// What an author would write in its place, where it fails.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub change: Option<Change>,
}

keys! {
    /// A replacement for a sentence that fails.
    #[derive(Serialize, Deserialize)]
    pub struct Change {
        /// What is true instead, in one sentence. `{name}` stands for a number that the check computes.
        pub instead: String = |section, key| section.text(key, "a text"),
        /// What in the paper depends on the sentence, or `nothing`.
        pub affects: String = |section, key| section.text(key, "a text"),
        /// Its place in the list, from 1: what changes most for a reader of the paper comes first.
        pub rank: u64 = |section, key| section.whole(key, 1..=100),
    }
}

impl Sentence {
    /// The keys of a claim; none for a claim without any of them. What formulas say exactly is not approximate.
    pub(super) fn read(section: &mut Section<'_>, is_exact: bool) -> Option<Self> {
        let kind = section.optionally("kind", |entry| match entry.word(&Kind::ALL, Kind::as_str)? {
            Kind::Approximate if is_exact => entry.needs(
                "`is near` over rows, or a formula that states the tolerance, such as \
                 `x > 0.9*y and x < 1.1*y`: an equation is decided exactly",
            ),
            kind => Some(kind),
        });
        let source = section.optionally("source", |entry| entry.word(&Source::ALL, Source::as_str));
        let quote = section.optionally("quote", Entry::text);
        let same_as = section.optionally("same_as", Entry::text);
        let decided_for = section.optionally("decided_for", Entry::text);
        let change = section.optionally("change", |entry| entry.table(Change::read));
        let is_stated = kind.is_some() || source.is_some() || quote.is_some();
        let is_stated = is_stated || same_as.is_some() || decided_for.is_some() || change.is_some();
        is_stated.then(|| Self {
            kind: kind.unwrap_or_default(),
            quote: quote.unwrap_or_default(),
            source: source.unwrap_or_default(),
            same_as,
            decided_for,
            change,
        })
    }
}

/// A sentence with its numbers in the place of their names between braces.
///
/// # Errors
/// The first name between braces that has no number.
pub fn filled(sentence: &str, numbers: &BTreeMap<String, String>) -> Result<String, String> {
    let mut parts = sentence.split('{');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once('}').unwrap_or((part, ""));
        text += numbers.get(name).ok_or(name)?;
        text += rest;
    }
    Ok(text)
}
