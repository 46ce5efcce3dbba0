//! A finding: the verdict on one claim, with everything that led to it.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::claims::{Evidence, Part, Reading, Strength, Verdict};
use slipmode_algebra::{Proof, Refutation};
use slipmode_core::number::Rational;

/// The values of variables by name.
pub type NamedPoint = BTreeMap<String, Rational>;

/// What a check concluded, why, and where it stops.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The strength of the weakest evidence; none of what is not checked.
    pub strength: Option<Strength>,
    /// Everything the verdict rests on, and what illustrates it.
    pub evidence: Vec<Evidence>,
    /// The evidence that only illustrates what other evidence decided, as positions in the list, from 1.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub supporting: Vec<usize>,
    /// The ways to read the claim, that as written first; empty where it has one reading of one part.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub readings: Vec<Reading>,
    /// The limit within which the claim holds, quantified.
    pub limit: Option<String>,
    /// Why the claim fails, or where it does outside its limit.
    pub counter_example: Option<String>,
    /// Where the verdict is seen: the point of a counter-example, or the points that show a dependence or a value that does.
    #[serde(skip)]
    pub points: Vec<NamedPoint>,
    /// What an independent evaluation found against what was proved: the program is at fault.
    #[serde(skip)]
    pub contradictions: Vec<String>,
    /// Numbers by name, for a replacement of the sentence.
    #[serde(skip)]
    pub numbers: BTreeMap<String, String>,
    /// What a reader should know besides: ambiguities, slips of the pen, captions that disagree.
    pub remarks: Vec<String>,
}

impl Finding {
    /// Starts from derivations: holds when all succeed, fails with the first step that is false, and is not checked without any.
    pub(crate) fn from_proofs(attempts: impl IntoIterator<Item = Result<Proof, Refutation>>) -> Self {
        let mut attempts = attempts.into_iter();
        let first = attempts.next().map(Finding::from_proof);
        let finding = first.map(|first| attempts.fold(first, Finding::with_proof));
        finding.unwrap_or_else(|| Finding::not_checked("No derivation was tried."))
    }

    /// Starts from one derivation: holds when it succeeds, and fails when a step of it is false. A step that the rules do not decide decides
    /// nothing.
    pub(crate) fn from_proof(attempt: Result<Proof, Refutation>) -> Self {
        match rechecked(attempt) {
            Ok(proof) => Finding::holding(Evidence::Proof { proof }),
            Err(refutation) if refutation.is_false => Finding::failing(refutation.to_string()),
            Err(refutation) => Finding::not_checked(refutation.to_string()),
        }
    }

    /// A claim that is false: fails when its disproof succeeds, and is not decided when the disproof does not go through.
    pub(crate) fn from_disproof(disproof: Result<Proof, Refutation>, counter_example: &str) -> Self {
        match rechecked(disproof) {
            Ok(proof) => Finding::holding(Evidence::Proof { proof }).refuted(counter_example),
            Err(refutation) => Finding::not_checked(format!("The disproof fails: {refutation}")),
        }
    }

    /// Starts from a computation: holds as surely as it is, unless a later condition is not met. A computation over no run and no
    /// point decides nothing.
    pub(crate) fn from_evidence(evidence: Evidence) -> Self {
        match evidence.is_empty() {
            true => Finding::not_checked("The computation has no run and no point."),
            false => Finding::holding(evidence),
        }
    }

    /// A claim that fails for a reason that needs no evidence besides.
    pub(crate) fn failing(counter_example: impl Into<String>) -> Self {
        let (verdict, strength) = (Verdict::Fails, Some(Strength::Exact));
        Finding { verdict, strength, counter_example: Some(counter_example.into()), ..Finding::default() }
    }

    /// It rests on enclosures with outward rounding, unless what decides it is rational.
    pub(crate) fn enclosed_unless(mut self, is_rational: bool) -> Self {
        self.strength = self.strength.map(|it| if is_rational { it } else { it.max(Strength::Certified) });
        self
    }

    /// A claim that this report gives no ground to decide. No evidence added later turns it into one that holds.
    pub(crate) fn not_checked(reason: impl Into<String>) -> Self {
        Finding { remarks: vec![reason.into()], ..Finding::default() }
    }

    /// A claim on which two evaluations of the program contradict each other: it is not checked, and the program is at fault.
    pub(crate) fn contradicted(contradiction: String) -> Self {
        let finding = Finding::not_checked(format!("Error of slipmode: {contradiction}"));
        Finding { contradictions: vec![contradiction], ..finding }
    }

