//! `claims.toml`: the claims that a report decides, with the verdict recorded when they were last reviewed.

use crate::scene::document::read_document;
use crate::scene::section::Section;
use crate::scene::{Faults, Limits, Problem, Verdict, of_word, same_name};

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
    read_document(file, bytes, Limits::default(), |top| {
        let mut seen: Vec<String> = Vec::new();
        top.required("claim", "[[claim]] sections")?.list(|member| {
            let mut section = member.section()?;
            let id = read_id(&mut section, known_ids, &mut seen);
            let [place, words] = ["place", "words"].map(|key| section.text(key, "a text"));
            let allowed = Verdict::ALL.map(Verdict::as_str).join(", ");
            let expected = section.required("expected", &allowed);
            let expected = expected.and_then(|entry| entry.word(&Verdict::ALL, Verdict::as_str));
            section.finish();
            Some(ClaimEntry { id: id?, place: place?, words: words?, expected: expected? })
        })
    })
}

fn read_id(section: &mut Section<'_>, known_ids: &[&str], seen: &mut Vec<String>) -> Option<String> {
    let entry = section.required("id", "the id of a claim")?;
    let id = entry.text()?;
    if let Some(first) = seen.iter().find(|first| same_name(first, &id)) {
        let folded = *first != id;
        return entry.refuse(Problem::Duplicate { of: format!("an earlier claim `{first}`"), folded });
    }
    seen.push(id.clone());
    entry.sound(of_word(&id, known_ids, |known| known))?;
    Some(id)
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
