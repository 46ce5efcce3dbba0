//! Sets of states across the flow: each motion is followed to the plane through the centre that the flow crosses at right angles.
//!
//! Deviations along the flow only shift the time, but they grow as the speed does, and would spoil the others. With the normal n and a mean
//! f of the rates, (z − c) becomes (I − f nᵀ/(n·f))(z − c), and the derivative by p likewise after a time τ.

use super::Constants;
use super::inertial::Inertial;
use super::interval::{Interval, generously_up};
use super::linear::{apply, largest_row, multiply};
use super::manifold::{Manifold, Tube};
use super::motion::{Motion, column_sizes};
use super::observed::Wait;
use super::set::{COORDINATES, Set};
use super::sticking::LastStep;

/// The largest change of the derivatives of a sticking slider during a shift: e^t − 1 < 1.25 t below it.
const LARGEST_TURN: f64 = 0.2;

impl Motion<'_> {
    /// The same motions, each a little earlier or later: where it crosses the plane through the centre across the flow.
    ///
    /// Deviations along the flow only shift the time, but they grow as the speed does, and would spoil the others. With the normal n and a mean
    /// f of the rates, (z − c) becomes (I − f nᵀ/(n·f))(z − c), and the derivative by p likewise after a time τ.
    pub(super) fn without_flow(&mut self, set: &Set<3>, section: Option<f64>) -> Option<Set<3>> {
        let system = Inertial(self.constants);
        let (hull, offsets) = (set.hull(), set.offsets());
        let normal = system.rates(&set.centre.map(Interval::point)).map(|rate| Interval::point(rate.mid));
        let along = |v: &[Interval; 3]| (0..3).fold(Interval::ZERO, |sum, i| sum + normal[i] * v[i]);
        let rates = system.rates(&hull);
        let time = generously_up(2.0 * along(&offsets).magnitude() / along(&rates).mignitude());
        let during: [Interval; 3] = std::array::from_fn(|i| {
            hull[i].widened(generously_up(2.0 * time * rates[i].magnitude() + 1e-300))
        });
        let rates = system.rates(&during);
        let least = along(&rates).lower();
        let holds = (0..3)
            .all(|i| hull[i].widened(generously_up(time * rates[i].magnitude())).is_inside(during[i]))
            && least > 0.0
            && generously_up(along(&offsets).magnitude() / least) < time;
        if !holds || section.is_some_and(|x| during[0].may_contain(x)) {
            return None;
        }
        let turned = short_flow(&system.jacobian(&during), time)?;
        let inverse = along(&rates).reciprocal();
        let one = |i: usize, j: usize| if i == j { Interval::ONE } else { Interval::ZERO };
        let removed: [[Interval; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| one(i, j) - rates[i] * normal[j] * inverse));
        let image = set.centre.map(Interval::point);
        let moved = set.mapped(image, &multiply(&removed, &turned), &[[Interval::ZERO; COORDINATES]; 3]);
        let Constants { inertia, stiffness, .. } = *self.constants;
        let velocity = during[0].exp();
        self.observed.wait(Wait {
            x: during[0],
            stress: self.moment(&hull).stress,
            stress_change: stiffness
                * inertia
                * velocity
                * (Interval::ONE - velocity)
                * Interval::symmetric(time),
            duration: Interval::symmetric(time) * inertia * velocity,
        });
        Some(moved)
    }

    /// The same for a sticking slider, after the step `last`.
    ///
    /// The slow equations alone would move z to c + (I − f nᵀ/(n·f))Φ(z − c), with Φ near I. In a time τ, ψ moves it by at most e = e^{μτ}τ|ψ|
    /// from there, and back to the plane: by (I − f nᵀ/(n·f))e in all. The time of the shift depends on p, so that the derivative of ψ gains ψ' times
    /// the derivative of this time.
    pub(super) fn slow_without_flow(
        &mut self,
        set: &Set<2>,
        last: &LastStep,
        section: Option<f64>,
    ) -> Option<(Set<2>, Tube)> {
        let (hull, offsets) = (set.hull(), set.offsets());
        let at_centre = Manifold::over(self.constants, &set.centre.map(Interval::point));
        let normal = [at_centre.rate, at_centre.state_rate].map(|rate| Interval::point(rate.mid));
        let along = |v: &[Interval; 2]| normal[0] * v[0] + normal[1] * v[1];
        let time = generously_up(2.0 * along(&offsets).magnitude() / along(&normal).lower());
        if !(time > 0.0 && time < 0.5 * last.h) {
            return None;
        }
        let reach =
            |rate: Interval| generously_up(2.0 * time * (rate.magnitude() + last.tube.distance) + 1e-300);
        let during = [hull[0].widened(reach(normal[0])), hull[1].widened(reach(normal[1]))];
        if section.is_some_and(|x| during[0].may_contain(x)) {
            return None;
        }
        let tube = last.prolonged(self.constants, &during, time)?.after(last.h - time);
        let manifold = Manifold::over(self.constants, &during);
        let rates = [manifold.rate.widened(tube.distance), manifold.state_rate];
        let least = along(&rates).lower();
        let holds = (0..2)
            .all(|i| hull[i].widened(generously_up(time * rates[i].magnitude())).is_inside(during[i]))
            && least > 0.0
            && generously_up(along(&offsets).magnitude() / least) < time
            && manifold.largest_slope * time < LARGEST_TURN;
        if !holds {
            return None;
        }
        let (inverse, turning) =
            (along(&rates).reciprocal(), generously_up(1.25 * manifold.largest_slope * time));
        let one = |i: usize, j: usize| if i == j { Interval::ONE } else { Interval::ZERO };
        let removed: [[Interval; 2]; 2] =
            std::array::from_fn(|i| std::array::from_fn(|j| one(i, j) - rates[i] * normal[j] * inverse));
        let turned = std::array::from_fn(|i| std::array::from_fn(|j| one(i, j).widened(turning)));
        let impulse = |size: f64| Interval::symmetric(generously_up(1.25 * time * size));
        let gained = [tube.slopes.map(impulse); 2];
        let moved_by_tube = apply(&removed, &[impulse(tube.distance); 2]);
        let image = std::array::from_fn(|i| Interval::point(set.centre[i]) + moved_by_tube[i]);
        let moved = set.mapped(image, &multiply(&removed, &turned), &multiply(&removed, &gained));
        let derivative = set.derivative();
        let (sizes, across) = (column_sizes(&derivative), multiply(&[normal], &derivative)[0]);
        let sum = normal[0].magnitude() + normal[1].magnitude();
        let slopes = std::array::from_fn(|j| {
            let rest = sum * (2.0 * turning * sizes[j] + gained[0][j].magnitude());
            let time_by_p = (across[j].magnitude() + rest) / least;
            generously_up(tube.slopes[j] + manifold.tube_rate(tube.distance) * time_by_p)
        });
        self.observed.wait(Wait {
            x: during[0],
            stress: self.slow_moment(&hull, &manifold, tube.distance).stress,
            stress_change: self.constants.stiffness
                * (Interval::ONE - during[0].exp())
                * Interval::symmetric(time),
            duration: Interval::symmetric(time),
        });
        Some((moved, Tube { distance: tube.distance, slopes }))
    }
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
