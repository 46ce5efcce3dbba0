//! The claims of the first paper that are stated as formulas: a report that lists one of them by its id alone is decided by them.

use slipmode_core::theory::Equations;

use crate::scene::{ClaimEntry, Sentence, StatedClaim, read_claims};

const PAPER: &str = include_str!("../../reports/im-avouac/claims.toml");

/// The sections, by the ids of their claims.
fn all_sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let id = |section: &'static str| {
        section.lines().find_map(|line| line.strip_prefix("id = \"")?.strip_suffix('"'))
    };
    PAPER.split("[[claim]]\n").skip(1).filter_map(move |section| Some((id(section)?, section)))
}

/// Those that have formulas.
fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    all_sections().filter(|(_, section)| section.contains("\nformula = "))
}

/// What kind of sentence the first paper's claim of this id is.
pub(super) fn library_sentence(id: &str) -> Option<Sentence> {
    /// The file with one section.
    #[derive(serde::Deserialize)]
    struct File {
        claim: [Sentence; 1],
    }
    let (_, section) = all_sections().find(|(known, _)| *known == id)?;
    let file: Option<File> = toml::from_str(&format!("[[claim]]\n{section}")).ok();
    file.map(|File { claim: [sentence] }| sentence)
}

/// The ids of these claims.
pub fn library_ids() -> impl Iterator<Item = &'static str> {
    sections().map(|(id, _)| id)
}

/// Whether a claim with this id says what one of these claims says.
#[must_use]
pub fn is_library_claim(id: &str, stated: &StatedClaim) -> bool {
    let says = |section: &str| {
        stated.parts().all(|(_, formula)| section.contains(&format!("\nformula = \"{}\"\n", formula.text)))
    };
    sections().any(|(known, section)| known == id && says(section))
}

/// One of these claims in the names of a report's equations.
///
/// # Errors
/// Why its formulas cannot be read in these names.
pub fn library_claim(id: &str, equations: &Equations) -> Option<Result<ClaimEntry, String>> {
    let (_, section) = sections().find(|(known, _)| *known == id)?;
    let read = read_claims("claims.toml", format!("[[claim]]\n{section}").as_bytes(), &[], Some(equations));
    let read = read.map(|mut claims| claims.pop());
    let words = |fault: &crate::scene::Fault| {
        format!("The claim's formulas cannot be read in the report's equations: {fault}.")
    };
    read.map_err(|faults| faults.first().map_or_else(String::new, words)).transpose()
}
