//! What a finding rests on, and how sure that makes it.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use slipmode_algebra::Proof;

slipmode_algebra::named! {
    /// How sure a finding is; a finding is as sure as its weakest evidence.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Strength {
        /// Proved, and Coq accepted the whole statement as a theorem.
        KernelChecked = "kernel-checked",
        /// Decided over the rationals.
        Exact = "exact",
        /// Proved, but for a step that is argued in words and carries no certificate.
        Argued = "argued",
        /// Enclosed with outward rounding.
        Certified = "certified",
        /// Refined, with an error estimate.
        Converged = "converged",
        /// Looked at on finitely many points.
        #[default]
        Sampled = "sampled",
    }
}

/// The strengths of what is decided by proofs, and by steps argued in words.
pub const PROVED: RangeInclusive<Option<Strength>> = Some(Strength::KernelChecked)..=Some(Strength::Argued);

/// One piece of evidence.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Evidence {
    /// An identity or inequality over ℚ with its certificate.
    Proof {
        /// The proof, re-checked when the ledger is made.
        proof: Proof,
    },
    /// A number with certain digits.
    Enclosure {
        /// What was enclosed.
        quantity: String,
        /// Its certain digits, with unit.
        value: String,
    },
    /// A number from simulations, each run again at a tenth of its tolerance.
    Simulation {
        /// What was simulated.
        quantity: String,
        /// What was found, with unit.
        value: String,
        /// The largest error estimate of the runs.
        error: String,
        /// The number of runs.
        runs: usize,
    },
    /// A count or extreme over finitely many points.
    Sample {
        /// What was looked at.
        quantity: String,
        /// What was found, with unit.
        value: String,
        /// On how many points.
        points: usize,
    },
}

impl Evidence {
    /// A certified value of a quantity.
    pub fn enclosure(quantity: impl Into<String>, value: impl Into<String>) -> Self {
        Self::Enclosure { quantity: quantity.into(), value: value.into() }
    }

    /// A value of a quantity that was read from so many points.
    pub fn sample(quantity: impl Into<String>, value: impl Into<String>, points: usize) -> Self {
        Self::Sample { quantity: quantity.into(), value: value.into(), points }
    }

    /// Whether it rests on no run and no point at all.
    pub(crate) fn is_empty(&self) -> bool {
        matches!(self, Evidence::Simulation { runs: 0, .. } | Evidence::Sample { points: 0, .. })
    }

    /// Whether both are the same proof, or the same value of the same quantity.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.name_and_value() == other.name_and_value()
    }

    fn name_and_value(&self) -> (&str, &str) {
        match self {
            Evidence::Proof { proof } => (&proof.id, &proof.statement),
            Evidence::Enclosure { quantity, value }
            | Evidence::Simulation { quantity, value, .. }
            | Evidence::Sample { quantity, value, .. } => (quantity, value),
        }
    }

    /// The proof, if it is one.
    pub(crate) fn proof(&self) -> Option<&Proof> {
        match self {
            Evidence::Proof { proof } => Some(proof),
            _ => None,
        }
    }

    /// How sure this piece is.
    pub(crate) fn strength(&self) -> Strength {
        match self {
            Evidence::Proof { proof } if proof.theorem.is_some() => Strength::KernelChecked,
            Evidence::Proof { proof } if proof.is_certified() => Strength::Exact,
            Evidence::Proof { .. } => Strength::Argued,
            Evidence::Enclosure { .. } => Strength::Certified,
            Evidence::Simulation { .. } => Strength::Converged,
            Evidence::Sample { .. } => Strength::Sampled,
        }
    }
}
