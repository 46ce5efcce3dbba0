//! The sentences that an author would change, and what decides a claim in one sentence.

use crate::claims::{Entry, Evidence, Finding, Ledger, Verdict};
use crate::report::ChangeView;
use slipmode_plot::table::escape_markdown;

/// What would be true in the place of the sentences that fail.
pub(super) fn changes(ledger: &Ledger) -> Vec<ChangeView> {
    let mut all: Vec<_> =
        ledger.claims.iter().filter_map(|one| Some((one, one.sentence.change.as_ref()?))).collect();
    all.sort_by_key(|(_, change)| change.rank);
    let view = |(entry, change): (&Entry, &crate::scene::Change)| ChangeView {
        claim: entry.id.clone(),
        instead_markdown: escape_markdown(&change.instead),
        affects_markdown: escape_markdown(&change.affects),
    };
    all.into_iter().map(view).collect()
}

/// What decides a claim: the counter-example, the limit, or else the first piece of evidence.
pub(super) fn decided_by(finding: &Finding) -> String {
    let first = |text: &Option<String>| text.as_deref().map(first_clause);
    let found = match finding.verdict {
        Verdict::Fails => first(&finding.counter_example),
        Verdict::NotChecked => finding.remarks.first().map(|reason| first_clause(reason)),
        Verdict::Holds | Verdict::HoldsWithin => first(&finding.limit),
    };
    let of_evidence = || {
        finding.evidence.first().map(|evidence| match evidence {
            Evidence::Proof { proof } => first_clause(&proof.statement),
            Evidence::Enclosure { quantity, value }
            | Evidence::Simulation { quantity, value, .. }
            | Evidence::Sample { quantity, value, .. } => first_clause(&format!("{quantity}: {value}")),
        })
    };
    escape_markdown(&found.or_else(of_evidence).unwrap_or_default())
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
    fn what_decides_is_the_first_clause_of_the_verdicts_own_words() {
        assert_eq!(first_clause("a is b; c is d. e"), "a is b");
        assert_eq!(decided_by(&Finding::failing("at V = 1.5: 2. More.")), "at V = 1.5: 2");
        assert_eq!(decided_by(&Finding::not_checked("no runs")), "no runs");
    }
}
