//! Sets so wide that each term of a bound matters, against single motions of the whole slider: each shift, crossing and change of the
//! description is refused, or it holds the motions with their derivatives, times and extremes.

use super::Constants;
use super::crossing::Crossing;
use super::interval::Interval;
use super::manifold::{Manifold, Tube};
use super::members::{Member, Slider};
use super::motion::{Motion, States};
use super::set::{COORDINATES, Derivative, Set};
use crate::friction::EvolutionLaw;
use crate::number::split_mix::SplitMix64;

/// Of the single motions.
const ERROR: f64 = 1e-10;

/// Points of the box of p in parts of its radii: its middle, and pairs of which each differs in one coordinate.
const MIDDLE: [f64; 2] = [0.0; 2];
const PAIRS: [[[f64; 2]; 2]; 4] = [
    [[1.0, 0.0], [-1.0, 0.0]],
    [[0.0, 1.0], [0.0, -1.0]],
    [[1.0, 1.0], [-1.0, 1.0]],
    [[1.0, -1.0], [1.0, 1.0]],
];

struct Numbers(SplitMix64);

impl Numbers {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.0.unit()
    }

    /// A power of ten, or zero in one of four cases.
    fn decade(&mut self, from: f64, to: f64) -> f64 {
        if self.0.unit() < 0.25 { 0.0 } else { libm::pow(10.0, self.between(from, to)) }
    }
}

/// A step with the largest values at its ends alone: what lies between is uncertain.
fn step(slider: Slider, member: Member, ds: f64) -> Member {
    let [x, y, force, time] = slider.step(member, ds).state;
    let ends = slider.member([x, y, force]).largest;
    Member {
        state: [x, y, force, time],
        largest: std::array::from_fn(|i| f64::max(member.largest[i], ends[i])),
    }
}

fn holds(interval: Interval, value: f64) -> bool {
    interval.widened(ERROR * (1.0 + value.abs())).may_contain(value)
}

/// Whether an enclosure of a derivative holds the mean one between two states; `apart` is the distance of their p, not zero.
fn holds_slope(derivative: Interval, [from, to]: [f64; 2], apart: f64) -> bool {
    let mean = Interval { mid: to - from, rad: 2.0 * ERROR } * Interval::point(apart).reciprocal();
    (derivative - mean).may_contain(0.0)
}

/// The same motion at a later state: the steps of Newton's method to it, which may pass it, do not count.
fn seen_at(slider: Slider, before: Member, state: [f64; 4]) -> Member {
    let ends = slider.member([state[0], state[1], state[2]]).largest;
    Member { state, largest: std::array::from_fn(|i| f64::max(before.largest[i], ends[i])) }
}

/// The motion to where `distance` is zero, forward or backward, by short steps and then by Newton's method; `rate` is that of the distance
/// in s.
fn until(
    slider: Slider,
    mut member: Member,
    distance: &dyn Fn(&[f64; 4]) -> f64,
    rate: &dyn Fn(&[f64; 4]) -> f64,
) -> Member {
    const SHORT: f64 = 0.05;
    let missing = |member: &Member| -distance(&member.state) / rate(&member.state);
    for _ in 0..2_000 {
        let by = missing(&member);
        assert!(by.is_finite(), "{member:?} does not get there");
        if by.abs() < SHORT {
            break;
        }
        member = step(slider, member, by.clamp(-SHORT, SHORT));
    }
    let mut end = member;
    for _ in 0..6 {
        end = slider.step(end, missing(&end));
    }
    assert!(distance(&end.state).abs() < 1e-11, "{member:?} does not get there");
    seen_at(slider, member, end.state)
}

/// A set of the whole slider: c + Dp + e.
struct Whole {
    slider: Slider,
    centre: [f64; 3],
    radius: [f64; 2],
    slopes: [[f64; COORDINATES]; 3],
    errors: [f64; 3],
}

impl Whole {
    fn random(numbers: &mut Numbers, law: EvolutionLaw) -> Self {
        let slider = Slider {
            inertia: numbers.between(0.05, 2.0),
            stiffness: numbers.between(0.1, 2.0),
            effect_ratio: numbers.between(0.3, 3.0),
            law,
        };
        let centre = [numbers.between(-1.0, 0.6), numbers.between(-0.6, 1.0), numbers.between(0.05, 0.8)];
        let size = libm::pow(10.0, numbers.between(-5.0, -0.3));
        let mut part = || size * numbers.decade(-1.5, 0.0);
        let (radius, errors) = ([part(), part()], [part(), part(), part()]);
        let slopes = std::array::from_fn(|_| std::array::from_fn(|_| numbers.between(-1.0, 1.0)));
        Self { slider, centre, radius, slopes, errors }
    }

