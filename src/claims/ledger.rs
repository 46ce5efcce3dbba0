//! The ledger: the claims a report lists, each with the verdict its check computed.

use std::collections::BTreeSet;

use crate::parallel;
use serde::Serialize;

use crate::claims::error_bars::points_within;
use crate::claims::{Conclusion, DecidedFor, PointWithin, resolved_claim, sha256_hex};
use crate::claims::{Evidence, Finding, PROVED, Tie, Tied, Verdict, by_hand, computed, formula, over_rows};
use crate::experiments::operating_point::error_bars;
use crate::experiments::{Context, Needs};
use crate::scene::{ClaimEntry, ClaimFormula, InAnswer, Sentence, Source, StatedClaim, Subject, filled};
use slipmode_algebra::Step;
use slipmode_theory::Equations;

/// One line of the ledger.
#[derive(Debug, Clone, Serialize)]
pub struct Entry {
    /// The claim's id.
    pub id: String,
    /// Where the paper makes it.
    pub place: String,
    /// The claim in our words.
    pub words: String,
    /// What kind of sentence it is, and whose.
    #[serde(flatten)]
    pub sentence: Sentence,
    /// What had to be found for it to hold.
    pub criterion: String,
    /// SHA-256 of the claim as resolved: its words, its formulas, and all of the equations that they reach.
    pub digest: String,
    /// What the check concluded.
    #[serde(flatten)]
    pub finding: Finding,
    /// What the verdict does not establish.
    pub not_established: String,
    /// Claims whose truth this one presupposes.
    pub rests_on: Vec<String>,
    /// The recorded verdict.
    pub expected: Verdict,
    /// The values for which the verdict was decided, where a scene has error bars.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_bars: Option<DecidedFor>,
    /// Why theorems that were tied to the claim of this report are about something else, where that is so.
    #[serde(skip)]
    pub untied: Option<String>,
    /// What it is about.
    #[serde(skip)]
    pub subject: Option<Subject>,
    /// Where a report's answer uses it.
    #[serde(skip)]
    pub in_answer: Option<InAnswer>,
    /// What the claim says as formulas, where formulas decide it.
    #[serde(skip)]
    pub stated: Option<StatedClaim>,
}

/// How a remark begins that is a warning about the formulas of a claim.
const WARNING: &str = "Warning: ";

impl Entry {
    /// The warnings about its formulas.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        self.finding.remarks.iter().filter_map(|remark| remark.strip_prefix(WARNING))
    }

    /// The theorems written by hand that state the whole claim, if Coq has accepted them.
    pub(crate) fn tie(&self, equations: &Equations) -> Option<&'static Tie> {
        by_hand::accepted_tie(&self.tied(), equations)
    }

    /// The claim with its result, as ties to theorems see it.
    pub(crate) fn tied(&self) -> Tied<'_> {
        Tied { claim: &self.id, digest: &self.digest, conclusion: Conclusion::from(&self.finding) }
    }

    /// Where the sentence is about more than was decided, what limits it; and the replacement of a sentence that fails, with its numbers.
    fn with_what_the_sentence_needs(mut self) -> Self {
        if let Some(decided) = &self.sentence.decided_for {
            self.finding = self.finding.decided_for(decided);
        }
        self.sentence.change = self.sentence.change.filter(|_| self.finding.verdict == Verdict::Fails);
        let parts = self.stated.iter().flat_map(StatedClaim::parts);
        let has_check = parts.into_iter().any(|(_, formula)| formula.is_over_results());
        if let Some(change) = &mut self.sentence.change {
            match filled(&change.instead, &self.finding.numbers) {
                Ok(text) => change.instead = text,
                // A report that does not compute the numbers of a check has no replacement for the sentence.
                Err(_) if has_check && self.finding.numbers.is_empty() => self.sentence.change = None,
                Err(name) => {
                    let warning = format!(
                        "{WARNING}the replacement names {{{name}}}, which the check does not compute."
                    );
                    self.finding.remarks.push(warning);
                }
            }
        }
        self
    }
}

/// All claims of a report, in the order in which the report lists them.
#[derive(Debug, Clone, Serialize)]
pub struct Ledger {
    /// The report's name.
    pub report: String,
    /// The entries.
    pub claims: Vec<Entry>,
    /// What is certain at operating points with error bars.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub operating_points: Vec<PointWithin>,
}

