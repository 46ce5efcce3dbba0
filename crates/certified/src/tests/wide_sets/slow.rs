//! The same of a slider near its slow manifold: steps, crossings, and both changes of the description.

use super::super::members::{Member, Slider};
use super::{ERROR, MIDDLE, Numbers, PAIRS, falling, holds, holds_slope, seen_at, step, until};
use crate::Constants;
use crate::interval::Interval;
use crate::manifold::{Manifold, Tube};
use crate::motion::CrossingSet;
use crate::motion::{Motion, States};
use crate::set::{COORDINATES, Derivative, Set};
use crate::sticking::LastStep;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::split_mix::SplitMix64;

/// A set of a slider near the slow manifold: (x, y) = c + Dp + e, and ψ of any value and slope in the tube.
struct Near {
    slider: Slider,
    constants: Constants,
    centre: [f64; 2],
    radius: [f64; 2],
    slopes: [[f64; COORDINATES]; 2],
    errors: [f64; 2],
    tube: Tube,
}

/// Signs of the errors, of ψ, and of its slopes.
const NEAR_SIGNS: [[f64; 5]; 7] = [
    [0.0, 0.0, 0.0, 1.0, 1.0],
    [0.0, 0.0, 1.0, 1.0, -1.0],
    [0.0, 0.0, -1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0, 1.0, 1.0],
    [-1.0, -1.0, -1.0, -1.0, -1.0],
];

impl Near {
    fn random(numbers: &mut Numbers, law: EvolutionLaw) -> Self {
        let slider = Slider {
            inertia: libm::pow(10.0, numbers.between(-2.0, -0.7)),
            stiffness: numbers.between(0.1, 1.0),
            effect_ratio: numbers.between(0.3, 2.0),
            law,
        };
        let size = libm::pow(10.0, numbers.between(-5.0, -1.5));
        let mut part = || size * numbers.decade(-1.5, 0.0);
        let (radius, errors) = ([part(), part()], [part(), part()]);
        let distance = numbers.decade(-5.0, -0.7);
        // ψ varies with p by at most what the tube allows.
        let room = |radius: f64, part: f64| if radius > 0.0 { part * distance / radius } else { part };
        let shares = [numbers.between(0.0, 0.5), numbers.between(0.0, 0.5)];
        let slopes = [0, 1].map(|j| f64::min(room(radius[j], shares[j]), 1.0) * numbers.0.unit().round());
        Self {
            slider,
            constants: slider.constants(),
            centre: [numbers.between(-1.6, -0.2), numbers.between(-0.3, 1.8)],
            radius,
            slopes: std::array::from_fn(|_| std::array::from_fn(|_| numbers.between(-1.0, 1.0))),
            errors,
            tube: Tube { distance, slopes },
        }
    }

    fn set(&self) -> Set<2> {
        let state = std::array::from_fn(|i| Interval { mid: self.centre[i], rad: self.errors[i] });
        Set::new(self.radius.map(Interval::symmetric), state, self.slopes.map(|row| row.map(Interval::point)))
    }

    fn p(&self, parts: [f64; 2]) -> [f64; 2] {
        [parts[0] * self.radius[0], parts[1] * self.radius[1]]
    }

    fn manifold(&self, x: f64, y: f64) -> Manifold {
        Manifold::over(&self.constants, &[x, y].map(Interval::point))
    }

    fn psi(&self, [x, y, force, _]: [f64; 4]) -> f64 {
        force / (self.slider.inertia * libm::exp(x)) - self.manifold(x, y).rate.mid
    }

    fn member(&self, p: [f64; 2], signs: [f64; 5]) -> Member {
        let [x, y] = std::array::from_fn(|i| {
            self.centre[i] + self.slopes[i][0] * p[0] + self.slopes[i][1] * p[1] + signs[i] * self.errors[i]
        });
        let varied: f64 = (0..2).map(|j| self.tube.slopes[j] * self.radius[j]).sum();
        let psi = signs[2] * (self.tube.distance - varied).max(0.0)
            + signs[3] * self.tube.slopes[0] * p[0]
            + signs[4] * self.tube.slopes[1] * p[1];
        let force = self.slider.inertia * libm::exp(x) * (self.manifold(x, y).rate.mid + psi);
        self.slider.member([x, y, force])
    }

    /// Whether single motions need many steps for this time.
    fn is_long(&self, duration: Interval) -> bool {
        duration.upper() > 20.0 * self.slider.inertia * libm::exp(self.centre[0])
    }

