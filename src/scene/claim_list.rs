//! `claims.toml`: the claims that a report decides, with the verdict recorded when they were last reviewed.

use crate::scene::document::read_document;
use crate::scene::section::{Entry, Section};
use crate::scene::{Faults, Problem, Verdict, nearest, same_name};

/// One claim of the paper, in our words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClaimEntry {
    /// The id, such as `B8`.
    pub id: String,
    /// Where in the paper.
    pub place: String,
    /// The claim, in neutral words.
    pub words: String,
    /// The recorded verdict; the verdict itself is always computed.
    pub expected: Verdict,
}

/// Reads `claims.toml`; `known_ids` are the ids for which a check exists.
///
/// # Errors
/// All the faults at once: among them unknown ids (with the nearest known one) and ids given twice.
pub fn read_claims(file: &str, bytes: &[u8], known_ids: &[&str]) -> Result<Vec<ClaimEntry>, Faults> {
    read_document(file, bytes, |top, faults| {
        let list = top.required("claim", "[[claim]] sections", faults)?;
        let members = list.members(faults)?;
        let mut seen: Vec<String> = Vec::new();
        let claims: Vec<Option<ClaimEntry>> =
            members.iter().map(|member| read_claim(member, known_ids, &mut seen, faults)).collect();
        claims.into_iter().collect()
    })
}

fn read_claim(
    entry: &Entry<'_>,
    known_ids: &[&str],
    seen: &mut Vec<String>,
    faults: &mut Faults,
) -> Option<ClaimEntry> {
    let mut section = entry.section(faults)?;
    let id = read_id(&mut section, known_ids, seen, faults);
    let place = section.required("place", "a text", faults).and_then(|entry| entry.text(faults));
    let words = section.required("words", "a text", faults).and_then(|entry| entry.text(faults));
    let allowed = Verdict::ALL.map(Verdict::as_str).join(", ");
    let expected =
        section.required("expected", &allowed, faults).and_then(|entry| read_expected(&entry, faults));
    section.finish(faults);
    Some(ClaimEntry { id: id?, place: place?, words: words?, expected: expected? })
}

fn read_id(
    section: &mut Section<'_>,
    known_ids: &[&str],
    seen: &mut Vec<String>,
    faults: &mut Faults,
) -> Option<String> {
    let entry = section.required("id", "the id of a claim", faults)?;
    let id = entry.text(faults)?;
    if let Some(first) = seen.iter().find(|first| same_name(first, &id)) {
        let folded = *first != id;
        faults.push(entry.fault(Problem::Duplicate { of: format!("an earlier claim `{first}`"), folded }));
        return None;
    }
    seen.push(id.clone());
    if !known_ids.contains(&id.as_str()) {
        let near = nearest(&id, known_ids.iter().copied()).map(str::to_string);
        faults.push(entry.fault(Problem::UnknownWord { nearest: near, allowed: known_ids.join(", ") }));
        return None;
    }
    Some(id)
}

fn read_expected(entry: &Entry<'_>, faults: &mut Faults) -> Option<Verdict> {
    let word = entry.text(faults)?;
    let verdict = Verdict::from_word(&word);
    if verdict.is_none() {
        let near = nearest(&word, Verdict::ALL.map(Verdict::as_str)).map(str::to_string);
        let allowed = Verdict::ALL.map(Verdict::as_str).join(", ");
        faults.push(entry.fault(Problem::UnknownWord { nearest: near, allowed }));
    }
    verdict
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(id: &str, expected: &str) -> String {
        format!("[[claim]]\nid = \"{id}\"\nplace = \"eq 8\"\nwords = \"w\"\nexpected = \"{expected}\"\n")
    }

    #[test]
    fn claims_are_read_in_order() {
        let text = claim("B8", "holds-within") + &claim("B1", "fails");
        let claims = read_claims("claims.toml", text.as_bytes(), &["B1", "B8"]).unwrap();
        assert_eq!(claims.iter().map(|claim| claim.id.as_str()).collect::<Vec<_>>(), ["B8", "B1"]);
        assert_eq!(claims[0].expected, Verdict::HoldsWithin);
    }

    #[test]
    fn doubled_and_unknown_ids_and_unknown_verdicts_are_all_reported() {
        let text = claim("B8", "holds") + &claim("B8", "holds") + &claim("X9", "hold");
        let faults = read_claims("claims.toml", text.as_bytes(), &["B1", "B8"]).unwrap_err();
        let lines: Vec<_> = faults.iter().filter_map(|fault| fault.line).collect();
        assert_eq!(lines, [7, 12, 15]);
        assert!(matches!(faults[0].problem, Problem::Duplicate { folded: false, .. }));
        assert!(faults[2].to_string().contains("did you mean `holds`?"), "{}", faults[2]);
    }
}
