//! A decay: the enclosed run from the start, until it is inside an ellipsoid or a cone that steady sliding attracts.

use super::attraction::Ellipsoid;
use super::interval::{Interval, generously_up};
use super::linear::worse;
use super::manifold::Manifold;
use super::motion::{Motion, States};
use super::observed::Observed;
use super::set::{COORDINATES, Set};
use super::sticking::ENTRY_DELAY;
use super::{Certificate, Constants, MOST_STEPS, Proved, Reason, Units};
use crate::dynamics::Start;

/// What follows a run is no longer enclosed when it changes ln V and ζ by less.
const NEGLIGIBLE: f64 = 1e-9;

/// Steps that a decay takes in the time of inertia, times η.
const STEPS: f64 = 10.0;
/// Where these are too many and the delay by inertia at steady sliding is below `LATEST` times that of the entry of the slow manifold, the
/// manifold is entered at `LATE` times the delay at steady sliding.
const LATEST: f64 = 16.0;
const LATE: f64 = 4.0;

/// Certifies that the run from V = V_l/10 decays.
pub(super) fn certify(constants: &Constants, start: Start, units: &Units) -> Result<Certificate, Reason> {
    let ellipsoid = Ellipsoid::around_steady_sliding(constants).ok_or(Reason::NoAttraction)?;
    let state = start_state(constants, start);
    let set = Set::new([Interval::ZERO; COORDINATES], state, [[Interval::ZERO; COORDINATES]; 3]);
    let mut motion = Motion::new(constants, States::Inertial(set), MOST_STEPS).sticks_at_once();
    let at_rest = Manifold::over(constants, &[Interval::ZERO; 2]).delay() / ENTRY_DELAY;
    let steps_of_inertia = STEPS / constants.inertia.mid;
    if steps_of_inertia > MOST_STEPS as f64 && at_rest > 1.0 && at_rest < LATEST {
        motion.lateness = LATE * at_rest;
    }
    // The stress of the limit, steady sliding, counts too; its velocity is approached.
    motion.observed.state(Interval::ZERO, Interval::ZERO);
    loop {
        if let Some(bounds) = captured(&motion, &ellipsoid)
            && bounds.are_seen(&motion.observed)
        {
            motion.observed.rest(bounds.x, [bounds.highest, bounds.lowest]);
            break;
        }
        motion.advance(None)?;
    }
    let observed = &motion.observed;
    Ok(Certificate {
        proved: Proved::Decay { captured_after_s: units.duration(observed.duration)[1] },
        peak_velocity_m_per_s: units.peak(observed.peak()),
        stress_drop_pa: units.drop(observed.stress_drop()),
    })
}

/// Bounds of all that follows: of x, ζ and −ζ.
struct Bounds {
    x: f64,
    highest: f64,
    lowest: f64,
}

impl Bounds {
    /// Whether what follows cannot widen the enclosures by more than [`NEGLIGIBLE`].
    fn are_seen(&self, observed: &Observed) -> bool {
        let [peak, _] = observed.peak();
        let [highest, lowest] = observed.least_extremes();
        self.x <= worse(peak, NEGLIGIBLE)
            && self.highest <= worse(highest, NEGLIGIBLE)
            && self.lowest <= worse(lowest, NEGLIGIBLE)
    }
}

/// Bounds of x and ζ from here on, when every state lies inside the ellipsoid or a cone.
fn captured(motion: &Motion<'_>, ellipsoid: &Ellipsoid) -> Option<Bounds> {
    let Constants { inertia, effect_ratio, .. } = *motion.constants;
    let z = match &motion.states {
        States::Inertial(set) => {
            let [x, y, force] = set.hull();
            [x, y, force * inertia.reciprocal()]
        }
        States::Stuck(set, tube) => {
            let [x, y] = set.hull();
            let rate = Manifold::over(motion.constants, &[x, y]).rate.widened(tube.distance);
            [x, y, x.exp() * rate]
        }
    };
    // Nearly along the slowest mode x and ζ keep their signs.
    if let Some(cone) = ellipsoid.cone(motion.constants, &z) {
        let form = [Interval::ONE, effect_ratio, inertia];
        let along = [[Interval::ONE, Interval::ZERO, Interval::ZERO], form, form.map(|c| -c)];
        let [x, highest, lowest] = along.map(|form| cone.largest(&form));
        return Some(Bounds { x, highest, lowest });
    }
    let [x, y, w] = ellipsoid.reach_from(&z)?;
    let stress = generously_up(x + effect_ratio.magnitude() * y + inertia.magnitude() * w);
    Some(Bounds { x, highest: stress, lowest: stress })
}

/// x, y and F at V = V_l/10.
fn start_state(constants: &Constants, start: Start) -> [Interval; 3] {
    // The constant is ln 10 rounded to nearest, below 4: its error is at most 2^-52.
    let x = -Interval { mid: std::f64::consts::LN_10, rad: f64::EPSILON };
    let zero = Interval::ZERO;
    match start {
        Start::SteadyAtVelocity => [x, -x, zero],
        Start::SteadyStateSpringAtLoading => [x, -x, (constants.effect_ratio - Interval::ONE) * x],
        Start::VelocityStepInEquilibrium => [x, zero, zero],
        Start::VelocityKick => [x, zero, -x],
    }
}