    /// Where the verdict is seen.
    pub(crate) fn seen_at(mut self, points: impl IntoIterator<Item = NamedPoint>) -> Self {
        self.points.extend(points);
        self
    }

    fn holding(evidence: Evidence) -> Self {
        let (verdict, strength) = (Verdict::Holds, Some(evidence.strength()));
        Finding { verdict, strength, evidence: vec![evidence], ..Finding::default() }
    }

    /// Adds one more derivation that must succeed.
    pub(crate) fn with_proof(self, attempt: Result<Proof, Refutation>) -> Self {
        match rechecked(attempt) {
            Ok(proof) => self.with_evidence(Evidence::Proof { proof }),
            Err(refutation) if refutation.is_false => self.refuted(refutation.to_string()),
            Err(refutation) if self.verdict == Verdict::Holds => Finding::not_checked(refutation.to_string()),
            Err(refutation) => self.remark(refutation.to_string()),
        }
    }

    /// Names the theorem that states what this finding's one proof proves or disproves, where an independent kernel has accepted it.
    pub(crate) fn with_theorem(mut self, theorem: impl FnOnce(Verdict) -> Option<String>) -> Self {
        let is_decided = self.verdict != Verdict::NotChecked;
        if let (true, [Evidence::Proof { proof }]) = (is_decided, &mut self.evidence[..]) {
            proof.theorem = theorem(self.verdict);
            self.strength = Some(self.evidence[0].strength());
        }
        self
    }

    /// Names the theorems that state the claim as it is written, and that an independent kernel has accepted. Every proof that
    /// decides it, and every part that a point decides, then counts as checked by that kernel.
    pub(crate) fn with_whole_theorem(mut self, name: &str) -> Self {
        let deciding: Vec<usize> = match self.readings.first() {
            Some(written) => written.parts.iter().flat_map(Part::deciding).collect(),
            None => self.deciding().collect(),
        };
        for (evidence, _) in self.evidence.iter_mut().zip(1..).filter(|(_, at)| deciding.contains(at)) {
            if let Evidence::Proof { proof } = evidence {
                proof.theorem.get_or_insert_with(|| name.to_owned());
            }
        }
        // The first reading is the written one.
        for (at, reading) in self.readings.iter_mut().enumerate() {
            for part in reading.parts.iter_mut().filter(|part| part.verdict != Verdict::NotChecked) {
                let known = if at == 0 { Some(Strength::KernelChecked) } else { part.strength };
                part.strength = weakest(&self.evidence, part.deciding()).or(known);
            }
            reading.strength =
                reading.strength.and(reading.parts.iter().map(|part| part.strength).max().flatten());
        }
        self.strength = match self.readings.first() {
            Some(written) => written.strength,
            None => weakest(&self.evidence, deciding).or(Some(Strength::KernelChecked)),
        };
        self
    }

    /// Adds what another claim found, which must hold; its limit limits this one too.
    pub(crate) fn with_premise(self, premise: Finding) -> Self {
        match premise.verdict {
            Verdict::Holds | Verdict::HoldsWithin => {
                let found = premise.evidence.into_iter().fold(self, Finding::with_evidence);
                match premise.limit.filter(|_| premise.verdict == Verdict::HoldsWithin) {
                    Some(limit) if found.verdict != Verdict::Fails => found.limited(limit),
                    _ => found,
                }
            }
            Verdict::Fails => self.refuted(premise.counter_example.unwrap_or_default()),
            Verdict::NotChecked => Finding {
                contradictions: premise.contradictions,
                ..Finding::not_checked(premise.remarks.join(" "))
            },
        }
    }

    /// Adds evidence, lowering the strength where it is weaker.
    pub(crate) fn with_evidence(mut self, evidence: Evidence) -> Self {
        self.strength = self.strength.map(|known| known.max(evidence.strength()));
        self.evidence.push(evidence);
        self
    }

    /// Adds evidence that illustrates what stronger evidence decided: the strength stays.
    pub(crate) fn with_supporting(mut self, evidence: Evidence) -> Self {
        self.evidence.push(evidence);
        self.supporting.push(self.evidence.len());
        self
    }

    /// The positions of the evidence that decides it, where it has one reading of one part.
    fn deciding(&self) -> impl Iterator<Item = usize> {
        (1..=self.evidence.len()).filter(|at| !self.supporting.contains(at))
    }

