//! Where a motion crosses the section, with its derivative by the point that it started from.

use super::Reason;
use super::inertial::Inertial;
use super::interval::{Interval, generously_up};
use super::linear::largest_row;
use super::manifold::Manifold;
use super::motion::{Motion, column_sizes};
use super::set::{COORDINATES, Derivative, Set};
use super::sticking::LastStep;

/// Where the motion crossed the section, seen from p.
#[derive(Debug, Clone)]
pub(super) struct Crossing {
    /// (y, F) or (y, ψ) for p = 0.
    pub centre: [Interval; COORDINATES],
    /// Its derivative by p over the box.
    pub derivative: [[Interval; COORDINATES]; COORDINATES],
}

impl Motion<'_> {
    /// The section x = `section`, reached to rounding by the centre.
    pub(super) fn inertial_crossing(&mut self, set: &Set<3>, section: f64) -> Result<Crossing, Reason> {
        let system = Inertial(self.constants);
        let hull = set.hull();
        let missing = (Interval::point(section) - hull[0]).magnitude();
        let slowest = 0.5 * hull[2].lower();
        if !(slowest > 0.0) {
            return Err(Reason::Tangent);
        }
        let time = generously_up(missing / slowest);
        let around = hull.map(|c| c.widened(generously_up(1e-30 + missing)));
        let widen =
            |c: Interval, rate: Interval| c.widened(generously_up(2.0 * time * rate.magnitude() + 1e-300));
        let rates = system.rates(&around);
        let during: [Interval; 3] = std::array::from_fn(|i| widen(hull[i], rates[i]));
        let rates = system.rates(&during);
        let holds =
            (0..3).all(|i| hull[i].widened(generously_up(time * rates[i].magnitude())).is_inside(during[i]));
        if !(holds && rates[0].lower() > slowest) {
            return Err(Reason::Tangent);
        }
        let turning = generously_up(time * largest_row(&system.jacobian(&during)));
        let changes = carried(&set.derivative(), turning)?;
        let inverse = rates[0].reciprocal();
        let along = [rates[1] * inverse, rates[2] * inverse];
        self.correct_duration(time, &during[0]);
        let (zero, one) = (Interval::ZERO, Interval::ONE);
        let (errors, derivative) = set.seen_by(&[[-along[0], one, zero], [-along[1], zero, one]]);
        let rest = Interval::point(section) - Interval::point(set.centre[0]);
        let turned = |i: usize, j: usize| generously_up(changes[j] * (1.0 + along[i].magnitude()));
        Ok(Crossing {
            centre: std::array::from_fn(|i| Interval::point(set.centre[i + 1]) + along[i] * rest + errors[i]),
            derivative: std::array::from_fn(|i| {
                std::array::from_fn(|j| derivative[i][j].widened(turned(i, j)))
            }),
        })
    }

    /// The crossing is a time `time` of s before or after the end of the last step.
    fn correct_duration(&mut self, time: f64, x: &Interval) {
        let change = generously_up(time * (self.constants.inertia * x.exp()).magnitude());
        self.observed.duration = self.observed.duration.widened(change);
    }

    /// The same on the slow manifold: the last step, of length h from a tube, is seen as one that may last a little longer.
    pub(super) fn slow_crossing(
        &mut self,
        set: &Set<2>,
        last: &LastStep,
        section: f64,
    ) -> Result<Crossing, Reason> {
        let hull = set.hull();
        let missing = (Interval::point(section) - hull[0]).magnitude();
        let here = Manifold::over(self.constants, &hull);
        let slowest = 0.5 * here.rate.lower();
        if !(slowest > 0.0) {
            return Err(Reason::Tangent);
        }
        let time = generously_up(missing / slowest);
        let reach =
            [here.rate, here.state_rate].map(|rate| generously_up(2.0 * time * rate.magnitude() + 1e-300));
        let during: [Interval; 2] = std::array::from_fn(|i| hull[i].widened(reach[i]));
        let passage = last.prolonged(self.constants, &during, time).ok_or(Reason::LeftTheTube)?;
        let largest = passage.after((last.h - time).max(0.0));
        let near = Manifold::over(self.constants, &during);
        let speed = near.rate.widened(largest.distance);
        let holds = generously_up(time * speed.magnitude()) < reach[0]
            && generously_up(time * near.state_rate.magnitude()) < reach[1];
        if !(holds && speed.lower() > slowest) {
            return Err(Reason::Tangent);
        }
        let turning = generously_up(time * near.largest_slope);
        let changes = carried(&set.derivative(), turning)?;
        let along = near.state_rate * speed.reciprocal();
        let (errors, derivative) = set.seen_by(&[[-along, Interval::ONE]]);
        let rest = Interval::point(section) - Interval::point(set.centre[0]);
        let tube_along = near.tube_rate(largest.distance) / slowest;
        self.observed.duration = self.observed.duration.widened(time);
        let turned = |j: usize| {
            generously_up((changes[j] + 2.0 * time * largest.slopes[j]) * (1.0 + along.magnitude()))
        };
        let sizes = column_sizes(&set.derivative());
        let of_tube = |j: usize| {
            generously_up(
                largest.slopes[j] + tube_along * (sizes[j] + changes[j] + 2.0 * time * largest.slopes[j]),
            )
        };
        Ok(Crossing {
            centre: [
                Interval::point(set.centre[1]) + along * rest + errors[0],
                Interval::symmetric(largest.distance),
            ],
            derivative: [
                std::array::from_fn(|j| derivative[0][j].widened(turned(j))),
                std::array::from_fn(|j| Interval::symmetric(of_tube(j))),
            ],
        })
    }
}

/// By how much derivatives change in a short time: with ‖J‖ t = `turning` by at most (e^{‖J‖ t} − 1) of their size.
fn carried<const N: usize>(derivative: &Derivative<N>, turning: f64) -> Result<[f64; COORDINATES], Reason> {
    if !(turning < 0.5) {
        return Err(Reason::Tangent);
    }
    Ok(column_sizes(derivative).map(|size| generously_up(2.0 * turning * size)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J = a[[0, 1], [1, 0]] carries (1, 1) to e^{at}(1, 1) and (1, −1) to e^{−at}(1, −1): the change is at most the bound, or there is none.
    #[test]
    fn what_a_short_time_changes_of_a_derivative_is_bounded() {
        let mut bounded = 0;
        for turning in [1e-6, 0.01, 0.2, 0.45, 0.499, 0.6, 2.0, 5.0] {
            for size in [1.0, 1e-3, 7.0] {
                let derivative =
                    [[size, 0.5 * size], [size, -0.5 * size]].map(|row| row.map(Interval::point));
                let Ok(changes) = carried(&derivative, turning) else { continue };
                bounded += 1;
                let grown = [size * libm::expm1(turning), 0.5 * size * libm::expm1(turning)];
                assert!((0..2).all(|j| changes[j] >= grown[j] * (1.0 - 1e-12)), "{turning} {changes:?}");
                assert!(changes[0] >= -size * libm::expm1(-turning));
            }
        }
        assert!(bounded >= 12 && carried(&[[Interval::ONE; 2]; 2], f64::NAN).is_err(), "{bounded}");
    }
}
