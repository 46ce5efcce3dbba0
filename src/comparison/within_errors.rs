//! A run whose parameters have error bars: what differs at their middle is compared with the range over them, which is sampled.

use crate::parallel;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Rational, format::ends_around};

use super::findings::{compare_as_stated, verdict_of};
use super::{Agreement, Comparison, Finding, Simulate, StatedRun, Value};
use crate::comparison::recording::Measured;

/// Significant digits of the ends of a range, in words.
const DIGITS: usize = 6;

/// The range of values with their absolute errors; none without values. A value without an error that is a number has no bounds.
pub(crate) fn sampled_range(values: impl Iterator<Item = (f64, f64)>) -> Option<[f64; 2]> {
    let bounded = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
    let ends = values.map(|(value, error)| [value - bounded(error), value + bounded(error)]);
    ends.reduce(|[low, high], [next_low, next_high]| [low.min(next_low), high.max(next_high)])
}

/// Compares the run at other values within the error bars too, and what differs with the range over all of them.
///
/// Each quantity is compared on its own: two of them may agree at different values.
pub(super) fn look_within_error_bars(
    run: &StatedRun,
    others: &[Parameters<Rational>],
    simulate: Simulate<'_>,
    found: &mut Comparison,
) {
    let at = |parameters: &Parameters<Rational>| {
        compare_as_stated(&StatedRun { parameters: parameters.clone(), ..run.clone() }, simulate).findings
    };
    let elsewhere: Vec<Vec<Finding>> = parallel::map(others, at);
    for finding in found.findings.iter_mut().filter(|finding| finding.verdict == Agreement::Differs) {
        let subject = (finding.observable, finding.origin, finding.reference);
        let is_same = |other: &&Finding| (other.observable, other.origin, other.reference) == subject;
        let same: Vec<&Finding> = elsewhere.iter().flatten().filter(is_same).collect();
        finding.widen(&same, others.len() + 1, run.tolerance);
    }
    found.verdict = verdict_of(&found.findings);
}

impl Finding {
    /// Compares with the range over the error bars, of which `others` are findings in other runs than that of the middle values.
    fn widen(&mut self, others: &[&Self], runs: usize, tolerance: f64) {
        match self.run {
            Value::None => {}
            Value::Word(word) => {
                let agreeing = others.iter().filter(|other| other.verdict == Agreement::Agrees).count();
                self.why = format!("{word} in {agreeing} of {runs} sampled runs within the error bars");
                if agreeing > 0 {
                    self.verdict = Agreement::AgreesWithinErrorBars;
                }
            }
            Value::Number(run) => {
                let all = others.iter().copied().chain([&*self]);
                let ours = all.filter_map(|finding| match finding.ours {
                    Value::Number(ours) => Some(ours.with_absolute_error()),
                    Value::Word(_) | Value::None => None,
                });
                if let Some(ends) = sampled_range(ours) {
                    self.compare_with_range(run, ends, runs, tolerance);
                }
            }
        }
    }

    /// Compares with the nearest value of a range; the errors of its values are part of it.
    fn compare_with_range(&mut self, run: Measured, [low, high]: [f64; 2], runs: usize, tolerance: f64) {
        let nearest = Measured { value: run.value.clamp(low, high), relative_error: 0.0 };
        let subject = (self.observable, self.origin, self.reference);
        let found = Self::of_numbers(subject, [run, nearest], tolerance);
        let ends = ends_around([low, high], DIGITS).join(" to ");
        let unit = self.observable.unit();
        let range = format!("{ends} {unit} is the sampled range of {runs} runs within the error bars");
        (self.range, self.difference, self.allowed) = (Some([low, high]), found.difference, found.allowed);
        (self.verdict, self.why) = match found.verdict {
            Agreement::NotCompared => (Agreement::NotCompared, found.why),
            Agreement::Agrees => (Agreement::AgreesWithinErrorBars, range),
            differs => (differs, range),
        };
    }
}