    /// The motion for a time of t.
    fn after(&self, mut member: Member, time: f64) -> Member {
        const STEP: f64 = 0.05;
        let clock = |member: &Member| self.slider.inertia * libm::exp(member.state[0]);
        while member.state[3] + 1.5 * STEP * clock(&member) < time {
            member = step(self.slider, member, STEP);
        }
        let mut end = member;
        if time > member.state[3] {
            for _ in 0..6 {
                end = self.slider.step(end, (time - end.state[3]) / clock(&end));
            }
        }
        seen_at(self.slider, member, end.state)
    }

    /// Calls `check` with pairs of ends, the coordinate in which their p differ, and by how much: `end` follows one member.
    fn pairs(
        &self,
        mut end: impl FnMut([f64; 2], [f64; 5]) -> [f64; 4],
        mut check: impl FnMut([[f64; 4]; 2], usize, f64),
    ) {
        for signs in NEAR_SIGNS {
            end(MIDDLE, signs);
            for pair in PAIRS {
                let ends = pair.map(|parts| end(self.p(parts), signs));
                let j = usize::from(pair[0][0] == pair[1][0]);
                let apart = (pair[1][j] - pair[0][j]) * self.radius[j];
                if apart != 0.0 {
                    check(ends, j, apart);
                }
            }
        }
    }

    /// A crossing of a section holds that of each member; so do the derivative, the tube and the time.
    fn assert_crossing(&self, case: usize, crossing: &CrossingSet, duration: Interval, section: f64) {
        let earliest = duration.lower();
        let end = |p: [f64; 2], signs: [f64; 5]| {
            let start = self.member(p, signs);
            assert!(start.state[0] < section, "{case} {start:?} starts above {section}");
            let member = self.after(start, earliest);
            let state = until(self.slider, member, &|state| state[0] - section, &|state| state[2]).state;
            assert!(holds(duration, state[3]), "{case} {duration:?} {}", state[3]);
            assert!(
                holds(with_p(crossing.centre[0], crossing.derivative[0], p), state[1]),
                "{case} {p:?} {state:?}"
            );
            assert!(
                self.psi(state).abs() <= crossing.centre[1].magnitude() + 1e-9,
                "{case} {:?}",
                crossing.centre
            );
            state
        };
        self.pairs(end, |ends, j, apart| {
            assert!(holds_slope(crossing.derivative[0][j], ends.map(|end| end[1]), apart), "{case} {j}");
            let slopes = crossing.derivative[1].map(Interval::magnitude);
            assert!(self.holds_tube_slope(slopes, ends, j, apart), "{case} {j} {ends:?} {slopes:?}");
        });
    }

    /// A bound of |∂ψ/∂p| holds the mean one.
    fn holds_tube_slope(&self, slopes: [f64; 2], ends: [[f64; 4]; 2], j: usize, apart: f64) -> bool {
        let [from, to] = ends.map(|end| self.psi(end));
        (to - from).abs() <= slopes[j] * apart.abs() + 1e-9
    }
}

fn with_p(centre: Interval, derivative: [Interval; COORDINATES], p: [f64; 2]) -> Interval {
    centre + derivative[0] * Interval::point(p[0]) + derivative[1] * Interval::point(p[1])
}

