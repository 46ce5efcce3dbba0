//! One run of the original scheme that starts on our limit cycle: its own long-term peak, and how sharply it is known.

use super::OriginalScheme;
use slipmode_core::dynamics::{Cycle, Failure, LongTerm, Model, Options, Outcome, simulate_model};

/// The most steps of one run of the scheme; a run that needs more is counted, not made.
pub const AFFORDABLE_STEPS: f64 = 1e6;

/// Error requested of the converged runs: far below any bias of the scheme.
const TOLERANCE: f64 = 1e-10;

/// Our cycles that pass before the scheme counts as late: a run that begins on a limit cycle forgets within fewer
/// unless a return contracts by less than a third.
const FORGOTTEN: f64 = 10.0;

/// Windows of [`WINDOW`] of our cycles whose highest velocities are compared.
const WINDOWS: usize = 4;

/// Cycles in a window: more than one, so that each holds a whole cycle of the scheme.
const WINDOW: f64 = 2.0;

/// The long-term peak of the scheme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SchemePeak {
    /// Mean over the windows of ln(V_peak/V_l).
    pub log_peak: f64,
    /// Half the difference of the highest and the lowest window: what the place of the steps on the cycle does.
    pub spread: f64,
}

/// Our limit cycle at a place; none where the run decays or fails.
#[must_use]
pub(crate) fn converged_cycle(model: &Model<f64>) -> Option<Cycle<f64>> {
    let options = Options::at(TOLERANCE);
    match simulate_model(model, &options).as_ref().map(Outcome::long_term) {
        Ok(LongTerm::Cycle(cycle)) => Some(cycle.clone()),
        _ => None,
    }
}

/// Steps of the whole run at a step of `fraction`·√(M/K).
#[must_use]
pub(crate) fn steps_needed(model: &Model<f64>, cycle: &Cycle<f64>, fraction: f64) -> f64 {
    let groups = model.groups();
    let natural = 1.0 / groups.natural_angular_frequency_squared().sqrt();
    (FORGOTTEN + WINDOW * WINDOWS as f64) * cycle.orbit.duration / (fraction * natural)
}

/// Runs the scheme from our limit cycle and takes the mean of its highest velocities in windows at the end of the run.
///
/// The velocities of the steps around a maximum are joined by a parabola in ln V, so that the peak does not depend on
/// where the steps happen to fall on it.
///
/// # Errors
/// Those of the scheme.
pub(crate) fn scheme_peak(
    model: &Model<f64>,
    cycle: &Cycle<f64>,
    fraction: f64,
) -> Result<SchemePeak, Failure> {
    let mut scheme = OriginalScheme::new(model, cycle.orbit.end, fraction);
    let period = cycle.orbit.duration;
    // The callers keep this count below the affordable one.
    let steps = |cycles: f64| libm::ceil(cycles * period / scheme.step()) as u64;
    let (forgotten, window) = (steps(FORGOTTEN), steps(WINDOW));
    highest(&mut scheme, forgotten)?;
    let mut peaks = [0.0; WINDOWS];
    for peak in &mut peaks {
        *peak = highest(&mut scheme, window)?;
    }
    let low = peaks.iter().copied().fold(f64::INFINITY, f64::min);
    let high = peaks.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Ok(SchemePeak { log_peak: peaks.iter().sum::<f64>() / WINDOWS as f64, spread: 0.5 * (high - low) })
}

/// The highest ln(V/V_l) of the next steps, between steps by the parabola through three.
pub(crate) fn highest(scheme: &mut OriginalScheme<'_>, steps: u64) -> Result<f64, Failure> {
    let mut last = [scheme.log_velocity(); 2];
    let mut highest = f64::NEG_INFINITY;
    for _ in 0..steps {
        scheme.advance()?;
        let next = scheme.log_velocity();
        let [before, middle] = last;
        highest = highest.max(next);
        if middle >= before && middle > next {
            let bend = before - 2.0 * middle + next;
            highest = highest.max(middle - (next - before) * (next - before) / (8.0 * bend));
        }
        last = [middle, next];
    }
    Ok(highest)
}