impl Ledger {
    /// Decides every listed claim.
    pub(crate) fn decide(report: &str, texts: &[ClaimEntry], context: &Context) -> Self {
        let decided = |text: &ClaimEntry| {
            let entry = decide_one(text, context);
            let untied = by_hand::untied(report, &entry.tied(), context.equations);
            Entry { untied, ..entry }
        };
        let mut claims: Vec<Entry> = parallel::map(texts, decided);
        if context.outcome.scenes.iter().any(|scene| error_bars(scene).is_some()) {
            state_values(&mut claims);
        }
        let operating_points = points_within(context.outcome);
        Ledger { report: report.to_owned(), claims, operating_points }
    }

    /// The claims whose computed verdict is not the recorded one.
    pub fn drift(&self) -> impl Iterator<Item = &Entry> {
        self.claims.iter().filter(|entry| entry.finding.verdict != entry.expected)
    }

    /// The claims that are stated to be surer than their weakest reading, part or evidence.
    pub fn overstated(&self) -> impl Iterator<Item = &Entry> {
        self.claims.iter().filter(|entry| entry.finding.is_overstated())
    }

    /// What its claims are about, in the order of their file.
    pub(crate) fn subjects(&self) -> Vec<&Subject> {
        let mut all: Vec<&Subject> = Vec::new();
        for subject in self.claims.iter().filter_map(|entry| entry.subject.as_ref()) {
            if !all.contains(&subject) {
                all.push(subject);
            }
        }
        all.sort_by_key(|subject| subject.place);
        all
    }

    /// What an independent evaluation found against what was proved, with the claims' ids: the program is at fault.
    pub fn contradictions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.claims.iter().flat_map(|entry| {
            entry.finding.contradictions.iter().map(|one| (entry.id.as_str(), one.as_str()))
        })
    }

    /// How many distinct steps the proofs of all claims have, and how many of them carry no certificate.
    pub(crate) fn proof_steps(&self) -> (usize, usize) {
        let proofs = self.claims.iter().flat_map(|entry| &entry.finding.evidence).filter_map(Evidence::proof);
        let mut distinct: Vec<&Step> = Vec::new();
        for step in proofs.flat_map(|proof| &proof.steps) {
            if !distinct.iter().any(|known| known.is_same(step)) {
                distinct.push(step);
            }
        }
        let argued = distinct.iter().filter(|step| step.certificate.is_none()).count();
        (distinct.len(), argued)
    }

    /// The ledger as pretty JSON with a final newline.
    pub(crate) fn to_json(&self) -> String {
        // Serialising plain data with string keys cannot fail.
        serde_json::to_string_pretty(self).map_or_else(|error| format!("\"{error}\""), |text| text + "\n")
    }

    /// The claims of a source.
    pub fn of(&self, source: Source) -> impl Iterator<Item = &Entry> {
        self.claims.iter().filter(move |entry| entry.sentence.source == source)
    }

    /// How many claims of a source have this verdict.
    pub(crate) fn count(&self, source: Source, verdict: Verdict) -> usize {
        self.of(source).filter(|entry| entry.finding.verdict == verdict).count()
    }

    /// How many findings the claims of the paper with this verdict are: claims that repeat another or share its counter-example are one.
    pub(crate) fn findings(&self, verdict: Verdict) -> usize {
        let found = self.of(Source::Paper).filter(|entry| entry.finding.verdict == verdict);
        found.map(|entry| self.first_of_finding(entry)).collect::<BTreeSet<_>>().len()
    }

    /// The first claim of the finding that a claim belongs to.
    fn first_of_finding<'e>(&'e self, entry: &'e Entry) -> &'e str {
        let earlier = self.claims.iter().take_while(|one| one.id != entry.id);
        let same =
            entry.sentence.same_as.as_ref().and_then(|id| earlier.into_iter().find(|one| one.id == *id));
        same.map_or(&entry.id, |same| self.first_of_finding(same))
    }
}

/// What decides a claim: its formulas and parts, or the reason why it is out of reach.
pub(super) fn finding_on(claim: &ClaimEntry, context: &Context) -> Finding {
    match (&claim.stated, &claim.reason) {
        (Some(stated), _) => formula::decide(&claim.id, stated, &context.with_kind(claim.sentence.kind)),
        (None, Some(reason)) => Finding::not_checked(reason),
        (None, None) => Finding::not_checked("The claim says nothing that can be decided."),
    }
}

