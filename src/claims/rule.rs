//! The rule by which findings become verdicts: the kind of a sentence decides what refutes it.
//!
//! - A universal sentence fails with one counter-example. It holds within a limit only where the limit is a region: inside it holds
//!   without exception, and outside there are counter-examples. A count is no limit.
//! - An approximate sentence may be off by a tolerance that is the same for all of them: [`Measure::tolerance`].
//! - A qualitative sentence is decided as the weakest statement that its words cannot be denied to mean. The check names it.

use slipmode_core::number::format::{Side, round_digits, rounded};

use crate::claims::Finding;
use crate::scene::Kind;

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// A value: the deviation is relative.
    Value,
    /// A place on a logarithmic axis: the deviation is in decades.
    Place,
}

impl Measure {
    /// How far an approximate sentence may be off: 10 % of a value, a quarter decade of a place.
    const fn tolerance(self) -> f64 {
        match self {
            Self::Value => 0.1,
            Self::Place => 0.25,
        }
    }

    /// The factor from a deviation to its number in words, and the unit.
    const fn unit(self) -> (f64, &'static str) {
        match self {
            Self::Value => (100.0, "%"),
            Self::Place => (1.0, "dex"),
        }
    }
}

/// How far values or places are from those that a sentence names.
#[derive(Debug, Clone)]
pub(super) struct Deviations {
    measure: Measure,
    /// Each deviation with its error.
    each: Vec<(f64, f64)>,
}

impl Deviations {
    /// Deviations with their errors.
    pub(super) fn new(measure: Measure, each: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { measure, each: each.into_iter().collect() }
    }

    fn allowed(&self, kind: Kind) -> f64 {
        if kind == Kind::Approximate { self.measure.tolerance() } else { 0.0 }
    }

    /// How many are certainly outside of the tolerance, and how many may be.
    fn outside(&self, allowed: f64) -> [usize; 2] {
        let count = |is: &dyn Fn(&&(f64, f64)) -> bool| self.each.iter().filter(is).count();
        let certain = count(&|(size, error)| size.abs() - error > allowed);
        [certain, count(&|(size, error)| size.abs() + error > allowed) - certain]
    }

    /// The range in words, rounded outward.
    pub(super) fn range(&self) -> String {
        let (factor, unit) = self.measure.unit();
        let sizes = || self.each.iter().map(|(size, _)| size * factor);
        let (least, most) =
            (sizes().fold(f64::INFINITY, f64::min), sizes().fold(f64::NEG_INFINITY, f64::max));
        let [low, high] = [rounded(least, 3, Side::Below), rounded(most, 3, Side::Above)];
        if least == most { format!("{high} {unit}") } else { format!("{low} to {high} {unit}") }
    }
}

impl Finding {
    /// Whether a sentence of this kind may be off by these deviations: an approximate one by its tolerance, every other one by
    /// their errors only. An error that crosses the tolerance leaves it open.
    #[must_use]
    pub(super) fn near(self, kind: Kind, found: &Deviations) -> Self {
        let (factor, unit) = found.measure.unit();
        let allowed = found.allowed(kind);
        let tolerance = || format!("{} {unit}", round_digits(allowed * factor, 3));
        let count = found.each.len();
        match (found.outside(allowed), kind) {
            _ if found.each.is_empty() => Self::not_checked("There is nothing to compare."),
            ([0, 0], _) => self.on(format!("off by {}", found.range())),
            ([0, open], Kind::Approximate) => Self::not_checked(format!(
                "The error of {open} of {count} deviations crosses {}.",
                tolerance()
            )),
            ([0, _], _) => self.on(format!("off by {}, which the errors allow", found.range())),
            ([wrong, _], Kind::Approximate) => self.refuted(match count {
                1 => format!("off by {}, more than {}", found.range(), tolerance()),
                _ => format!("off by {}; {wrong} of {count} by more than {}", found.range(), tolerance()),
            }),
            (..) => self.refuted(format!("off by {}", found.range())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::{Evidence, Verdict};

    fn held() -> Finding {
        Finding::from_evidence(Evidence::Sample { quantity: "q".into(), value: "v".into(), points: 1 })
    }

    fn near(kind: Kind, each: &[(f64, f64)]) -> Finding {
        held().near(kind, &Deviations::new(Measure::Place, each.iter().copied()))
    }

    #[test]
    fn the_kind_of_a_sentence_decides_what_refutes_it() {
        let small = [(0.2, 1e-3), (-0.24, 1e-3)];
        let found = near(Kind::Approximate, &small);
        assert_eq!(
            (found.verdict, found.limit.as_deref()),
            (Verdict::Holds, Some("off by -0.24 to 0.2 dex"))
        );
        let found = near(Kind::Universal, &small);
        assert_eq!(found.verdict, Verdict::Fails);
        assert_eq!(found.counter_example.as_deref(), Some("off by -0.24 to 0.2 dex"));
        let found = near(Kind::Approximate, &[(0.2, 1e-3), (0.3, 1e-3)]);
        assert_eq!(
            found.counter_example.as_deref(),
            Some("off by 0.2 to 0.3 dex; 1 of 2 by more than 0.25 dex")
        );
    }

    #[test]
    fn an_error_that_crosses_the_tolerance_decides_nothing_and_one_above_a_deviation_allows_it() {
        assert_eq!(near(Kind::Approximate, &[(0.249, 2e-3)]).verdict, Verdict::NotChecked);
        assert_eq!(near(Kind::Universal, &[(1e-3, 2e-3)]).verdict, Verdict::Holds);
        assert_eq!(near(Kind::Universal, &[]).verdict, Verdict::NotChecked);
    }

    #[test]
    fn a_region_limits_what_holds_and_leaves_what_fails() {
        let found = held().limited("a < b".into()).outside("At a = b.");
        assert_eq!(
            (found.verdict, found.counter_example.as_deref()),
            (Verdict::HoldsWithin, Some("At a = b."))
        );
        let failing = Finding::failing("x").limited("a < b".into()).outside("At a = b.");
        assert_eq!(failing.verdict, Verdict::Fails);
    }
}
