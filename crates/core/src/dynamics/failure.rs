//! How an integration can end without an answer; every case says how far it came.

use thiserror::Error;

/// Why a run has no result. Times are in units of D_c/V_l.
///
/// ```
/// use slipmode_core::dynamics::Failure;
///
/// let failure = Failure::UnreachableTolerance { requested: 1e-18, reached: 1e-14 };
/// assert!(failure.to_string().contains("not attainable"));
/// ```
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Failure {
    /// The start is not a state of finite numbers, or a group is not positive.
    #[error("the start or a group is not a finite, admissible number")]
    InvalidStart,
    /// No step, however short, meets the tolerance.
    #[error(
        "no step meets the tolerance {tolerance:e} at time {time:e} D_c/V_l, where ln(V/V_l) = {log_velocity}"
    )]
    StepVanished {
        /// Local tolerance requested.
        tolerance: f64,
        /// Time since the start of the run or cycle.
        time: f64,
        /// ln(V/V_l) there.
        log_velocity: f64,
    },
    /// The run needs more steps than it is allowed.
    #[error("not finished after {steps} steps, at time {time:e} D_c/V_l")]
    TooManySteps {
        /// Steps taken.
        steps: u64,
        /// Time since the start of the run or cycle.
        time: f64,
    },
    /// Neither a limit cycle nor a decay was reached.
    #[error("long-term behaviour undecided{}; another tolerance or values farther from K = K_c may decide it, and `slipmode classify` says \
        exactly whether small oscillations grow, and how fast", met(*cycles, *change))]
    Undecided {
        /// Oscillations computed; 0 where runs were not accurate enough.
        cycles: u64,
        /// Relative change of the state from the last oscillation to the one before.
        change: f64,
    },
    /// The requested accuracy is below what the arithmetic gives.
    #[error("a relative error of {requested:e} is not attainable: {}",
        or(*reached, format!("{reached:.1e} was reached"), "the errors could not be estimated"))]
    UnreachableTolerance {
        /// Relative error requested.
        requested: f64,
        /// Relative error reached.
        reached: f64,
    },
}

/// What an undecided run has met.
fn met(cycles: u64, change: f64) -> String {
    match (cycles, change.is_finite()) {
        (0, _) => ": its runs are not accurate enough to tell a limit cycle from slow growth or decay".into(),
        (_, true) => format!(" after {cycles} oscillations: the last changed by a relative {change:.1e}"),
        (_, false) => format!(" after {cycles} oscillations: no two of them could be compared"),
    }
}

/// What is known of a number, or other words where it is not finite.
fn or(value: f64, known: String, otherwise: &str) -> String {
    if value.is_finite() { known } else { otherwise.into() }
}

#[cfg(test)]
mod tests {
    use super::Failure;

    #[test]
    fn no_message_prints_an_infinity() {
        let (requested, cycles) = (1e-8, 7);
        for value in [f64::INFINITY, f64::NAN] {
            let undecided = Failure::Undecided { cycles, change: value }.to_string();
            let missed = Failure::UnreachableTolerance { requested, reached: value }.to_string();
            assert!(
                undecided.contains("after 7 oscillations: no two of them could be compared;"),
                "{undecided}"
            );
            assert!(missed.ends_with("the errors could not be estimated"), "{missed}");
        }
        let unresolved = Failure::Undecided { cycles: 0, change: 1e-12 }.to_string();
        assert!(unresolved.contains("undecided: its runs are not accurate enough"), "{unresolved}");
        let finite = Failure::UnreachableTolerance { requested, reached: 1e-7 }.to_string();
        assert!(finite.ends_with("1.0e-7 was reached"), "{finite}");
    }
}