    fn set(&self) -> Set<3> {
        let state = std::array::from_fn(|i| Interval { mid: self.centre[i], rad: self.errors[i] });
        Set::new(self.radius.map(Interval::symmetric), state, self.slopes.map(|row| row.map(Interval::point)))
    }

    fn p(&self, parts: [f64; 2]) -> [f64; 2] {
        [parts[0] * self.radius[0], parts[1] * self.radius[1]]
    }

    fn member(&self, p: [f64; 2], signs: [f64; 3]) -> Member {
        let state = std::array::from_fn(|i| {
            self.centre[i] + self.slopes[i][0] * p[0] + self.slopes[i][1] * p[1] + signs[i] * self.errors[i]
        });
        self.slider.member(state)
    }

    /// The middle and all corners of the errors.
    fn signs() -> impl Iterator<Item = [f64; 3]> {
        let corner = |k: usize| std::array::from_fn(|i| if k >> i & 1 == 0 { 1.0 } else { -1.0 });
        std::iter::once([0.0; 3]).chain((0..8).map(corner))
    }

    /// A crossing holds that of each member; so do the derivative and the time.
    fn assert_crossing(&self, crossing: &Crossing, duration: Interval, section: f64) {
        for signs in Self::signs() {
            let end = |parts: [f64; 2]| {
                let p = self.p(parts);
                let distance = |state: &[f64; 4]| state[0] - section;
                let end = until(self.slider, self.member(p, signs), &distance, &|state| state[2]).state;
                for i in 0..2 {
                    let value = crossing.centre[i]
                        + crossing.derivative[i][0] * Interval::point(p[0])
                        + crossing.derivative[i][1] * Interval::point(p[1]);
                    assert!(holds(value, end[i + 1]), "{i} {end:?} {value:?}");
                }
                assert!(holds(duration, end[3]), "{} {duration:?}", end[3]);
                end
            };
            end(MIDDLE);
            for pair in PAIRS {
                let [from, to] = pair.map(end);
                let j = usize::from(pair[0][0] == pair[1][0]);
                let apart = (pair[1][j] - pair[0][j]) * self.radius[j];
                if apart != 0.0 {
                    for i in 0..2 {
                        let slope = crossing.derivative[i][j];
                        assert!(holds_slope(slope, [from[i + 1], to[i + 1]], apart), "{i} {j} {slope:?}");
                    }
                }
            }
        }
    }

    /// A shift across the flow holds each member where it crosses the plane; so do the derivative, the time, and the extremes on the way.
    fn assert_shift(&self, shifted: &Set<3>, motion: &Motion<'_>, x: Interval) {
        let [cx, cy, cf] = self.centre;
        let normal = self.slider.rates([cx, cy, cf, 0.0]);
        let along = |v: [f64; 3]| (0..3).map(|i| normal[i] * v[i]).sum::<f64>();
        let distance = |state: &[f64; 4]| along(std::array::from_fn(|i| state[i] - self.centre[i]));
        let rate = |state: &[f64; 4]| {
            let rates = self.slider.rates(*state);
            along([rates[0], rates[1], rates[2]])
        };
        let (hull, derivative, at_centre) = (shifted.hull(), shifted.derivative(), shifted.at_centre());
        let (duration, [_, peak]) = (motion.observed.duration, motion.observed.peak());
        let mut reached = [f64::NEG_INFINITY; 3];
        for signs in Self::signs() {
            let mut end = |parts: [f64; 2]| {
                let p = self.p(parts);
                let end = until(self.slider, self.member(p, signs), &distance, &rate);
                for i in 0..3 {
                    let value = at_centre[i]
                        + derivative[i][0] * Interval::point(p[0])
                        + derivative[i][1] * Interval::point(p[1]);
                    assert!(
                        holds(hull[i], end.state[i]) && holds(value, end.state[i]),
                        "{i} {end:?} {hull:?}"
                    );
                }
                assert!(holds(duration, end.state[3]), "{} {duration:?}", end.state[3]);
                assert!(end.largest[0] <= peak + ERROR, "{end:?} {peak}");
                reached = std::array::from_fn(|i| f64::max(reached[i], end.largest[i]));
                end.state
            };
            end(MIDDLE);
            for pair in PAIRS {
                let [from, to] = pair.map(&mut end);
                let j = usize::from(pair[0][0] == pair[1][0]);
                let apart = (pair[1][j] - pair[0][j]) * self.radius[j];
                if apart != 0.0 {
                    for i in 0..3 {
                        assert!(
                            holds_slope(derivative[i][j], [from[i], to[i]], apart),
                            "{i} {j} {:?}",
                            derivative[i][j]
                        );
                    }
                }
            }
        }
        if x.may_contain(0.0) {
            let [_, drop] = motion.observed.stress_drop();
            assert!(reached[1] + reached[2] <= drop + 1e-14, "{reached:?} {drop}");
        }
    }
}

