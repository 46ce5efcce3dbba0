//! Sets of states across the flow: each motion is followed to the plane through the centre that the flow crosses at right angles.
//!
//! Deviations along the flow only shift the time, but they grow as the speed does, and would spoil the others.

use crate::inertial::Inertial;
use crate::interval::{Interval, generously_up};
use crate::linear::{largest_row, multiply, unit};
use crate::manifold::{Manifold, Tube};
use crate::motion::Motion;
use crate::set::{COORDINATES, Set};
use crate::short_time::{ShortStick, ShortTime, along};
use crate::sticking::LastStep;
use crate::{Constants, Reason};

impl Motion<'_> {
    /// The same motions, each a little earlier or later: where it crosses the plane through the centre across the flow.
    pub(super) fn without_flow(&mut self, set: &Set<3>, section: Option<f64>) -> Option<Set<3>> {
        let system = Inertial(self.constants);
        let hull = set.hull();
        let normal = system.rates(&set.centre.map(Interval::point)).map(|rate| Interval::point(rate.mid));
        let distance = along(&normal, &set.offsets()).magnitude();
        let guess = system.rates(&hull);
        let over = |at: &[Interval; 3], _| Ok(system.over(at));
        let short = ShortTime::until_plane(&hull, normal, distance, &guess, over).ok()?;
        if section.is_some_and(|x| short.during[0].may_contain(x)) {
            return None;
        }
        let slope = multiply(&short.projection(), &short_flow(&short.around, short.time)?);
        let moved = set.mapped(set.centre.map(Interval::point), &slope, &[[Interval::ZERO; COORDINATES]; 3]);
        let Constants { inertia, stiffness, .. } = *self.constants;
        let (x, time) = (short.during[0], Interval::symmetric(short.time));
        let velocity = x.exp();
        let change = stiffness * inertia * velocity * (Interval::ONE - velocity) * time;
        self.observed.wait(x, [self.moment(&hull).stress, change], time * inertia * velocity);
        Some(moved)
    }

    /// The same for a sticking slider, after the step `last`.
    pub(super) fn slow_without_flow(
        &mut self,
        set: &Set<2>,
        last: &LastStep<'_>,
        section: Option<f64>,
    ) -> Option<(Set<2>, Tube)> {
        let hull = set.hull();
        let at_centre = Manifold::over(self.constants, &set.centre.map(Interval::point));
        let normal = [at_centre.rate, at_centre.state_rate].map(|rate| Interval::point(rate.mid));
        let distance = along(&normal, &set.offsets()).magnitude();
        let guess = [normal[0].widened(last.tube.distance), normal[1]];
        let over = |at: &[Interval; 2], time| last.over(self.constants, at, time);
        let short = ShortTime::until_plane(&hull, normal, distance, &guess, over).ok()?;
        // The tube is known since the start of the last step.
        if !(short.time < 0.5 * last.h) || section.is_some_and(|x| short.during[0].may_contain(x)) {
            return None;
        }
        let moved = shifted_slowly(set, &short).ok()?;
        let (x, time) = (short.during[0], Interval::symmetric(short.time));
        let (manifold, tube) = &short.around;
        let change = self.constants.stiffness * (Interval::ONE - x.exp()) * time;
        let stress = self.slow_moment(&hull, manifold, tube.distance).stress;
        self.observed.wait(x, [stress, change], time);
        Some(moved)
    }
}

