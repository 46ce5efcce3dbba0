//! Enclosed motions of wide sets against single motions of the sets, by Runge and Kutta's method on the whole equations.

use crate::inertial::Inertial;
use crate::interval::Interval;
use crate::manifold::Manifold;
use crate::motion::CrossingSet;
use crate::motion::{Motion, States};
use crate::observed::{Moment, Observed, Passed};
use crate::set::{COORDINATES, Set};
use crate::{Constants, Reason};
use slipmode_core::friction::EvolutionLaw;

/// η, κ, β and the law, as numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slider {
    pub inertia: f64,
    pub stiffness: f64,
    pub effect_ratio: f64,
    pub law: EvolutionLaw,
}

/// One motion so far: x, y, F and the time, then the largest x, ζ and −ζ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Member {
    pub state: [f64; 4],
    pub largest: [f64; 3],
}

impl Slider {
    pub fn constants(self) -> Constants {
        let [inertia, stiffness, effect_ratio] =
            [self.inertia, self.stiffness, self.effect_ratio].map(Interval::point);
        Constants { inertia, stiffness, effect_ratio, law: self.law }
    }

    /// dy/dt.
    pub fn state_rate(self, x: f64, y: f64) -> f64 {
        match self.law {
            EvolutionLaw::Slip => -libm::exp(x) * (x + y),
            EvolutionLaw::Aging => libm::exp(-y) - libm::exp(x),
        }
    }

    /// The rates of x, y, F and t in s, where dt = ηV ds.
    pub fn rates(self, [x, y, force, _]: [f64; 4]) -> [f64; 4] {
        let velocity = libm::exp(x);
        let clock = self.inertia * velocity;
        let state_rate = clock * self.state_rate(x, y);
        let loading = self.stiffness * clock * (1.0 - velocity);
        [force, state_rate, loading - force - self.effect_ratio * state_rate, clock]
    }

    fn extremes(self, [x, y, force, _]: [f64; 4]) -> [f64; 3] {
        let stress = force + x + self.effect_ratio * y;
        [x, stress, -stress]
    }

    /// A motion that begins here.
    pub fn member(self, [x, y, force]: [f64; 3]) -> Member {
        let state = [x, y, force, 0.0];
        Member { state, largest: self.extremes(state) }
    }

    /// One step in s, with the maximum of the parabola where x or ζ has one.
    pub fn step(self, member: Member, ds: f64) -> Member {
        let start = member.state;
        let moved = |by: [f64; 4], h: f64| std::array::from_fn(|i| start[i] + h * by[i]);
        let first = self.rates(start);
        let second = self.rates(moved(first, 0.5 * ds));
        let third = self.rates(moved(second, 0.5 * ds));
        let fourth = self.rates(moved(third, ds));
        let state = std::array::from_fn(|i| {
            start[i] + ds / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i])
        });
        let stress_rate = |[x, ..]: [f64; 4]| -libm::exp(x) * libm::expm1(x) * self.stiffness * self.inertia;
        let speeds = [start, state].map(|z| [z[2], stress_rate(z), -stress_rate(z)]);
        let (before, after) = (self.extremes(start), self.extremes(state));
        let largest = std::array::from_fn(|i| {
            let [from, to] = [speeds[0][i], speeds[1][i]];
            let beyond = if from > 0.0 && to < 0.0 { 0.5 * ds * from * from / (from - to) } else { 0.0 };
            member.largest[i].max(before[i] + beyond).max(after[i])
        });
        Member { state, largest }
    }

    /// The motion up to where it crosses a velocity upward.
    pub fn until(self, mut member: Member, section: f64, ds: f64) -> Member {
        loop {
            let next = self.step(member, ds);
            if member.state[0] < section && next.state[0] >= section {
                break;
            }
            member = next;
        }
        for _ in 0..6 {
            member = self.step(member, (section - member.state[0]) / member.state[2]);
        }
        member
    }
}

/// A step of which only x and x' count.
pub(crate) fn passing(x: Interval, speed: Interval) -> Passed {
    let moment = Moment { x, speed, stress: Interval::ZERO };
    let nothing = Interval::ZERO;
    Passed {
        start: moment,
        end: moment,
        x,
        speed,
        acceleration: Interval::symmetric(f64::INFINITY),
        loading: nothing,
        length: 0.0,
        duration: nothing,
    }
}

/// A set, a section and how its members are followed.
struct Case {
    slider: Slider,
    start: [f64; 3],
    /// The radii of p = (y, F), and of the errors of x, y and F.
    radius: [f64; 2],
    errors: [f64; 3],
    section: f64,
    ds: f64,
    is_stuck: bool,
}