    /// Is it stated to be surer than its weakest reading, part or evidence?
    pub(crate) fn is_overstated(&self) -> bool {
        let is_below = |stated: Option<Strength>, weakest| stated.is_some() && weakest > stated;
        let part = |part: &Part| is_below(part.strength, weakest(&self.evidence, part.deciding()));
        let reading = |reading: &Reading| {
            reading.parts.iter().any(|one| is_below(reading.strength, one.strength) || part(one))
        };
        match self.readings.first() {
            None => is_below(self.strength, weakest(&self.evidence, self.deciding())),
            Some(written) => is_below(self.strength, written.strength) || self.readings.iter().any(reading),
        }
    }

    /// A claim that the evidence refutes; the first counter-example is kept.
    pub(crate) fn refuted(mut self, counter_example: impl Into<String>) -> Self {
        self.verdict = Verdict::Fails;
        self.strength.get_or_insert(Strength::Sampled);
        self.outside(counter_example)
    }

    /// Requires a computed condition; when it is false the claim fails with the given counter-example.
    pub(crate) fn require(self, condition: bool, counter_example: impl FnOnce() -> String) -> Self {
        if condition { self } else { self.refuted(counter_example()) }
    }

    /// A claim that holds only inside a limit, and inside those that it has already; one that fails already stays failed.
    pub(super) fn limited(mut self, limit: String) -> Self {
        self.limit = Some(match self.limit.filter(|_| self.verdict == Verdict::HoldsWithin) {
            Some(known) if known.split("; ").any(|one| one == limit) => known,
            Some(known) => format!("{known}; {limit}"),
            None => limit,
        });
        if self.verdict == Verdict::Holds {
            self.verdict = Verdict::HoldsWithin;
        }
        self
    }

    /// A claim about more than these things: it holds within them.
    pub(super) fn decided_for(self, things: &str) -> Self {
        let is_true = matches!(self.verdict, Verdict::Holds | Verdict::HoldsWithin);
        if is_true { self.limited(things.to_owned()) } else { self }
    }

    /// The points that a universal statement was looked at on, or how far a statement goes; the verdict stays.
    pub(crate) fn on(mut self, points: impl Into<String>) -> Self {
        self.limit = Some(points.into());
        self
    }

    /// Where the claim stops holding, outside its limit: shown next to it, without changing the verdict.
    pub(crate) fn outside(mut self, counter_example: impl Into<String>) -> Self {
        self.counter_example.get_or_insert(counter_example.into());
        self
    }

    /// The step from what was decided to what the claim says is argued in words: the claim is no surer than that.
    pub(crate) fn argued(mut self, step: &str) -> Self {
        let readings = self.readings.iter_mut().map(|reading| &mut reading.strength);
        for strength in readings.chain([&mut self.strength]).flatten() {
            *strength = Strength::Argued.max(*strength);
        }
        self.remark(format!("Argued in words: {step}"))
    }

    /// Names a number for a replacement of the sentence.
    pub(crate) fn number(mut self, name: impl Into<String>, value: String) -> Self {
        self.numbers.insert(name.into(), value);
        self
    }

    /// Adds a remark for readers.
    pub(crate) fn remark(mut self, remark: impl Into<String>) -> Self {
        self.remarks.push(remark.into());
        self
    }
}

/// The strength of the weakest evidence at these positions, from 1.
fn weakest(evidence: &[Evidence], positions: impl IntoIterator<Item = usize>) -> Option<Strength> {
    positions.into_iter().map(|at| evidence[at - 1].strength()).max()
}

