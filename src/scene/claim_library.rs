//! The claims and the proofs of the first paper's report: a report that lists one of the claims by its id alone is decided as it is.

use std::sync::{Arc, LazyLock};

use slipmode_theory::stated_proofs::StatedProofs;

use crate::scene::Sentence;

const PAPER: &str = include_str!("../../reports/im-avouac/claims.toml");

/// The sections, by the ids of their claims.
fn all_sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let id = |section: &'static str| {
        section.lines().find_map(|line| line.strip_prefix("id = \"")?.strip_suffix('"'))
    };
    PAPER.split("[[claim]]\n").skip(1).filter_map(move |section| Some((id(section)?, section)))
}

/// What kind of sentence the first paper's claim of this id is.
pub(super) fn library_sentence(id: &str) -> Option<Sentence> {
    /// The file with one section.
    #[derive(serde::Deserialize)]
    struct File {
        claim: [Sentence; 1],
    }
    let file: Option<File> = toml::from_str(&library_file(id)?).ok();
    file.map(|File { claim: [sentence] }| sentence)
}

/// The ids of these claims.
pub fn library_ids() -> impl Iterator<Item = &'static str> {
    all_sections().map(|(id, _)| id)
}

/// The proofs of the first paper's report.
#[must_use]
pub fn library_proofs() -> &'static Arc<StatedProofs> {
    const FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/stated_proofs.rs"));
    static PROOFS: LazyLock<Arc<StatedProofs>> = LazyLock::new(|| {
        // A test reads them all.
        let files = FILES.iter().filter_map(|(_, text)| toml::from_str(text).ok());
        Arc::new(StatedProofs::read(files).unwrap_or_default())
    });
    &PROOFS
}

/// The file of these claims with this one alone.
pub(super) fn library_file(id: &str) -> Option<String> {
    let (_, section) = all_sections().find(|(known, _)| *known == id)?;
    // What stands before the first claim names the subjects.
    let head = PAPER.split("[[claim]]\n").next().unwrap_or_default();
    Some(format!("{head}[[claim]]\n{section}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_proofs_of_the_library_are_read() {
        assert!(library_proofs().ids().count() > 20);
    }
}