fn decide_one(text: &ClaimEntry, context: &Context) -> Entry {
    let mut finding = finding_on(text, context);
    if let Some(stated) = &text.stated {
        let warnings = formula::warnings(stated, &finding, context.equations);
        finding.remarks.extend(warnings.into_iter().map(|warning| format!("{WARNING}{warning}.")));
    }
    let stated = text.stated.as_ref();
    let criterion = stated.map_or_else(String::new, |stated| {
        stated.criterion.clone().unwrap_or_else(|| formula::criterion(stated))
    });
    let not_established = stated.map_or_else(String::new, |stated| stated.leaves_out.clone());
    let entry = Entry {
        id: text.id.clone(),
        place: text.place.clone(),
        words: text.words.clone(),
        sentence: text.sentence.clone(),
        criterion,
        digest: sha256_hex(&resolved_claim(text, context.equations)),
        finding,
        not_established,
        rests_on: text.rests_on.clone(),
        expected: text.expected,
        error_bars: None,
        untied: None,
        subject: text.subject.clone(),
        in_answer: text.in_answer,
        stated: text.stated.clone(),
    };
    let entry = entry.with_what_the_sentence_needs();
    // Where the words are about more than the formulas, no theorem on the formulas states them.
    let is_argued = entry.stated.as_ref().is_some_and(|stated| stated.argued.is_some());
    let may_be_tied = PROVED.contains(&entry.finding.strength) && !is_argued;
    match may_be_tied.then(|| entry.tie(context.equations)).flatten() {
        Some(tie) => Entry { finding: entry.finding.with_whole_theorem(&tie.theorems), ..entry },
        None => entry,
    }
}

/// Says of every verdict for which values it was decided. Formulas about the equations use no values.
fn state_values(claims: &mut [Entry]) {
    let is_pure =
        |(_, formula): &(String, ClaimFormula)| formula.rows.is_none() && formula.computed().is_none();
    let is_proved = |entry: &&Entry| {
        let finding = &entry.finding;
        entry.stated.as_ref().is_some_and(|stated| stated.parts().all(is_pure))
            || PROVED.contains(&finding.strength) && finding.evidence.iter().any(|one| one.proof().is_some())
    };
    let id = |entry: &Entry| entry.id.clone();
    let mut proved: BTreeSet<String> = claims.iter().filter(is_proved).map(id).collect();
    // What rests on a claim that is not proved is not proved either.
    for _ in 0..claims.len() {
        let rests = |entry: &&Entry| {
            proved.contains(&entry.id) && entry.rests_on.iter().all(|id| proved.contains(id))
        };
        proved = claims.iter().filter(rests).map(id).collect();
    }
    for entry in claims.iter_mut().filter(|entry| entry.finding.verdict != Verdict::NotChecked) {
        let is_proved = proved.contains(&entry.id);
        entry.error_bars = Some(if is_proved { DecidedFor::AllValues } else { DecidedFor::MiddleValues });
    }
}

/// What the listed claims need computed.
#[must_use]
pub fn needs(claims: &[ClaimEntry]) -> Needs {
    let formulas = || claims.iter().flat_map(ClaimEntry::formulas);
    let of_rows = formulas().filter_map(|formula| formula.rows.as_ref());
    let of_rows = of_rows.flat_map(|rows| over_rows::needs(&rows.table));
    let of_procedures = formulas().filter_map(ClaimFormula::computed).flat_map(computed::needs);
    of_rows.copied().chain(of_procedures).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::procedures;
    use crate::experiments::{Need, References, Scene, run};
    use crate::scene::{Limits, read_claims, read_equations};

    /// The paper's ledger without simulations: what rests on them is not checked, and `verify` computes it.
    fn paper() -> Ledger {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/im-avouac");
        let read = |name: &str| std::fs::read(format!("{folder}/{name}")).unwrap();
        let equations = read_equations("equations.toml", &read("equations.toml")).unwrap();
        let parse = |entry: std::io::Result<std::fs::DirEntry>| {
            let bytes = std::fs::read(entry.unwrap().path()).unwrap();
            Scene::parse("a.toml", &bytes, &Limits::default()).unwrap()
        };
        let scenes: Vec<Scene> = std::fs::read_dir(format!("{folder}/scenes")).unwrap().map(parse).collect();
        let needs = [Need::Map, Need::Zones, Need::Frequency, Need::Tolerance].into();
        let outcome = run(&scenes, &needs, &References::default(), &|_, _, _| {});
        let claims =
            read_claims("claims.toml", &read("claims.toml"), &procedures(), Some(&equations)).unwrap();
        Ledger::decide("paper", &claims, &Context::new(&equations, &outcome))
    }

    #[test]
    fn no_claim_of_the_paper_is_overstated_and_under_three_percent_of_all_proof_steps_are_argued() {
        let ledger = paper();
        assert!(ledger.of(Source::Paper).count() - ledger.count(Source::Paper, Verdict::NotChecked) >= 38);
        let overstated: Vec<&str> = ledger.overstated().map(|entry| entry.id.as_str()).collect();
        assert!(overstated.is_empty(), "{overstated:?}");
        let (steps, argued) = ledger.proof_steps();
        assert!(steps > 200 && 100 * argued < 3 * steps, "{argued} of {steps}");
    }
}
