//! The four verdicts, with their words and signs: what `claims.toml` records, a check computes, and pages show.

use serde::{Deserialize, Serialize};

slipmode_algebra::named! {
    /// What the program concludes about a claim.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Verdict {
        /// True as stated.
        Holds = "holds",
        /// True inside a limit that the finding quantifies.
        HoldsWithin = "holds-within",
        /// Refuted: the finding names a counter-example.
        Fails = "fails",
        /// This report has no evidence that decides the claim.
        #[default]
        NotChecked = "not-checked",
    }
}

impl Verdict {
    /// The verdict in plain words.
    #[must_use]
    pub fn word(self) -> String {
        self.as_str().replace('-', " ")
    }

    /// The verdict as a sign that needs no colour.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Holds => "✓",
            Self::HoldsWithin => "≈",
            Self::Fails => "✗",
            Self::NotChecked => "–",
        }
    }
}
