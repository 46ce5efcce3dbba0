//! A finding: the verdict on one claim, with everything that led to it.

use serde::Serialize;

use crate::claims::{Evidence, Strength, Verdict};
use slipmode_core::polynomial::{Proof, Refutation};

/// What a check concluded, why, and where it stops.
#[derive(Debug, Clone, Serialize)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The strength of the weakest evidence.
    pub strength: Strength,
    /// Everything the verdict rests on.
    pub evidence: Vec<Evidence>,
    /// The limit within which the claim holds, quantified.
    pub limit: Option<String>,
    /// Why the claim fails, or where it does outside its limit.
    pub counter_example: Option<String>,
    /// What a reader should know besides: ambiguities, slips of the pen, captions that disagree.
    pub remarks: Vec<String>,
}

impl Finding {
    /// Starts from derivations: holds when all succeed, fails with the first refutation otherwise.
    #[must_use]
    pub fn from_proofs(attempts: impl IntoIterator<Item = Result<Proof, Refutation>>) -> Self {
        let mut finding = Finding::holding(Strength::Exact);
        for attempt in attempts {
            finding.include(attempt);
        }
        finding
    }

    /// A claim that is false: fails when its disproof succeeds, and is not decided when the disproof does not go through.
    #[must_use]
    pub fn from_disproof(disproof: Result<Proof, Refutation>, counter_example: &str) -> Self {
        match disproof.and_then(|proof| proof.recheck().map(|()| proof)) {
            Ok(proof) => Finding::holding(Strength::Exact).with_proof(Ok(proof)).refuted(counter_example),
            Err(refutation) => Finding::not_checked(format!("The disproof fails: {refutation}")),
        }
    }

    /// A finding without evidence yet, as sure as exact until weaker evidence is added.
    fn holding(strength: Strength) -> Self {
        Finding {
            verdict: Verdict::Holds,
            strength,
            evidence: Vec::new(),
            limit: None,
            counter_example: None,
            remarks: Vec::new(),
        }
    }

    /// A claim that this report gives no ground to decide.
    #[must_use]
    pub fn not_checked(reason: impl Into<String>) -> Self {
        Finding {
            verdict: Verdict::NotChecked,
            remarks: vec![reason.into()],
            ..Finding::holding(Strength::Sampled)
        }
    }

    fn include(&mut self, attempt: Result<Proof, Refutation>) {
        match attempt.and_then(|proof| proof.recheck().map(|()| proof)) {
            Ok(proof) => self.evidence.push(Evidence::Proof { proof }),
            Err(refutation) => self.refute(refutation.to_string()),
        }
    }

    /// Turns the verdict to `fails`; the first counter-example is kept.
    fn refute(&mut self, counter_example: String) {
        self.verdict = Verdict::Fails;
        self.counter_example.get_or_insert(counter_example);
    }

    /// Adds one more derivation that must succeed.
    #[must_use]
    pub fn with_proof(mut self, attempt: Result<Proof, Refutation>) -> Self {
        self.include(attempt);
        self
    }

    /// Adds evidence, lowering the strength where it is weaker.
    #[must_use]
    pub fn with_evidence(mut self, evidence: Evidence) -> Self {
        self.strength = self.strength.max(evidence.strength());
        self.evidence.push(evidence);
        self
    }

    /// Adds evidence that illustrates what stronger evidence decided: the strength stays.
    #[must_use]
    pub fn with_supporting(mut self, evidence: Evidence) -> Self {
        self.evidence.push(evidence);
        self
    }

    /// A claim that the evidence refutes.
    #[must_use]
    pub fn refuted(mut self, counter_example: impl Into<String>) -> Self {
        self.refute(counter_example.into());
        self
    }

    /// Requires a computed condition; when it is false the claim fails with the given counter-example.
    #[must_use]
    pub fn require(mut self, condition: bool, counter_example: impl FnOnce() -> String) -> Self {
        if !condition {
            self.refute(counter_example());
        }
        self
    }

    /// A claim that holds only inside `limit`; one that fails already stays failed.
    #[must_use]
    pub fn within(mut self, limit: impl Into<String>) -> Self {
        if self.verdict == Verdict::Holds {
            self.verdict = Verdict::HoldsWithin;
        }
        self.limit = Some(limit.into());
        self
    }

    /// Where the claim stops holding, outside its limit: shown next to it, without changing the verdict.
    #[must_use]
    pub fn outside(mut self, counter_example: impl Into<String>) -> Self {
        self.counter_example.get_or_insert(counter_example.into());
        self
    }

    /// Adds a remark for readers.
    #[must_use]
    pub fn remark(mut self, remark: impl Into<String>) -> Self {
        self.remarks.push(remark.into());
        self
    }
}
