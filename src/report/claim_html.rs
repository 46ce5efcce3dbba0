//! One claim of the ledger as the page's templates see it.

use serde_json::{Value, json};

use super::catalogue::Catalogue;
use super::markdown::Prose;
use super::view::{ClaimView, EvidenceView, PartView, ReadingView};
use crate::scene::Source;

/// The claim's verdict with a link.
pub(crate) fn chip(claim: &ClaimView) -> Value {
    let verdict = claim.verdict;
    json!({ "id": claim.id, "class": verdict.as_str(), "symbol": verdict.symbol(), "word": verdict.word() })
}

/// The verdicts of listed claims.
fn chips(ids: &[String], catalogue: &Catalogue<'_>) -> Vec<Value> {
    ids.iter().filter_map(|id| catalogue.claims.get(id.as_str()).copied()).map(chip).collect()
}

/// What the templates of a claim show; its prose is turned into HTML.
/// `proofs` says of each piece of evidence where the page has its proof.
pub(crate) fn claim_page(
    claim: &ClaimView,
    proofs: &[Value],
    catalogue: &Catalogue<'_>,
    prose: &mut Prose,
) -> Value {
    let stand_at_parts = has_only_proofs_of_parts(claim);
    let shown: &[EvidenceView] = if stand_at_parts { &[] } else { &claim.evidence };
    let of_parts: &[Value] = if stand_at_parts { proofs } else { &[] };
    let mut html =
        |markdown: &str, part: &str| prose.inline(markdown, &format!("claim {}, {part}", claim.id));
    json!({
        "id": claim.id,
        "is_of_paper": claim.source == Source::Paper,
        "kind_html": html(&claim.kind_markdown, "sentence"),
        "place": claim.place,
        "class": claim.verdict.as_str(),
        "symbol": claim.verdict.symbol(),
        "word": claim.verdict.word(),
        "strength": claim.strength,
        "statement_html": html(&claim.statement_markdown, "statement"),
        "acceptance_html": html(&claim.acceptance_markdown, "acceptance"),
        "verdict_html": html(&claim.verdict_markdown, "verdict"),
        "counter_example_html": html(&claim.counter_example_markdown, "counter-example"),
        "not_established_html": html(&claim.not_established_markdown, "not established"),
        "remark_html": html(&claim.remark_markdown, "remark"),
        "readings": claim.readings.iter().map(|item| reading(item, of_parts, &mut html)).collect::<Vec<_>>(),
        "evidence": shown.iter().zip(proofs).map(|(item, proof)| evidence(item, proof, &mut html)).collect::<Vec<_>>(),
        "rests_on": chips(&claim.rests_on, catalogue),
        "command": claim.command,
    })
}

/// Whether the evidence says nothing that the parts do not say: each piece is the proof of one of them, in its words.
fn has_only_proofs_of_parts(claim: &ClaimView) -> bool {
    let parts = || claim.readings.iter().flat_map(|item| &item.parts);
    let mut evidence = claim.evidence.iter().zip(1..);
    let is_said = |item: &EvidenceView, position: usize| {
        parts().any(|part| part.evidence.contains(&position) && part.words_markdown == item.text_markdown)
    };
    parts().next().is_some()
        && evidence.all(|(item, position)| {
            !item.certificate.is_empty() && item.numbers.is_empty() && is_said(item, position)
        })
}

/// `proofs` are those of the claim's evidence where it is not listed on its own.
fn reading(item: &ReadingView, proofs: &[Value], html: &mut dyn FnMut(&str, &str) -> String) -> Value {
    let mut part = |part: &PartView| {
        json!({
            "proofs": part.evidence.iter().filter_map(|position| proofs.get(position - 1)).collect::<Vec<_>>(),
            "words_html": html(&part.words_markdown, "part"),
            "formula_html": html(&part.formula_markdown, "part"),
            "class": part.verdict.as_str(),
            "symbol": part.verdict.symbol(),
            "word": part.verdict.word(),
            "strength": part.strength,
            "result_html": html(&part.result_markdown, "part"),
            "evidence": part.positions(),
        })
    };
    let parts: Vec<Value> = item.parts.iter().map(&mut part).collect();
    json!({
        "words_html": html(&item.words_markdown, "reading"),
        "class": item.verdict.as_str(),
        "symbol": item.verdict.symbol(),
        "word": item.verdict.word(),
        "strength": item.strength,
        "parts": parts,
    })
}

fn evidence(item: &EvidenceView, proof: &Value, html: &mut dyn FnMut(&str, &str) -> String) -> Value {
    json!({
        "kind": item.kind,
        "strength": item.strength,
        "text_html": html(&item.text_markdown, "evidence"),
        "numbers": item.numbers,
        "proof": proof,
        "certificate_at": item.certificate_at,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::sample;

    #[test]
    fn proofs_are_left_out_where_the_parts_say_the_same_and_only_there() {
        let report = sample::view();
        let mut claims = report.ledger.iter().flat_map(|group| &group.claims);
        let mut claim = claims.find(|claim| !claim.readings.is_empty()).unwrap().clone();
        assert!(!has_only_proofs_of_parts(&claim));
        claim.evidence[0].text_markdown = claim.readings[0].parts[0].words_markdown.clone();
        assert!(!has_only_proofs_of_parts(&claim));
        claim.evidence[0].numbers.clear();
        assert!(has_only_proofs_of_parts(&claim));
        claim.evidence[0].certificate.clear();
        assert!(!has_only_proofs_of_parts(&claim));
    }
}
