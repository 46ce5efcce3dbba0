//! One claim of the ledger as the page's templates see it.

use serde_json::{Value, json};

use super::catalogue::Catalogue;
use super::markdown::Prose;
use super::view::{ClaimView, EvidenceView, PartView, ReadingView};

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
pub(crate) fn claim_page(claim: &ClaimView, catalogue: &Catalogue<'_>, prose: &mut Prose) -> Value {
    let mut html =
        |markdown: &str, part: &str| prose.inline(markdown, &format!("claim {}, {part}", claim.id));
    json!({
        "id": claim.id,
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
        "readings": claim.readings.iter().map(|item| reading(item, &mut html)).collect::<Vec<_>>(),
        "evidence": claim.evidence.iter().map(|item| evidence(item, &mut html)).collect::<Vec<_>>(),
        "rests_on": chips(&claim.rests_on, catalogue),
        "command": claim.command,
    })
}

fn reading(item: &ReadingView, html: &mut dyn FnMut(&str, &str) -> String) -> Value {
    let mut part = |part: &PartView| {
        json!({
            "words_html": html(&part.words_markdown, "part"),
            "formula_html": html(&part.formula_markdown, "part"),
            "class": part.verdict.as_str(),
            "symbol": part.verdict.symbol(),
            "word": part.verdict.word(),
            "strength": part.strength,
            "result_html": html(&part.result_markdown, "part"),
            "evidence": part.evidence,
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

fn evidence(item: &EvidenceView, html: &mut dyn FnMut(&str, &str) -> String) -> Value {
    json!({
        "kind": item.kind,
        "strength": item.strength,
        "text_html": html(&item.text_markdown, "evidence"),
        "numbers": item.numbers,
        "certificate_lines": item.certificate.lines().count(),
        "certificate_at": item.certificate_at,
    })
}