fn rechecked(attempt: Result<Proof, Refutation>) -> Result<Proof, Refutation> {
    attempt.and_then(|proof| proof.recheck().map(|()| proof))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_algebra::Domain;

    fn sample(points: usize) -> Evidence {
        Evidence::Sample { quantity: "q".into(), value: "1".into(), points }
    }

    #[test]
    fn without_evidence_nothing_holds() {
        assert_eq!(Finding::from_proofs([]).verdict, Verdict::NotChecked);
        assert_eq!(Finding::from_evidence(sample(0)).verdict, Verdict::NotChecked);
        let proof = Proof::new("no-step", "A statement without a certificate.").reason("Because.");
        assert_eq!(Finding::from_proof(Ok(proof)).verdict, Verdict::NotChecked);
        let undecided = Finding::from_proofs([]).with_evidence(sample(1)).limited("a limit".into());
        assert_eq!((undecided.verdict, undecided.strength), (Verdict::NotChecked, None));
    }

    #[test]
    fn what_is_argued_from_a_point_or_a_proof_is_no_surer_than_argued() {
        assert_eq!(Finding::failing("at a point").argued("a step").strength, Some(Strength::Argued));
        assert_eq!(Finding::not_checked("no proof").argued("a step").strength, None);
    }

    #[test]
    fn a_proof_with_a_step_in_words_is_argued() {
        let domain = Domain::positive("x");
        let expression = |text: &str| text.parse().unwrap();
        let proof = Proof::new("p", "A statement.")
            .identity("a step", &[], &expression("x + x"), &expression("2*x"), &domain)
            .unwrap();
        assert_eq!(Finding::from_proof(Ok(proof.clone())).strength, Some(Strength::Exact));
        let argued = proof.reason("Because.");
        assert!(argued.to_string().ends_with("  2. Because. [argued]\n"), "{argued}");
        assert_eq!(Finding::from_proof(Ok(argued.clone())).strength, Some(Strength::Argued));
        let both = Finding::from_evidence(sample(1)).with_proof(Ok(argued));
        assert_eq!(both.strength, Some(Strength::Sampled));
    }

    #[test]
    fn a_strength_above_that_of_a_part_or_of_evidence_is_overstated() {
        use crate::claims::reading::{Draft, of_readings};
        let strong = Evidence::Enclosure { quantity: "e".into(), value: "1".into() };
        let plain = Finding::from_evidence(strong).with_evidence(sample(1));
        let illustrated = Finding::from_evidence(plain.evidence[0].clone()).with_supporting(sample(1));
        let parts = || of_readings([Draft::new("r").part("p", plain.clone()).part("q", illustrated.clone())]);
        for honest in [plain.clone(), illustrated.clone(), parts()] {
            assert!(!honest.is_overstated(), "{honest:?}");
        }
        let stated = Finding { strength: Some(Strength::Certified), ..plain.clone() };
        let hidden = Finding { supporting: Vec::new(), ..illustrated.clone() };
        let whole = Finding { strength: Some(Strength::Certified), ..parts() };
        let (mut reading, mut part) = (parts(), parts());
        reading.readings[0].strength = Some(Strength::Exact);
        part.readings[0].parts[0].strength = Some(Strength::Exact);
        for overstated in [stated, hidden, whole, reading, part] {
            assert!(overstated.is_overstated(), "{overstated:?}");
        }
    }

    #[test]
    fn a_whole_theorem_checks_the_claim_as_it_is_written_and_no_other_reading() {
        use crate::claims::reading::{Draft, of_readings};
        let proof = |id: &str| {
            let argued = Proof::new(id, "A statement.").reason("Because.").reason("And because.");
            Finding {
                strength: Some(Strength::Argued),
                ..Finding::from_evidence(Evidence::Proof { proof: argued })
            }
        };
        let written = Draft::new("r")
            .part("p", proof("p").with_supporting(sample(1)))
            .part("q", Finding::failing("at a point"));
        let other = Draft::new("s").part("t", proof("t")).part("u", Finding::failing("at a point"));
        let found = of_readings([written, other]).with_whole_theorem("Slider.S1");
        let theorem = |at: usize| found.evidence[at].proof().and_then(|proof| proof.theorem.as_deref());
        assert_eq!((theorem(0), theorem(2)), (Some("Slider.S1"), None));
        assert_eq!(
            (found.strength, found.readings[0].strength),
            (Some(Strength::KernelChecked), Some(Strength::KernelChecked))
        );
        assert_eq!(
            (found.readings[1].strength, found.readings[1].parts[1].strength),
            (Some(Strength::Argued), Some(Strength::Exact))
        );
        assert!(!found.is_overstated());
        // What no proof decides stays as it is.
        let sampled = Finding::from_evidence(sample(1)).with_evidence(proof("p").evidence[0].clone());
        assert_eq!(sampled.with_whole_theorem("Slider.S1").strength, Some(Strength::Sampled));
    }

    #[test]
    fn evidence_decides_and_a_refutation_overrules_it() {
        assert_eq!(Finding::from_evidence(sample(1)).verdict, Verdict::Holds);
        assert_eq!(Finding::from_evidence(sample(1)).strength, Some(Strength::Sampled));
        assert_eq!(Finding::from_evidence(sample(1)).require(false, || "x".into()).verdict, Verdict::Fails);
        assert_eq!(Finding::failing("x").with_evidence(sample(1)).verdict, Verdict::Fails);
    }
}