impl Case {
    fn enclosed(&self, constants: &Constants) -> Result<(CrossingSet, Observed), Reason> {
        let (zero, one) = (Interval::ZERO, Interval::ONE);
        let state = std::array::from_fn(|i| Interval { mid: self.start[i], rad: self.errors[i] });
        let box_of_p = self.radius.map(Interval::symmetric);
        let set = Set::new(box_of_p, state, [[zero; COORDINATES], [one, zero], [zero, one]]);
        let mut motion = Motion::new(constants, States::Inertial(set), 10_000);
        // Wide sets need short steps.
        (motion.reach, motion.longest) = (0.3, 0.3);
        (motion.may_stick, motion.has_fallen) = (self.is_stuck, self.is_stuck);
        loop {
            if let Some(crossing) = motion.advance(Some(self.section))? {
                return Ok((crossing, motion.observed));
            }
        }
    }

    /// The second coordinate of a crossing: F, or ψ.
    fn second(&self, constants: &Constants, crossing: &CrossingSet, [x, y, force, _]: [f64; 4]) -> f64 {
        let is_slow = crossing.centre[1].mid == 0.0;
        let manifold = || Manifold::over(constants, &[x, y].map(Interval::point));
        if is_slow { force / (self.slider.inertia * libm::exp(x)) - manifold().rate.mid } else { force }
    }

    /// Checks the enclosure, if there is one of so wide a set.
    fn is_held(&self) -> bool {
        /// Of the single motions.
        const ERROR: f64 = 1e-11;
        let constants = self.slider.constants();
        let Ok((crossing, observed)) = self.enclosed(&constants) else { return false };
        let near = |[low, high]: [f64; 2], value: f64| low <= value + ERROR && value - ERROR <= high;
        let holds = |c: Interval, value: f64| near([c.lower(), c.upper()], value);
        let end = |p: [f64; 2], errors: [f64; 3]| {
            let [x, y, force] = std::array::from_fn(|i| self.start[i] + errors[i]);
            let member = self.slider.member([x, y + p[0], force + p[1]]);
            let end = self.slider.until(member, self.section, self.ds);
            let image = [end.state[1], self.second(&constants, &crossing, end.state)];
            for i in 0..2 {
                let along = crossing.derivative[i][0] * Interval::point(p[0])
                    + crossing.derivative[i][1] * Interval::point(p[1]);
                // The second coordinate of a slow section is bounded over the whole box.
                assert!(holds(crossing.centre[i] + along, image[i]), "{i} {image:?} {crossing:?}");
            }
            let [peak, high, low] = end.largest;
            assert!(near(observed.peak(), peak), "{peak} {:?}", observed.peak());
            assert!(near(observed.stress_drop(), high + low), "{} {:?}", high + low, observed.stress_drop());
            assert!(holds(observed.duration, end.state[3]), "{} {:?}", end.state[3], observed.duration);
            image
        };
        let [first, second] = self.radius;
        for sign in [1.0, -1.0] {
            end([0.0; 2], self.errors.map(|error| sign * error));
            end([0.0; 2], [sign, sign, -sign].map(|sign| sign * self.errors[0]));
            for (j, p) in [[sign * first, 0.0], [0.0, sign * second]].into_iter().enumerate() {
                let (image, centre) = (end(p, [0.0; 3]), end([0.0; 2], [0.0; 3]));
                for i in 0..2 {
                    let change = Interval { mid: image[i] - centre[i], rad: 2.0 * ERROR };
                    let slope = change * Interval::point(p[j]).reciprocal();
                    let excess = crossing.derivative[i][j] - slope;
                    assert!(excess.may_contain(0.0), "{i} {j} {slope:?} {:?}", crossing.derivative[i][j]);
                }
            }
        }
        true
    }
}

#[test]
fn a_wide_set_holds_its_members() {
    let widths = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
    for law in EvolutionLaw::ALL {
        let swinging = Slider { inertia: 0.5, stiffness: 0.3, effect_ratio: 1.5, law };
        let held = |case: fn(Slider, f64) -> Case, slider: Slider| {
            widths.iter().filter(|&&width| case(slider, width).is_held()).take(2).count()
        };
        let counts = [
            held(
                |slider, width| Case {
                    slider,
                    start: [0.0, 0.0, 0.2],
                    radius: [width, width],
                    errors: [0.0, 0.1 * width, 0.1 * width],
                    section: 0.0,
                    ds: 2e-3,
                    is_stuck: false,
                },
                swinging,
            ),
            held(|slider, width| sticking(slider, width, -1.5), Slider { inertia: 2e-3, ..swinging }),
            held(|slider, width| sticking(slider, width, -0.5), Slider { inertia: 2e-3, ..swinging }),
        ];
        assert!(counts.iter().all(|&count| count > 0), "{law:?} {counts:?}");
    }
}

/// A slider that sticks at V = V_l/e², near the slow manifold.
fn sticking(slider: Slider, width: f64, section: f64) -> Case {
    let velocity = libm::exp(-2.0);
    let force = slider.inertia * velocity * slider.stiffness * (1.0 - velocity);
    let radius = [width, width * force];
    let errors = [0.0, 0.1 * width, 0.1 * width * force];
    Case { slider, start: [-2.0, 2.0, force], radius, errors, section, ds: 0.25, is_stuck: true }
}

