//! The parts of a finding, and the readings of a sentence that they are parts of.

use serde::Serialize;

use crate::claims::{Strength, Verdict};

/// A statement that a reading consists of, decided on its own.
#[derive(Debug, Clone, Serialize)]
pub struct Part {
    /// The statement.
    pub words: String,
    /// Its verdict.
    pub verdict: Verdict,
    /// The strength of its weakest evidence; none where it is not checked.
    pub strength: Option<Strength>,
    /// The limit within which it holds, the points that it was looked at on, or why it was not checked.
    pub limit: Option<String>,
    /// Why it fails, or where it does outside its limit.
    pub counter_example: Option<String>,
    /// Its evidence, as positions in the claim's list, from 1.
    pub evidence: Vec<usize>,
    /// Those of them that only illustrate what the others decided.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub supporting: Vec<usize>,
}

impl Part {
    /// The positions of the evidence that decides it.
    pub(super) fn deciding(&self) -> impl Iterator<Item = usize> {
        self.evidence.iter().copied().filter(|at| !self.supporting.contains(at))
    }

    /// Why it fails, within which limit it holds, or why it was not checked; may be empty.
    pub(crate) fn result(&self) -> &str {
        let result = if self.verdict == Verdict::Fails { &self.counter_example } else { &self.limit };
        result.as_deref().unwrap_or_default()
    }
}

/// Verdict and strength; what is not checked has none.
#[must_use]
pub fn verdict_words(verdict: Verdict, strength: Option<Strength>) -> String {
    strength.map_or_else(|| verdict.to_string(), |strength| format!("{verdict}, {strength}"))
}

/// One way to read a claim.
#[derive(Debug, Clone, Serialize)]
pub struct Reading {
    /// What the claim says in this reading.
    pub words: String,
    /// The verdict on the claim in this reading.
    pub verdict: Verdict,
    /// The strength of its weakest part; none where it is not checked.
    pub strength: Option<Strength>,
    /// What has to be true, all of it.
    pub parts: Vec<Part>,
}