/// A step on the slow manifold: its end, after the shift across the flow if there is one, or its crossing of a section.
#[test]
fn a_step_of_the_widest_sets_on_the_slow_manifold_holds_the_members_or_is_refused() {
    let mut numbers = Numbers(SplitMix64(19));
    let (mut shifted, mut plain, mut crossed, mut missed, mut off) = (0, 0, 0, 0, 0);
    for case in 0..400 {
        let near = Near::random(&mut numbers, EvolutionLaw::ALL[case % 2]);
        let (set, tube) = (near.set(), near.tube);
        let hull = set.hull();
        let motion = |reach: f64| {
            let mut motion = Motion::new(&near.constants, States::Stuck(set.clone(), tube), 1);
            (motion.reach, motion.lateness) = (reach, 1e9);
            motion
        };
        let reach = libm::pow(10.0, numbers.between(-2.5, -0.7));
        let mut moved = motion(reach);
        if moved.slow_step(&set, tube, None).is_ok() {
            let States::Stuck(end_set, end_tube) = &moved.states else { continue };
            let (end_hull, derivative, at_centre) =
                (end_set.hull(), end_set.derivative(), end_set.at_centre());
            let duration = moved.observed.duration;
            if near.is_long(duration) {
                continue;
            }
            let is_shifted = duration.rad > 1e-12 * duration.mid;
            // Backward ψ would grow, and its error with it.
            let earliest = if is_shifted { duration.lower() } else { duration.mid };
            if is_shifted {
                shifted += 1
            } else {
                plain += 1
            }
            let [cx, cy] = end_set.centre;
            let there = near.manifold(cx, cy);
            let normal = [there.rate.mid, there.state_rate.mid];
            let mut reached = [f64::NEG_INFINITY; 3];
            let end = |p: [f64; 2], signs: [f64; 5]| {
                let mut end = near.after(near.member(p, signs), earliest);
                if is_shifted {
                    let distance =
                        |state: &[f64; 4]| normal[0] * (state[0] - cx) + normal[1] * (state[1] - cy);
                    let rate = |state: &[f64; 4]| {
                        let rates = near.slider.rates(*state);
                        normal[0] * rates[0] + normal[1] * rates[1]
                    };
                    end = until(near.slider, end, &distance, &rate);
                }
                let state = end.state;
                for i in 0..2 {
                    assert!(holds(end_hull[i], state[i]), "{case} {i} {state:?} {end_hull:?}");
                    assert!(holds(with_p(at_centre[i], derivative[i], p), state[i]), "{case} {i} {p:?}");
                }
                assert!(holds(duration, state[3]), "{case} {duration:?} {}", state[3]);
                assert!(
                    near.psi(state).abs() <= end_tube.distance + 1e-9,
                    "{case} {} {end_tube:?}",
                    near.psi(state)
                );
                reached = std::array::from_fn(|i| f64::max(reached[i], end.largest[i]));
                state
            };
            near.pairs(end, |ends, j, apart| {
                for i in 0..2 {
                    assert!(
                        holds_slope(derivative[i][j], ends.map(|end| end[i]), apart),
                        "{case} {i} {j} {derivative:?}"
                    );
                }
                assert!(
                    near.holds_tube_slope(end_tube.slopes, ends, j, apart),
                    "{case} {j} {ends:?} {end_tube:?}"
                );
            });
            let ([_, peak], [_, drop]) = (moved.observed.peak(), moved.observed.stress_drop());
            assert!(reached[0] <= peak + ERROR, "{case} {reached:?} {peak}");
            assert!(is_shifted || reached[1] + reached[2] <= drop + ERROR, "{case} {reached:?} {drop}");
        }
        // A section above the set, or one that a part of it is above.
        let away = libm::pow(10.0, numbers.between(-4.0, -1.0));
        let section = if case % 4 == 0 {
            near.centre[0] + numbers.between(0.0, 1.0) * hull[0].rad
        } else {
            hull[0].upper() + if case % 4 == 1 { 0.01 * away } else { away }
        };
        let mut moved = motion(if case % 4 == 1 { reach } else { 0.5 });
        moved.refuse_other_crossings(&falling(section), section).unwrap();
        let found = moved.slow_step(&set, tube, Some(section));
        if matches!(found, Ok(None)) && !near.is_long(moved.observed.duration) {
            missed += 1;
            for signs in NEAR_SIGNS {
                let start = near.member(MIDDLE, signs);
                let end = near.after(start, moved.observed.duration.lower());
                assert!(
                    start.state[0] >= section || end.state[0] < section,
                    "{case} {start:?} {end:?} {section}"
                );
            }
        }
        let Ok(Some(crossing)) = found else { continue };
        let duration = moved.observed.duration;
        if near.is_long(duration) {
            continue;
        }
        crossed += 1;
        near.assert_crossing(case, &crossing, duration, section);
        // The same step, seen from a section that the centre has passed or not yet reached.
        let States::Stuck(end, _) = moved.states.clone() else { continue };
        let (away, end_hull) = (numbers.between(-1.0, 1.0) * (end.hull()[0].rad + 0.1 * away), end.hull());
        let during = [0, 1].map(|i| {
            let whole = hull[i].hull(end_hull[i]);
            whole.widened(0.1 * whole.rad)
        });
        let last = LastStep { during, start: &set, tube, h: duration.mid };
        let section = section + away;
        let mut moved = motion(0.5);
        moved.observed.duration = Interval::point(duration.mid);
        let Ok(crossing) = moved.slow_crossing(&end, &last, section) else { continue };
        if hull[0].upper() < section {
            off += 1;
            near.assert_crossing(case, &crossing, moved.observed.duration, section);
        }
    }
    let counts = [shifted, plain, crossed, missed, off];
    assert!(counts.iter().all(|&count| count > 10), "{counts:?}");
}

