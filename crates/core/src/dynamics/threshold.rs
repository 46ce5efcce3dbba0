//! How far a start has to be from steady sliding to end on a cycle, where both attract.

use std::cell::Cell;

use super::integrator::{Control, Integrator};
use super::section_return::{ReturnEnd, next_return};
use super::{Failure, Member, Model, Radau, Start};
use crate::number::search::border_between;

/// Returns after which a trajectory moves along the slow direction alone: then the stress at the crossing decides on which side of the unstable
/// cycle it is.
const RETURNS: u32 = 8;

/// The farthest start that is tried: V = V_l e^{-6}.
const FARTHEST: f64 = 6.0;

/// Width of the border in ln(V_l/V).
const WIDTH: f64 = FARTHEST / (1u32 << 23) as f64;

/// Local tolerance of the returns.
const LOCAL_TOLERANCE: f64 = 1e-8;

/// Most steps of one trial.
const MOST_STEPS: u64 = 100_000;

/// ln(V_l/V) of the start, steady sliding at V, beyond which a run ends on the cycle outside `unstable`, to 1e-6.
///
/// Nothing when even the farthest start decays or the nearest does not.
///
/// # Errors
/// Those of the integrator.
pub fn start_threshold(model: &Model<f64>, unstable: &Member) -> Result<Option<f64>, Failure> {
    let grows = |below: f64| grows_from(model, unstable, below);
    if !grows(FARTHEST)? {
        return Ok(None);
    }
    let [decays, grows] = border(grows, (0.0, FARTHEST), WIDTH)?;
    Ok((decays > 0.0).then_some(0.5 * (decays + grows)))
}

/// Bisects between a start that decays, or none at all, and one that does not.
pub(super) fn border(
    leaves: impl Fn(f64) -> Result<bool, Failure>,
    ends: (f64, f64),
    width: f64,
) -> Result<[f64; 2], Failure> {
    let failed = Cell::new(None);
    let holds = |size| leaves(size).map_err(|failure| failed.set(Some(failure))).ok();
    match border_between(holds, ends, width) {
        Some((decays, leaves)) => Ok([decays, leaves]),
        None => Err(failed.take().unwrap_or(Failure::InvalidStart)),
    }
}

fn grows_from(model: &Model<f64>, unstable: &Member, below: f64) -> Result<bool, Failure> {
    let start = Start::SteadyAtVelocity.state(model, &-below);
    let control = Control { local_tolerance: LOCAL_TOLERANCE, most_steps: MOST_STEPS };
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
    for _ in 0..RETURNS {
        if next_return(&mut run)?.1 == ReturnEnd::AtRest {
            return Ok(false);
        }
    }
    Ok(run.state()[2] > unstable.orbit.end[2])
}
