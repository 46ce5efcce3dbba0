//! The parts into which a report's chapters are kept apart, as verification and validation are.

use crate::scene::Problem;
use crate::scene::section::Entry;

slipmode_algebra::named! {
    /// What the chapters of a part are about.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Part {
        /// What the paper says, compared with computation.
        Validation = "validation",
        /// Results that the paper does not have.
        NewResults = "new-results",
        /// Whether the formulas and the program are right: decided exactly.
        CodeVerification = "code-verification",
        /// How large the numerical error of the report's own runs is.
        SolutionVerification = "solution-verification",
        /// What the results cost.
        Speed = "speed",
        /// What supports the report.
        Appendix = "appendix",
        /// What of the paper holds for the report's own slider: folded at the end, with the verdicts and the ledger.
        Paper = "paper",
    }
}

impl Part {
    /// Whether the ledger stands before the part: it follows the comparison with the paper and the new results.
    pub(crate) const fn follows_ledger(self) -> bool {
        !matches!(self, Self::Validation | Self::NewResults)
    }

    /// Reads the part of a chapter after those of the `earlier` chapters: the chapters of a part follow one another.
    pub(crate) fn read(entry: &Entry<'_>, earlier: &[Option<Self>]) -> Option<Self> {
        let part = entry.word(&Self::ALL, Self::as_str)?;
        let left = earlier.iter().rev().skip_while(|before| **before == Some(part));
        if left.into_iter().any(|before| *before == Some(part)) {
            let of =
                "a part that ended before other chapters (the chapters of a part follow one another)".into();
            return entry.refuse(Problem::Duplicate { of, folded: false });
        }
        Some(part)
    }
}