/// The set and the tube of a sticking slider on the plane.
///
/// In a time τ the derivative by p changes by (e^{μτ} − 1) of its size, and by e^{μτ}τ|∂ψ/∂p|. The time of the shift depends on p, so that
/// the derivative of ψ gains ψ' times the derivative of this time.
pub(super) fn shifted_slowly(set: &Set<2>, short: &ShortStick) -> Result<(Set<2>, Tube), Reason> {
    let (manifold, tube) = &short.around;
    let (turning, tube_rate) = (short.turning(manifold.largest_slope)?, manifold.tube_rate(tube.distance));
    let turned = unit::<2>().map(|row| row.map(|c| c.widened(turning)));
    let gained = [tube.slopes.map(|slope| Interval::symmetric(generously_up(1.65 * short.time * slope))); 2];
    let removed = short.projection();
    let (slope, extra) = (multiply(&removed, &turned), multiply(&removed, &gained));
    let moved = set.mapped(set.centre.map(Interval::point), &slope, &extra);
    let carried = multiply(&turned, &set.derivative());
    let slopes = std::array::from_fn(|j| {
        let speed = along(&short.normal, &std::array::from_fn(|i| carried[i][j] + gained[i][j]));
        generously_up(tube.slopes[j] + tube_rate * speed.magnitude() / short.slowest)
    });
    Ok((moved, Tube { distance: tube.distance, slopes }))
}

/// Encloses the derivative of the flow over a time of at most `time`, forward or backward; none for a long time.
///
/// With the sizes |J| of the entries and M = |J| t it differs from I by at most M + M²/2 + M³/6 + …, entry by entry.
fn short_flow(jacobian: &[[Interval; 3]; 3], time: f64) -> Option<[[Interval; 3]; 3]> {
    let sizes = jacobian.map(|row| row.map(|entry| Interval::point(generously_up(time * entry.magnitude()))));
    let norm = largest_row(&sizes);
    if !(norm < 0.1) {
        return None;
    }
    let square = multiply(&sizes, &sizes);
    let cube = multiply(&square, &sizes);
    let rest = norm * norm * norm * norm;
    Some(std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let [first, second, third] = [&sizes, &square, &cube].map(|power| power[i][j].magnitude());
            let change = generously_up(first + 0.5 * second + third / 6.0 + rest);
            if i == j { Interval::ONE.widened(change) } else { Interval::symmetric(change) }
        })
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrices with equal positive entries a, for which e^{Jt} = I + (e^{3at} − 1)/3 in each entry, and others with one entry or with
    /// entries of any sign: what is enclosed holds e^{Jt} and e^{−Jt}; long times have no enclosure, or one that holds them.
    #[test]
    fn the_derivative_of_a_short_flow_is_enclosed() {
        let mut enclosed = 0;
        for turning in [1e-3, 0.03, 0.09, 0.3, 1.0, 3.0, 10.0, 20.0, 40.0] {
            let size = turning / 3.0;
            let all = [[size; 3]; 3];
            let one = [[0.0, turning, 0.0], [0.0; 3], [0.0; 3]];
            let turns = [[0.0, -turning, 0.0], [turning, 0.0, 0.0], [0.0, 0.0, -turning]];
            for (matrix, time) in [(all, 1.0), (all, 0.125), (one, 2.0), (turns, 1.0)] {
                for rad in [0.0, 0.5] {
                    // A box of matrices, of which this one is the largest.
                    let jacobian = matrix.map(|row| {
                        row.map(|c| Interval { mid: (1.0 - rad) * c / time, rad: rad * (c / time).abs() })
                    });
                    let Some(flow) = short_flow(&jacobian, time) else { continue };
                    enclosed += 1;
                    for sign in [1.0, -1.0] {
                        // The series of e^{Jt}.
                        let (mut sum, mut power) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
                        (0..3).for_each(|i| (sum[i][i], power[i][i]) = (1.0, 1.0));
                        for k in 1..200 {
                            let next = |i: usize, j: usize| {
                                (0..3).map(|m| power[i][m] * matrix[m][j]).sum::<f64>() * sign / f64::from(k)
                            };
                            power = std::array::from_fn(|i| std::array::from_fn(|j| next(i, j)));
                            (0..3).for_each(|i| (0..3).for_each(|j| sum[i][j] += power[i][j]));
                        }
                        for i in 0..3 {
                            for j in 0..3 {
                                let error = 1e-14 * sum[i][j].abs();
                                assert!(
                                    flow[i][j].widened(error).may_contain(sum[i][j]),
                                    "{turning} {i} {j} {} {:?}",
                                    sum[i][j],
                                    flow[i][j]
                                );
                            }
                        }
                    }
                }
            }
        }
        assert!(enclosed >= 20, "{enclosed}");
    }
}