/// Wide sets of the whole slider, at sections from far away to inside of the set.
#[test]
fn a_shift_or_a_crossing_of_the_widest_sets_holds_the_members_or_is_refused() {
    let mut numbers = Numbers(SplitMix64(17));
    let (mut shifts, mut crossings) = (0, 0);
    for case in 0..1500 {
        let whole = Whole::random(&mut numbers, EvolutionLaw::ALL[case % 2]);
        let constants = whole.slider.constants();
        let set = whole.set();
        let hull = set.hull();
        let motion = || Motion::new(&constants, States::Inertial(set.clone()), 1);
        let mut moved = motion();
        if let Some(shifted) = moved.without_flow(&set, None) {
            shifts += 1;
            whole.assert_shift(&shifted, &moved, hull[0]);
        }
        let section =
            whole.centre[0] + [0.0, 1.0, -1.0][case % 3] * numbers.between(0.0, 2.0) * (hull[0].rad + 1e-3);
        // A set that reaches to the section must not be shifted.
        let is_near = hull[0].may_contain(section);
        assert!(!is_near || motion().without_flow(&set, Some(section)).is_none(), "{section} {hull:?}");
        let mut moved = motion();
        if let Ok(crossing) = moved.inertial_crossing(&set, section) {
            crossings += 1;
            whole.assert_crossing(&crossing, moved.observed.duration, section);
        }
    }
    assert!(shifts > 200 && crossings > 200, "{shifts} {crossings}");
}

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
    let (mut shifted, mut plain, mut crossed) = (0, 0, 0);
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
        // A section that the centre reaches within the step.
        let section = hull[0].upper() + libm::pow(10.0, numbers.between(-4.0, -1.0));
        let mut moved = motion(0.5);
        let Ok(Some(crossing)) = moved.slow_step(&set, tube, Some(section)) else { continue };
        let duration = moved.observed.duration;
        if near.is_long(duration) {
            continue;
        }
        crossed += 1;
        let earliest = duration.lower();
        let end = |p: [f64; 2], signs: [f64; 5]| {
            let member = near.after(near.member(p, signs), earliest);
            let state = until(near.slider, member, &|state| state[0] - section, &|state| state[2]).state;
            assert!(holds(duration, state[3]), "{case} {duration:?} {}", state[3]);
            assert!(
                holds(with_p(crossing.centre[0], crossing.derivative[0], p), state[1]),
                "{case} {p:?} {state:?}"
            );
            assert!(
                near.psi(state).abs() <= crossing.centre[1].magnitude() + 1e-9,
                "{case} {:?}",
                crossing.centre
            );
            state
        };
        near.pairs(end, |ends, j, apart| {
            assert!(holds_slope(crossing.derivative[0][j], ends.map(|end| end[1]), apart), "{case} {j}");
            let slopes = crossing.derivative[1].map(Interval::magnitude);
            assert!(near.holds_tube_slope(slopes, ends, j, apart), "{case} {j} {ends:?} {slopes:?}");
        });
    }
    assert!(shifted > 50 && plain > 10 && crossed > 30, "{shifted} {plain} {crossed}");
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
        let slopes: Derivative<3> =
            [near.slopes[0], near.slopes[1], [first, second]].map(|row| row.map(Interval::point));
        let state = std::array::from_fn(|i| Interval { mid: [x, y, force][i], rad: errors[i] });
        let whole = Set::new(near.radius.map(Interval::symmetric), state, slopes);
        let mut motion = Motion::new(&constants, States::Inertial(whole.clone()), 1).sticks_at_once();
        motion.lateness = 1e9;
        let Some(States::Stuck(stuck, tube)) = motion.entered(&whole) else { continue };
        entered += 1;
        let (hull, derivative, at_centre) = (stuck.hull(), stuck.derivative(), stuck.at_centre());
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
