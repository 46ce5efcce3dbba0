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
    #[error(
        "long-term behaviour undecided after {cycles} oscillations; the last changed by a relative {change:e}"
    )]
    Undecided {
        /// Oscillations computed.
        cycles: u64,
        /// Relative change of the state from the last oscillation to the one before.
        change: f64,
    },
    /// The requested accuracy is below what the arithmetic gives.
    #[error("a relative error of {requested:e} is not attainable: {reached:.1e} was reached")]
    UnreachableTolerance {
        /// Relative error requested.
        requested: f64,
        /// Relative error reached.
        reached: f64,
    },
}
