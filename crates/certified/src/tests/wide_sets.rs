//! Wide sets against single motions of the whole slider: each shift, step, crossing and change of the description is refused, or it holds
//! the motions with their derivatives, times and extremes.

mod slow;

use super::members::{Member, Slider, passing};
use crate::Constants;
use crate::inertial::Inertial;
use crate::interval::Interval;
use crate::motion::CrossingSet;
use crate::motion::{Motion, States, landing};
use crate::observed::Passed;
use crate::set::{COORDINATES, Set};
use crate::step::Expansion;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::split_mix::SplitMix64;

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
    const SHORT: f64 = 0.01;
    let missing = |member: &Member| -distance(&member.state) / rate(&member.state);
    for _ in 0..10_000 {
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

/// A step far below a section, in which x falls.
fn falling(section: f64) -> Passed {
    passing(Interval::point(section - 10.0), Interval::point(-1.0))
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
    fn assert_crossing(&self, crossing: &CrossingSet, duration: Interval, section: f64) {
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
        let mut whole = Whole::random(&mut numbers, EvolutionLaw::ALL[case % 2]);
        if case % 4 > 1 {
            // So slow that x' may change its sign before the section.
            whole.centre[2] = libm::pow(10.0, numbers.between(-3.0, 0.0));
        }
        let constants = whole.slider.constants();
        let set = whole.set();
        let hull = set.hull();
        let motion = || Motion::new(&constants, States::Inertial(set.clone()), 1);
        let mut moved = motion();
        if let Some(shifted) = moved.without_flow(&set, None) {
            shifts += 1;
            whole.assert_shift(&shifted, &moved, hull[0]);
        }
        let away =
            if case % 4 > 1 { whole.centre[2] * libm::pow(10.0, numbers.between(-2.5, 0.0)) } else { 1e-3 };
        let section =
            whole.centre[0] + [0.0, 1.0, -1.0][case % 3] * numbers.between(0.0, 2.0) * (hull[0].rad + away);
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

/// How often a motion crosses a velocity upward, by short steps, until `is_over`; with its states in between.
fn upward_crossings(
    slider: Slider,
    mut member: Member,
    section: f64,
    is_over: &dyn Fn(&[f64; 4]) -> bool,
) -> (usize, Member) {
    let mut crossings = 0;
    for _ in 0..20_000 {
        if is_over(&member.state) {
            break;
        }
        let next = step(slider, member, 0.002);
        crossings += usize::from(member.state[0] < section && next.state[0] >= section);
        member = next;
    }
    (crossings, member)
}

/// The duration of a step alone, if the first length that is tried is taken.
fn duration_of_step(constants: &Constants, set: &Set<3>, reach: f64, section: f64) -> Option<Interval> {
    let system = Inertial(constants);
    let expansion = Expansion::new(&system, set);
    let length = expansion.length();
    let (h, _) = landing(&expansion, [reach * length, length], Some(section));
    Some(Interval::ZERO + expansion.step(&system, set, h, 0.0)?.duration)
}

/// Steps of the whole slider from wide sets, with sections that they may cross: a step without a crossing has no member that crosses, and a
/// crossing is the first one of each member after the start. What is observed holds the members.
#[test]
fn a_step_of_the_widest_sets_crosses_a_section_once_or_never() {
    let mut numbers = Numbers(SplitMix64(29));
    let (mut plain, mut crossed, mut refused) = (0, 0, 0);
    for case in 0..1500 {
        let mut whole = Whole::random(&mut numbers, EvolutionLaw::ALL[case % 2]);
        if case % 3 == 0 {
            // Around an extreme of V.
            whole.centre[2] = numbers.between(-0.2, 0.2);
        }
        let constants = whole.slider.constants();
        let set = whole.set();
        let hull = set.hull();
        let section = whole.centre[0]
            + numbers.between(-2.0, 4.0) * (hull[0].rad + libm::pow(10.0, numbers.between(-4.0, 0.0)));
        let mut motion = Motion::new(&constants, States::Inertial(set.clone()), 1);
        let reach = numbers.between(0.05, 0.7);
        (motion.may_stick, motion.reach) = (false, reach);
        // The motion has not started on the section: it has fallen far below.
        motion.refuse_other_crossings(&falling(section), section).unwrap();
        let found = motion.advance(Some(section));
        let duration = motion.observed.duration;
        let States::Inertial(end) = &motion.states else { panic!("it sticks") };
        match found {
            Err(_) => refused += 1,
            Ok(Some(crossing)) => {
                crossed += 1;
                for signs in Whole::signs() {
                    let member = whole.member([0.0; 2], signs);
                    assert!(member.state[0] < section, "{case} {member:?} starts above {section}");
                    let (count, near) =
                        upward_crossings(whole.slider, member, section, &|state| state[0] >= section);
                    assert_eq!(count, 1, "{case} {member:?} does not cross {section}");
                    let at = until(whole.slider, near, &|state| state[0] - section, &|state| state[2]).state;
                    assert!(holds(duration, at[3]), "{case} {at:?} {duration:?}");
                    assert!(
                        (0..2).all(|i| holds(crossing.centre[i], at[i + 1])),
                        "{case} {at:?} {crossing:?}"
                    );
                }
            }
            Ok(None) => {
                // Across the flow, if the set has been shifted there after the step.
                if duration_of_step(&constants, &set, reach, section).is_none_or(|alone| alone == duration) {
                    continue;
                }
                let [cx, cy, cf] = end.centre;
                let rates = whole.slider.rates([cx, cy, cf, 0.0]);
                let normal = [rates[0], rates[1], rates[2]];
                plain += 1;
                let distance =
                    |state: &[f64; 4]| (0..3).map(|i| normal[i] * (state[i] - end.centre[i])).sum::<f64>();
                let end_hull = end.hull();
                let mut reached = [f64::NEG_INFINITY; 3];
                for signs in Whole::signs() {
                    let member = whole.member([0.0; 2], signs);
                    // The plane is crossed once near the end: not before most of the time has passed.
                    let is_over = |state: &[f64; 4]| state[3] >= duration.lower();
                    let (first, near) = upward_crossings(whole.slider, member, section, &is_over);
                    let is_over = |state: &[f64; 4]| distance(state) >= 0.0;
                    let is_early = !is_over(&near.state);
                    let (_, over) = upward_crossings(whole.slider, near, section, &is_over);
                    let rate = |state: &[f64; 4]| {
                        let rates = whole.slider.rates(*state);
                        (0..3).map(|i| normal[i] * rates[i]).sum::<f64>()
                    };
                    let at = until(whole.slider, if is_early { over } else { near }, &distance, &rate);
                    let has_crossed = member.state[0] < section && at.state[0] >= section;
                    let is_crossed = has_crossed || is_early && first > 0;
                    assert!(!is_crossed, "{case} {member:?} {at:?} {section}");
                    assert!((0..3).all(|i| holds(end_hull[i], at.state[i])), "{case} {at:?} {end_hull:?}");
                    assert!(holds(duration, at.state[3]), "{case} {at:?} {duration:?}");
                    let seen =
                        [near.largest, whole.slider.member([at.state[0], at.state[1], at.state[2]]).largest];
                    reached = std::array::from_fn(|i| {
                        reached[i].max(seen[1][i]).max(if is_over(&near.state) {
                            seen[1][i]
                        } else {
                            seen[0][i]
                        })
                    });
                }
                // The next step notes the states that it starts from.
                let next = motion.moment(&end_hull);
                motion.observed.state(next.x, next.stress);
                let ([_, peak], [_, drop]) = (motion.observed.peak(), motion.observed.stress_drop());
                assert!(reached[0] <= peak + ERROR, "{case} {reached:?} {peak}");
                assert!(reached[1] + reached[2] <= drop + ERROR, "{case} {reached:?} {drop}");
            }
        }
    }
    assert!(plain > 100 && crossed > 100 && refused > 100, "{plain} {crossed} {refused}");
}
