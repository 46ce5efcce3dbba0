//! The claims of the first paper that are stated as formulas: a report that lists one of them by its id alone is decided by them.

use slipmode_core::theory::Equations;

use crate::scene::{ClaimEntry, StatedClaim, read_claims};

const PAPER: &str = include_str!("../../reports/im-avouac/claims.toml");

/// The sections that have formulas, by the ids of their claims.
fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let id = |section: &'static str| {
        section.lines().find_map(|line| line.strip_prefix("id = \"")?.strip_suffix('"'))
    };
    let stated = PAPER.split("[[claim]]\n").skip(1).filter(|section| section.contains("\nformula = "));
    stated.filter_map(move |section| Some((id(section)?, section)))
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
