//! One claim of the ledger as the page's templates see it.

use serde::Serialize;

use super::catalogue::Catalogue;
use super::markdown::Prose;
use super::view::{ClaimView, EvidenceView, FactView};
use crate::scene::Verdict;

/// A claim's id with its verdict, small enough for a line of text.
#[derive(Debug, Serialize)]
pub(crate) struct Chip<'a> {
    id: &'a str,
    class: &'static str,
    symbol: &'static str,
    word: &'static str,
}

impl<'a> Chip<'a> {
    /// The chip of a claim.
    pub fn of(claim: &'a ClaimView) -> Self {
        let verdict = claim.verdict;
        Self { id: &claim.id, class: verdict.as_str(), symbol: verdict.symbol(), word: verdict.word() }
    }

    /// Chips of the claims with these ids; unknown ids are reported elsewhere.
    pub fn list(ids: &[String], catalogue: &Catalogue<'a>) -> Vec<Self> {
        ids.iter().filter_map(|id| catalogue.claims.get(id.as_str()).copied()).map(Chip::of).collect()
    }
}

/// What `claim.html` and `verdict.html` ask for.
#[derive(Debug, Serialize)]
pub(crate) struct ClaimPage<'a> {
    id: &'a str,
    place: &'a str,
    class: &'static str,
    symbol: &'static str,
    word: &'static str,
    open: bool,
    strength: &'a str,
    statement_html: String,
    acceptance_html: String,
    verdict_html: String,
    evidence: Vec<EvidencePage<'a>>,
    counter_example_html: String,
    not_established_html: String,
    remark_html: String,
    rests_on: Vec<Chip<'a>>,
    command: &'a str,
}

#[derive(Debug, Serialize)]
struct EvidencePage<'a> {
    kind: &'a str,
    strength: &'a str,
    text_html: String,
    numbers: &'a [FactView],
    certificate: &'a str,
    certificate_cut: String,
}

/// Length of a certificate that the page shows whole; of a longer one it shows the beginning.
const SHOWN_CERTIFICATE_BYTES: usize = 1800;

/// The beginning of a certificate, whole lines where it has lines, and what is written below it when something is missing.
fn excerpt(certificate: &str) -> (&str, String) {
    if certificate.len() <= SHOWN_CERTIFICATE_BYTES {
        return (certificate, String::new());
    }
    let room = &certificate[..certificate.floor_char_boundary(SHOWN_CERTIFICATE_BYTES)];
    let shown = room.rfind('\n').filter(|&end| end > 0).map_or(room, |end| &room[..end]);
    let (of, all) = (shown.chars().count(), certificate.chars().count());
    (shown, format!("The first {of} of {all} characters; the whole certificate is in"))
}

impl<'a> ClaimPage<'a> {
    /// The claim with its prose rendered.
    pub fn of(claim: &'a ClaimView, catalogue: &Catalogue<'a>, prose: &mut Prose) -> Self {
        let mut html =
            |markdown: &str, part: &str| prose.inline(markdown, &format!("claim {}, {part}", claim.id));
        Self {
            id: &claim.id,
            place: &claim.place,
            class: claim.verdict.as_str(),
            symbol: claim.verdict.symbol(),
            word: claim.verdict.word(),
            open: claim.verdict != Verdict::Holds,
            strength: &claim.strength,
            statement_html: html(&claim.statement_markdown, "statement"),
            acceptance_html: html(&claim.acceptance_markdown, "acceptance"),
            verdict_html: html(&claim.verdict_markdown, "verdict"),
            counter_example_html: html(&claim.counter_example_markdown, "counter-example"),
            not_established_html: html(&claim.not_established_markdown, "not established"),
            remark_html: html(&claim.remark_markdown, "remark"),
            evidence: claim.evidence.iter().map(|item| EvidencePage::of(item, &mut html)).collect(),
            rests_on: Chip::list(&claim.rests_on, catalogue),
            command: &claim.command,
        }
    }
}

impl<'a> EvidencePage<'a> {
    fn of(item: &'a EvidenceView, html: &mut dyn FnMut(&str, &str) -> String) -> Self {
        let (certificate, certificate_cut) = excerpt(&item.certificate);
        Self {
            kind: &item.kind,
            strength: &item.strength,
            text_html: html(&item.text_markdown, "evidence"),
            numbers: &item.numbers,
            certificate,
            certificate_cut,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_certificate_is_cut_at_a_line_and_says_so() {
        assert_eq!(excerpt("short"), ("short", String::new()));
        let long = "é = 1\n".repeat(1000);
        let (shown, cut) = excerpt(&long);
        assert!(shown.len() <= SHOWN_CERTIFICATE_BYTES && shown.ends_with("é = 1"));
        assert!(cut.starts_with("The first 1541 of 6000 characters"), "{cut}");
        assert!(excerpt(&"é".repeat(2000)).0.chars().all(|c| c == 'é'));
    }
}
