//! Other people's runs compared with the linear theory and with our own simulation.
//!
//! A run states parameters and what came out of it: values, words, or a trajectory. Each is compared with every reference that
//! can say something of it, within the run's own tolerance plus the errors of both sides. What cannot be compared says why,
//! and is never a pass. Where the parameters have error bars, a value may also agree with the range over them, which is sampled.

mod agreement;
mod findings;
pub mod recording;
mod reference;
mod stated;
mod units;
mod within_errors;

pub use agreement::{Agreement, Finding, Observable, Origin, Reference, Value};
pub use findings::{Comparison, simulated};
pub use reference::{Simulate, Theory};
pub use stated::{StatedMode, StatedRun};
pub(crate) use within_errors::sampled_range;

use findings::compare_as_stated;
use slipmode_core::{friction::Parameters, number::Rational};

/// Compares a run, at its parameters and, where these do not agree, at the others within their error bars.
pub(crate) fn compare_run(
    run: &StatedRun,
    others: &[Parameters<Rational>],
    simulate: Simulate<'_>,
) -> Comparison {
    let mut found = compare_as_stated(run, simulate);
    if found.verdict == Agreement::Differs && !others.is_empty() {
        within_errors::look_within_error_bars(run, others, simulate, &mut found);
    }
    found.diagnosis = match found.verdict {
        Agreement::Agrees | Agreement::AgreesWithinErrorBars => None,
        _ if run.is_empty() => Some("the row has nothing to compare".into()),
        // Velocities in another unit never pass V_l, so that such a trajectory is not even compared.
        Agreement::Differs | Agreement::NotCompared => units::diagnose(run, simulate),
    };
    found
}
