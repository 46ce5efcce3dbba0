//! Where a motion crosses the section, with its derivative by the point that it started from.

use crate::Reason;
use crate::inertial::Inertial;
use crate::interval::{Interval, generously_up};
use crate::linear::largest_row;
use crate::manifold::Manifold;
use crate::motion::{CrossingSet, Motion};
use crate::set::{COORDINATES, Derivative, Set, column_sizes};
use crate::short_time::{ShortMotion, ShortStick, ShortTime};
use crate::sticking::LastStep;

impl Motion<'_> {
    /// The section x = `section`, reached to rounding by the centre.
    pub(super) fn inertial_crossing(&mut self, set: &Set<3>, section: f64) -> Result<CrossingSet, Reason> {
        let (system, hull) = (Inertial(self.constants), set.hull());
        let missing = (Interval::point(section) - hull[0]).magnitude();
        let guess = system.rates(&hull.map(|c| c.widened(missing)));
        let upward = [Interval::ONE, Interval::ZERO, Interval::ZERO];
        let over = |at: &[Interval; 3], _| Ok(system.over(at));
        let short = ShortTime::until_plane(&hull, upward, missing, &guess, over)?;
        let velocity = short.during[0].exp();
        let change = generously_up(short.time * (self.constants.inertia * velocity).magnitude());
        self.observed.duration = self.observed.duration.widened(change);
        crossed(set, section, &short)
    }

    /// The same on the slow manifold, shortly before or after the end of the last step.
    pub(super) fn slow_crossing(
        &mut self,
        set: &Set<2>,
        last: &LastStep<'_>,
        section: f64,
    ) -> Result<CrossingSet, Reason> {
        let hull = set.hull();
        let missing = (Interval::point(section) - hull[0]).magnitude();
        let here = Manifold::over(self.constants, &hull);
        // So wide that rounding leaves something of it where y hardly changes.
        let guess = [here.rate, here.state_rate.widened(here.rate.magnitude())];
        let over = |at: &[Interval; 2], time| last.over(self.constants, at, time);
        let short = ShortTime::until_plane(&hull, [Interval::ONE, Interval::ZERO], missing, &guess, over)?;
        self.observed.duration = self.observed.duration.widened(short.time);
        crossed_slowly(set, section, &short)
    }
}

/// The crossing of the whole slider.
pub(super) fn crossed(set: &Set<3>, section: f64, short: &ShortMotion) -> Result<CrossingSet, Reason> {
    let turning = short.turning(largest_row(&short.around))?;
    let changes = column_sizes(&set.derivative()).map(|size| turning * size);
    let (centre, derivative) = on_section(set, section, short, changes);
    Ok(CrossingSet { centre, derivative })
}

/// The crossing of a sticking slider. In a time τ the derivative by p gains at most e^{μτ}τ|∂ψ/∂p|. The time depends on p, so that the
/// derivative of ψ gains ψ' times the derivative of this time.
pub(super) fn crossed_slowly(set: &Set<2>, section: f64, short: &ShortStick) -> Result<CrossingSet, Reason> {
    let (manifold, tube) = &short.around;
    let turning = short.turning(manifold.largest_slope)?;
    let sizes = column_sizes(&set.derivative());
    let changes = std::array::from_fn(|j| turning * sizes[j] + 1.65 * short.time * tube.slopes[j]);
    let ([y], [by_p]) = on_section(set, section, short, changes);
    let slopes = std::array::from_fn(|j| {
        let time_by_p = (sizes[j] + changes[j]) / short.slowest;
        Interval::symmetric(generously_up(tube.slopes[j] + manifold.tube_rate(tube.distance) * time_by_p))
    });
    Ok(CrossingSet { centre: [y, Interval::symmetric(tube.distance)], derivative: [by_p, slopes] })
}

/// The coordinates behind x on the section, for p = 0, and their derivative by p; `changes` bounds how much a short time changes the derivative
/// of the state.
fn on_section<const N: usize, const K: usize, T>(
    set: &Set<N>,
    section: f64,
    short: &ShortTime<N, T>,
    changes: [f64; COORDINATES],
) -> ([Interval; K], Derivative<K>) {
    let removed = short.projection();
    let forms: [[Interval; N]; K] = std::array::from_fn(|i| removed[i + 1]);
    let (errors, derivative) = set.seen_by(&forms);
    let rest = Interval::point(section) - Interval::point(set.centre[0]);
    let change = |i: usize, j: usize| generously_up(changes[j] * (1.0 + forms[i][0].magnitude()));
    (
        std::array::from_fn(|i| Interval::point(set.centre[i + 1]) - forms[i][0] * rest + errors[i]),
        std::array::from_fn(|i| std::array::from_fn(|j| derivative[i][j].widened(change(i, j)))),
    )
}