/// Both changes of the description: off the slow manifold each member is in the set of the whole slider, and onto it in the tube.
#[test]
fn a_change_of_the_description_holds_the_members() {
    let mut numbers = Numbers(SplitMix64(23));
    let mut entered = 0;
    for case in 0..400 {
        let near = Near::random(&mut numbers, EvolutionLaw::ALL[case % 2]);
        let (set, tube) = (near.set(), near.tube);
        let constants = near.constants;
        // Off the slow manifold, since no delay is allowed.
        let mut motion = Motion::new(&constants, States::Stuck(set.clone(), tube), 1);
        motion.lateness = 0.0;
        assert!(motion.slow_step(&set, tube, None).unwrap().is_none());
        let States::Inertial(left) = &motion.states else { panic!("it sticks") };
        let (hull, derivative, at_centre) = (left.hull(), left.derivative(), left.at_centre());
        let is_held = |p: [f64; 2], state: [f64; 4]| {
            (0..3).all(|i| {
                let by_p = with_p(at_centre[i], derivative[i], p);
                let near_to = |c: Interval| c.widened(1e-14).may_contain(state[i]);
                near_to(hull[i]) && near_to(by_p)
            })
        };
        near.pairs(
            |p, signs| {
                let state = near.member(p, signs).state;
                assert!(is_held(p, state), "{case} {state:?} {hull:?}");
                state
            },
            |ends, j, apart| {
                for i in 0..3 {
                    let mean = (ends[1][i] - ends[0][i]) / apart;
                    let error = 1e-15 / apart.abs();
                    assert!(
                        derivative[i][j].widened(error).may_contain(mean),
                        "{case} {i} {j} {mean} {:?}",
                        derivative[i][j]
                    );
                }
            },
        );
        // Onto it: a set of the whole slider around the members, with slopes of F of its own.
        let [x, y, force, _] = near.member(MIDDLE, NEAR_SIGNS[1]).state;
        let (first, second) = (numbers.between(-1.0, 1.0) * force, numbers.between(-1.0, 1.0) * force);
        let errors = [near.errors[0], near.errors[1], force.abs() * numbers.decade(-4.0, -1.0)];
        // With a derivative that is only known to some digits.
        let slopes: Derivative<3> = [near.slopes[0], near.slopes[1], [first, second]]
            .map(|row| row.map(|mid| Interval { mid, rad: 1e-3 * mid.abs() }));
        let state = std::array::from_fn(|i| Interval { mid: [x, y, force][i], rad: errors[i] });
        let whole = Set::new(near.radius.map(Interval::symmetric), state, slopes);
        let mut motion = Motion::new(&constants, States::Inertial(whole.clone()), 1);
        (motion.has_fallen, motion.lateness) = (true, 1e9);
        let Some(States::Stuck(stuck, tube)) = motion.entered(&whole) else { continue };
        entered += 1;
        let (hull, derivative, at_centre) = (stuck.hull(), stuck.derivative(), stuck.at_centre());
        let ends = |c: Interval| [c.mid - 0.999 * c.rad, c.mid + 0.999 * c.rad];
        let holds_ends =
            |i: usize, j: usize| ends(slopes[i][j]).iter().all(|&end| derivative[i][j].may_contain(end));
        assert!((0..2).all(|i| (0..2).all(|j| holds_ends(i, j))), "{case} {derivative:?} {slopes:?}");
        near.pairs(
            |p, signs| {
                let state: [f64; 3] = std::array::from_fn(|i| {
                    let along = slopes[i][0].mid * p[0] + slopes[i][1].mid * p[1];
                    [x, y, force][i] + along + [signs[0], signs[1], signs[2]][i] * errors[i]
                });
                let state = [state[0], state[1], state[2], 0.0];
                for i in 0..2 {
                    assert!(hull[i].widened(1e-14).may_contain(state[i]), "{case} {i} {state:?} {hull:?}");
                    assert!(
                        with_p(at_centre[i], derivative[i], p).widened(1e-14).may_contain(state[i]),
                        "{case} {i}"
                    );
                }
                assert!(
                    near.psi(state).abs() <= tube.distance * (1.0 + 1e-9) + 1e-12,
                    "{case} {} {tube:?}",
                    near.psi(state)
                );
                state
            },
            |ends, j, apart| {
                for i in 0..2 {
                    let mean = (ends[1][i] - ends[0][i]) / apart;
                    assert!(
                        derivative[i][j].widened(1e-14 / apart.abs()).may_contain(mean),
                        "{case} {i} {j} {mean}"
                    );
                }
                assert!(near.holds_tube_slope(tube.slopes, ends, j, apart), "{case} {j} {tube:?}");
            },
        );
    }
    assert!(entered > 50, "{entered}");
}
