//! The sentences that an author would change, and what decides a claim in one sentence.

use crate::claims::{Entry, Evidence, Ledger, Verdict};
use crate::report::ChangeView;
use crate::report::claim_text::plain;
use crate::scene::StatedClaim;

/// What would be true in the place of the sentences that fail.
pub(super) fn changes(ledger: &Ledger) -> Vec<ChangeView> {
    let mut all: Vec<_> =
        ledger.claims.iter().filter_map(|one| Some((one, one.sentence.change.as_ref()?))).collect();
    all.sort_by_key(|(_, change)| change.rank);
    let view = |(entry, change): (&Entry, &crate::scene::Change)| ChangeView {
        claim: entry.id.clone(),
        instead_markdown: plain(&change.instead),
        affects_markdown: plain(&change.affects),
    };
    all.into_iter().map(view).collect()
}

/// What decides a claim: the counter-example, the limit, or else the first piece of evidence.
pub(super) fn decided_by(entry: &Entry) -> String {
    let finding = &entry.finding;
    let first = |text: &Option<String>| text.as_deref().map(first_clause);
    let found = match finding.verdict {
        Verdict::Fails => first(&finding.counter_example),
        Verdict::NotChecked => finding.remarks.first().map(|reason| first_clause(reason)),
        Verdict::Holds | Verdict::HoldsWithin => first(&finding.limit),
    };
    plain(&found.or_else(|| by_evidence(entry)).unwrap_or_default())
}

/// The first piece of evidence, and how many parts it is one of.
fn by_evidence(entry: &Entry) -> Option<String> {
    let parts = entry.finding.readings.first().map_or(&[][..], |written| &written.parts);
    let part = parts.iter().find(|part| part.evidence.contains(&1)).map(|part| first_clause(&part.words));
    let text = match entry.finding.evidence.first()? {
        Evidence::Proof { proof } if proof.statement == entry.words => {
            format!("a proof of {} steps", proof.steps.len())
        }
        Evidence::Proof { proof } => first_clause(&proof.statement),
        Evidence::Enclosure { quantity, value }
        | Evidence::Simulation { quantity, value, .. }
        | Evidence::Sample { quantity, value, .. } => {
            format!("{}: {}", part.unwrap_or_else(|| looked_at(quantity, entry)), first_clause(value))
        }
    };
    Some(if parts.len() > 1 { format!("{text} (one of {} parts)", parts.len()) } else { text })
}

/// What was looked at. A statement over rows stands with its part already.
pub(super) fn looked_at(quantity: &str, entry: &Entry) -> String {
    let parts = entry.stated.iter().flat_map(StatedClaim::parts);
    let mut tables = parts.filter_map(|(_, formula)| Some((&formula.rows.as_ref()?.table, &formula.text)));
    let table = tables.find(|(table, text)| quantity.strip_prefix(&format!("{table}: ")) == Some(text));
    table.map_or_else(|| quantity.to_owned(), |(table, _)| format!("rows of {table}"))
}

/// The words up to the first end of a clause.
fn first_clause(text: &str) -> String {
    let ends = ["; ", ". "].into_iter().filter_map(|end| text.find(end));
    text[..ends.min().unwrap_or(text.len())].trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clause_ends_at_a_semicolon_or_a_sentence() {
        assert_eq!(first_clause("a is b; c is d. e"), "a is b");
    }
}
