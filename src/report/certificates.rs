//! Each certificate is printed once. Other places, also proofs that use it as a lemma, name the claim that has it.

use crate::claims::{Evidence, Ledger};
use slipmode_algebra::{Line, Proof, Step};

/// The distinct proofs of a ledger, each with the claim whose entry has its certificate.
#[derive(Debug)]
pub(super) struct Certificates<'l> {
    proofs: Vec<(&'l Proof, &'l str)>,
}

impl<'l> Certificates<'l> {
    /// The proofs in the order of the ledger.
    pub fn of(ledger: &'l Ledger) -> Self {
        let mut proofs: Vec<(&Proof, &str)> = Vec::new();
        for entry in &ledger.claims {
            for evidence in &entry.finding.evidence {
                let Evidence::Proof { proof } = evidence else { continue };
                if proofs.iter().all(|(known, _)| !known.is_same(proof)) {
                    proofs.push((proof, &entry.id));
                }
            }
        }
        Self { proofs }
    }

    /// The claim that has the certificate of a proof of the ledger.
    pub fn home(&self, proof: &Proof) -> &'l str {
        self.proofs.iter().find(|(known, _)| known.is_same(proof)).map_or("", |(_, claim)| claim)
    }

    /// The certificate, with a line in place of the steps of each lemma that has a certificate of its own.
    pub fn text(&self, proof: &Proof) -> String {
        proof.text_without(|steps| self.elsewhere(proof, steps))
    }

    /// The lines of the same text.
    pub fn lines<'p>(&self, proof: &'p Proof) -> Vec<Line<'p>> {
        proof.lines_without(|steps| self.elsewhere(proof, steps))
    }

    fn elsewhere(&self, proof: &Proof, steps: &[Step]) -> Option<(usize, String)> {
        let lemmas =
            self.proofs.iter().filter(|(lemma, _)| !lemma.is_same(proof) && begins_with(steps, lemma));
        let (lemma, claim) = lemmas.max_by_key(|(lemma, _)| lemma.steps.len())?;
        let place = format!("{} [certificate {} of claim {claim}]", lemma.statement, lemma.id);
        Some((lemma.steps.len(), place))
    }
}

/// Whether the steps begin with a lemma as [`Proof::using`] adds it: its statement, and its steps.
fn begins_with(steps: &[Step], lemma: &Proof) -> bool {
    steps.first().is_some_and(|first| first.begins.contains(&lemma.statement))
        && steps.len() >= lemma.steps.len()
        && steps.iter().zip(&lemma.steps).all(|(step, of_lemma)| step.is_same(of_lemma))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::{Entry, Finding};
    use crate::scene::Verdict;
    use slipmode_algebra::{Domain, Expression};

    fn proof(id: &str, left: &str, right: &str) -> Proof {
        let [left, right]: [Expression; 2] = [left, right].map(|side| side.parse().unwrap());
        let proof = Proof::new(id, format!("Statement of {id}."));
        proof.identity("both sides", &[], &left, &right, &Domain::positive("x")).unwrap()
    }

    fn entry(id: &str, proofs: &[&Proof]) -> Entry {
        Entry {
            id: id.into(),
            place: String::new(),
            words: String::new(),
            criterion: String::new(),
            digest: String::new(),
            sentence: Default::default(),
            finding: Finding::from_proofs(proofs.iter().map(|&proof| Ok(proof.clone()))),
            not_established: String::new(),
            error_bars: None,
            untied: None,
            subject: None,
            in_answer: None,
            rests_on: Vec::new(),
            expected: Verdict::Holds,
            stated: None,
        }
    }

    #[test]
    fn a_certificate_has_one_home_and_a_lemma_is_one_line() {
        let lemma = proof("lemma", "x + x", "2*x");
        let whole = proof("whole", "x*x", "x^2").using(lemma.clone());
        let claims = vec![entry("A1", &[&lemma]), entry("A5", &[&whole, &lemma])];
        let ledger = Ledger { report: "r".into(), claims, operating_points: Vec::new() };
        let certificates = Certificates::of(&ledger);
        assert_eq!([&lemma, &whole].map(|proof| certificates.home(proof)), ["A1", "A5"]);
        assert_eq!(certificates.text(&lemma), lemma.to_string());
        let text = certificates.text(&whole);
        assert!(text.contains("x*x = x^2") && !text.contains("x + x = 2*x"), "{text}");
        assert!(text.contains("2. Statement of lemma. [certificate lemma of claim A1]"), "{text}");
    }
}
