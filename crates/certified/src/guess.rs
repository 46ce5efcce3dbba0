//! Where a cycle is to be certified: a section and a point near the cycle, from an ordinary run. Nothing here is proved.

use crate::interval::Interval;
use crate::manifold::Manifold;
use crate::sticking::{ENTRY_DELAY, EXIT_DELAY};
use crate::{Constants, Reason};
use slipmode_core::dynamics::{Control, Cycle, Integrator, Model, Radau};

/// A section and a point of it near the cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guess {
    pub section: f64,
    /// y, and F.
    pub point: [f64; 2],
    pub is_on_slow_manifold: bool,
}

/// Samples in a step.
const SAMPLES: usize = 32;

/// Periods that are followed: in the first the slider enters a stick phase, in the second it has left it.
const PERIODS: f64 = 2.2;

/// The guess: where the slider leaves the slow manifold if it sticks enough, otherwise V = V_l.
pub(super) fn guess(constants: &Constants, model: &Model<f64>, cycle: &Cycle<f64>) -> Result<Guess, Reason> {
    let beta = model.groups().effect_ratio;
    let at_level = Guess {
        section: 0.0,
        point: [cycle.from[1], cycle.from[2] - beta * cycle.from[1]],
        is_on_slow_manifold: false,
    };
    let failed = |failure: slipmode_core::dynamics::Failure| Reason::Simulation(failure.to_string());
    let control = Control { local_tolerance: 1e-11, most_steps: 1_000_000 };
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), cycle.from, control).map_err(failed)?;
    let (mut time, mut has_fallen, mut sticks) = (0.0, false, false);
    while time < PERIODS * cycle.orbit.duration {
        run.arrest();
        run.advance(None).map_err(failed)?;
        time += run.step();
        for part in 1..=SAMPLES {
            let [x, y, zeta] = run.state_within(&(part as f64 / SAMPLES as f64));
            let at = [x, y].map(Interval::point);
            let (least, delay) =
                (Manifold::least_delay(constants, &at), || Manifold::over(constants, &at).delay());
            let rate = zeta - x - beta * y;
            has_fallen |= rate < 0.0;
            // Most samples need no more than the least delay.
            sticks = sticks || has_fallen && least < 0.5 * ENTRY_DELAY && delay() < 0.5 * ENTRY_DELAY;
            if sticks && x > -300.0 && (least > EXIT_DELAY || delay() > EXIT_DELAY) {
                return Ok(Guess { section: x, point: [y, rate], is_on_slow_manifold: true });
            }
        }
    }
    Ok(at_level)
}
