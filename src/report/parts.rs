//! The words over the parts of a report and the groups of its sentences, as `words.toml` has them, and which chapters stand under a part.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use super::view::ChapterView;
use crate::scene::{Part, Source};

/// What the report says of a part, or of the sentences of a source.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Words {
    /// The heading.
    pub title: String,
    /// What the chapters answer, in one sentence, or where the sentences come from.
    pub lead: String,
    /// What one sentence of the source is called, and several.
    #[serde(default)]
    pub names: [String; 2],
}

/// The deep link of a part.
pub(crate) fn anchor(part: Part) -> String {
    format!("part-{}", part.as_str())
}

/// The heading of a part.
pub(crate) fn title(part: Part) -> &'static str {
    words("parts", part.as_str()).map_or("", |words| &words.title)
}

/// What the chapters of a part answer, in one sentence.
pub(crate) fn lead(part: Part) -> &'static str {
    words("parts", part.as_str()).map_or("", |words| &words.lead)
}

/// What the report says of the sentences of a source; nothing of the paper's.
pub(crate) fn words_of_source(source: Source) -> Option<&'static Words> {
    words("sources", source.as_str())
}

fn words(kind: &str, word: &str) -> Option<&'static Words> {
    static WORDS: LazyLock<BTreeMap<String, BTreeMap<String, Words>>> =
        LazyLock::new(|| toml::from_str(include_str!("words.toml")).unwrap_or_default());
    WORDS.get(kind)?.get(word)
}

/// The chapters cut where the part changes, before the ledger and after it; no run is empty.
pub(crate) fn runs(chapters: &[ChapterView]) -> [Vec<&[ChapterView]>; 2] {
    let follows = |chapter: &ChapterView| chapter.part.is_some_and(Part::follows_ledger);
    let (before, after) = chapters.split_at(chapters.iter().position(follows).unwrap_or(chapters.len()));
    [before, after].map(|side| side.chunk_by(|one, next| one.part == next.part).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_and_every_source_but_the_paper_has_its_words() {
        assert!(Part::ALL.iter().all(|part| !title(*part).is_empty() && !lead(*part).is_empty()));
        let has_names = |source: Source| {
            words_of_source(source).is_some_and(|words| words.names.iter().all(|name| !name.is_empty()))
        };
        assert!(Source::ALL.into_iter().all(|source| has_names(source) == (source != Source::Paper)));
    }
}