/// A rising set: its shift across the flow and its crossing hold each member, with the derivative by p and the time.
#[test]
fn a_shift_and_a_crossing_hold_the_members() {
    const ERROR: f64 = 1e-11;
    let (zero, one, none) = (Interval::ZERO, Interval::ONE, [0.0; 3]);
    for law in EvolutionLaw::ALL {
        let slider = Slider { inertia: 0.5, stiffness: 0.3, effect_ratio: 1.5, law };
        let constants = slider.constants();
        for section in [5e-4, 2e-2] {
            let (start, errors, radius) = ([0.0, 0.2, 0.4], [4e-5, 1e-5, 2e-5], [1e-4, 2e-4]);
            let state = std::array::from_fn(|i| Interval { mid: start[i], rad: errors[i] });
            let derivative = [[one, zero], [zero, one], [one, one]];
            let set = Set::new(radius.map(Interval::symmetric), state, derivative);
            let motion = || Motion::new(&constants, States::Inertial(set.clone()), 1);
            let (mut shifts, mut crosses) = (motion(), motion());
            let shifted = shifts.without_flow(&set, None).unwrap();
            assert!(motion().without_flow(&set, Some(1e-5)).is_none(), "the shift may cross the section");
            let crossing = crosses.inertial_crossing(&set, section).unwrap();
            let normal = slider.rates([start[0], start[1], start[2], 0.0]);
            let along = |v: [f64; 4]| (0..3).map(|i| normal[i] * v[i]).sum::<f64>();
            let member = |p: [f64; 2], off: [f64; 3]| {
                let [x, y, force] = std::array::from_fn(|i| start[i] + off[i]);
                slider.member([x + p[0], y + p[1], force + p[0] + p[1]])
            };
            let holds = |c: Interval, value: f64| c.widened(ERROR).may_contain(value);
            // Where it crosses the plane, where it crosses the section, and the times of both.
            let images = |p: [f64; 2], off: [f64; 3]| {
                let mut moved = member(p, off);
                for _ in 0..6 {
                    let away = std::array::from_fn(|i| if i < 3 { moved.state[i] - start[i] } else { 0.0 });
                    moved = slider.step(moved, -along(away) / along(slider.rates(moved.state)));
                }
                let crossed = slider.until(member(p, off), section, 1e-3);
                assert!((0..3).all(|i| holds(shifted.hull()[i], moved.state[i])), "{moved:?}");
                assert!(holds(shifts.observed.duration, moved.state[3]), "{:?}", shifts.observed.duration);
                assert!(
                    holds(crosses.observed.duration, crossed.state[3]),
                    "{:?}",
                    crosses.observed.duration
                );
                for i in 0..2 {
                    let by_p = (0..2).fold(crossing.centre[i], |sum, j| {
                        sum + crossing.derivative[i][j] * Interval::point(p[j])
                    });
                    assert!(holds(by_p, crossed.state[i + 1]), "{crossed:?} {crossing:?}");
                }
                (moved.state, crossed.state)
            };
            for sign in [1.0, -1.0] {
                for signs in [[1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, -1.0]] {
                    images([0.0; 2], std::array::from_fn(|i| sign * signs[i] * errors[i]));
                }
                for (j, p) in [[sign * radius[0], 0.0], [0.0, sign * radius[1]]].into_iter().enumerate() {
                    let (to, from) = (images(p, none), images([0.0; 2], none));
                    let slope = |to: f64, from: f64| {
                        Interval { mid: to - from, rad: 2.0 * ERROR } * Interval::point(p[j]).reciprocal()
                    };
                    for i in 0..3 {
                        let excess = shifted.derivative()[i][j] - slope(to.0[i], from.0[i]);
                        assert!(excess.may_contain(0.0), "{i} {j} {excess:?}");
                    }
                    for i in 0..2 {
                        let excess = crossing.derivative[i][j] - slope(to.1[i + 1], from.1[i + 1]);
                        assert!(excess.may_contain(0.0), "{i} {j} {excess:?}");
                    }
                }
            }
        }
    }
}

/// The derivative of the rates holds their difference quotients.
#[test]
fn the_jacobian_holds_difference_quotients() {
    for law in EvolutionLaw::ALL {
        let slider = Slider { inertia: 0.5, stiffness: 0.3, effect_ratio: 1.5, law };
        let constants = slider.constants();
        for at in [[0.3, -0.2, 0.4], [-1.0, 0.7, -0.2], [0.0, 0.0, 0.0]] {
            let jacobian = Inertial(&constants).jacobian(&at.map(Interval::point));
            for j in [0, 1, 2] {
                let rates = |by: f64| {
                    slider.rates(std::array::from_fn(|i| {
                        if i == 3 { 0.0 } else { at[i] + if i == j { by } else { 0.0 } }
                    }))
                };
                let (before, after) = (rates(-1e-5), rates(1e-5));
                for (i, row) in jacobian.iter().enumerate() {
                    let slope = (after[i] - before[i]) / 2e-5;
                    assert!(row[j].widened(1e-8).may_contain(slope), "{law:?} {i} {j} {slope}");
                }
            }
        }
    }
}
