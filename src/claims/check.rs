//! The procedures that claims name: what decides a part of a claim, and what is shown beside it.

use crate::claims::{Evidence, Finding};
use crate::experiments::{Context, Need};
use slipmode_core::number::{Rational, parse_quotient};
use slipmode_theory::Role;

/// A procedure that decides a part of a claim. `claims.toml` names it.
#[derive(Debug)]
pub(super) struct Check {
    /// Its name.
    pub name: &'static str,
    /// Whether it is about runs, which are computed without the equations of the report.
    pub is_of_runs: bool,
    /// The equations that it starts from.
    pub roles: &'static [Role],
    /// What it needs computed.
    pub needs: &'static [Need],
    /// Computes the verdict.
    pub decide: fn(&Context, Asked) -> Finding,
}

impl Check {
    /// A procedure about equations.
    pub const fn new(
        name: &'static str,
        roles: &'static [Role],
        decide: fn(&Context, Asked) -> Finding,
    ) -> Self {
        Self { name, is_of_runs: false, roles, needs: &[], decide }
    }

    /// A procedure about runs, which needs this computed.
    pub const fn of_runs(self, needs: &'static [Need]) -> Self {
        Self { is_of_runs: true, needs, ..self }
    }
}

/// A procedure that computes evidence beside what decides. `claims.toml` names it.
#[derive(Debug)]
pub(super) struct Show {
    /// Its name.
    pub name: &'static str,
    /// What it needs computed.
    pub needs: &'static [Need],
    /// Computes the evidence, where the report has what it looks at.
    pub evidence: fn(&Context) -> Option<Vec<Evidence>>,
}

impl Show {
    pub const fn new(
        name: &'static str,
        needs: &'static [Need],
        evidence: fn(&Context) -> Option<Vec<Evidence>>,
    ) -> Self {
        Self { name, needs, evidence }
    }
}

/// What a procedure is asked, besides the equations and the outcome.
pub(super) struct Asked<'c> {
    /// What it is asked about.
    pub of: &'c [String],
    /// What proofs and premises beside it found; none where there are none.
    pub proved: Option<Finding>,
}

/// What is said where a procedure is asked about a number, and `of` has none.
pub(super) const NO_NUMBER: &str = "Not decided: `of` has to be one positive number.";

impl<'c> Asked<'c> {
    /// The positive number that it is asked about, as it is written and as it is.
    pub fn number(&self) -> Option<(&'c str, Rational)> {
        let [text] = self.of else { return None };
        parse_quotient(text).ok().filter(|number| *number > 0).map(|number| (text.as_str(), number))
    }

    /// What proofs and premises found, for a procedure that needs some.
    pub fn proved(self) -> Finding {
        self.proved.unwrap_or_else(|| Finding::from_proofs([]))
    }
}
