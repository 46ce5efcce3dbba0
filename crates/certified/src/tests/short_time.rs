//! Flows with solutions in closed form: the box of a short time, the shift across the flow and the crossing of a section.

use crate::Constants;
use crate::crossing::{crossed, crossed_slowly};
use crate::inertial::Inertial;
use crate::interval::Interval;
use crate::manifold::{Manifold, Tube};
use crate::motion::CrossingSet;
use crate::set::{COORDINATES, Set};
use crate::short_time::ShortTime;
use crate::transversal::shifted_slowly;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::split_mix::SplitMix64;

use super::members::Slider;

const ZERO: Interval = Interval::ZERO;
const ONE: Interval = Interval::ONE;
/// The box of p is a point, or so small that nothing depends on it.
const NO_P: [Interval; COORDINATES] = [ZERO; COORDINATES];

fn point(value: f64) -> Interval {
    Interval::point(value)
}

fn symmetric(rad: f64) -> Interval {
    Interval::symmetric(rad)
}

/// Of numbers that are computed without bounds.
fn holds(interval: Interval, value: f64) -> bool {
    interval.widened(1e-13 * (1.0 + value.abs())).may_contain(value)
}

fn at_least(bound: f64, value: f64) -> bool {
    bound >= value.abs() * (1.0 - 1e-13)
}

/// What is found of the motions from a hull, with rates that are given over a box, until the plane through 0.
fn until_plane<const N: usize>(
    hull: [Interval; N],
    normal: [f64; N],
    distance: f64,
    guess: [f64; N],
    over: impl Fn(&[Interval; N]) -> [Interval; N],
) -> Option<ShortTime<N, [Interval; N]>> {
    let over = |at: &[Interval; N], _: f64| Ok((over(at), *at));
    ShortTime::until_plane(&hull, normal.map(point), distance, &guess.map(point), over).ok()
}

/// z' = e_i + z_i e_j: the coordinate j falls with z_i from 0 and grows with it, by z_i²/2. Where the first rates show nothing of
/// this, the box is refused, or it holds each motion until the plane z_i = 0.
#[test]
fn a_box_of_a_short_time_holds_every_coordinate() {
    let mut found = [0; 2];
    for (i, j) in [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)] {
        for from in [-0.3, 0.3] {
            for guessed in [0.0, 0.02, 0.5, 3.0] {
                let unit = |k: usize| if k == i { 1.0 } else { 0.0 };
                let mut start = [0.0; 3];
                start[i] = from;
                let guess = std::array::from_fn(|k| if k == j { guessed } else { 1.0 });
                let over =
                    |at: &[Interval; 3]| std::array::from_fn(|k| if k == j { at[i] } else { point(unit(k)) });
                let normal = std::array::from_fn(unit);
                let short = until_plane(start.map(point), normal, f64::abs(from), guess, over);
                found[usize::from(short.is_some())] += 1;
                let Some(short) = short else { continue };
                assert!(short.time >= f64::abs(from) && short.slowest <= 1.0);
                for part in 0..=8 {
                    let at = from * (1.0 - f64::from(part) / 8.0);
                    let mut state = [0.0; 3];
                    (state[i], state[j]) = (at, 0.5 * (at * at - from * from));
                    let mut rates: [f64; 3] = std::array::from_fn(unit);
                    rates[j] = at;
                    for k in 0..3 {
                        assert!(
                            holds(short.during[k], state[k]) && holds(short.around[k], state[k]),
                            "{i} {j} {k}"
                        );
                        assert!(holds(short.rates[k], rates[k]), "{i} {j} {k}");
                    }
                }
            }
        }
    }
    assert!(found[0] >= 12 && found[1] >= 12, "{found:?}");
}

/// x' = 1 − x²: no motion leaves x = −1, and from nearby it leaves late. The time is long enough to get on by a distance, or there is none.
#[test]
fn a_short_time_is_long_enough_to_reach_the_plane() {
    let mut found = [0; 2];
    let over = |at: &[Interval; 1]| {
        let [far, near] = [at[0].magnitude(), at[0].mignitude()].map(|x| 1.0 - x * x);
        [Interval::between(far, near)]
    };
    for from in [-1.5, -1.0, -0.99, -0.9, -0.7, -0.5, -0.2] {
        for distance in [1e-3, 0.01, 0.03, 0.1, 0.2] {
            for guess in [1.0 - from * from, 1.0, 0.3, 0.03, -1.0, 10.0] {
                for rad in [0.0, 0.3 * distance] {
                    let hull = [Interval { mid: from, rad }];
                    let short = until_plane(hull, [1.0], distance + rad, [guess], over);
                    found[usize::from(short.is_some())] += 1;
                    let Some(short) = short else { continue };
                    for start in [from - rad, from, from + rad] {
                        assert!(start > -1.0, "{from} {rad} is not left");
                        let time = libm::atanh(from + distance) - libm::atanh(start);
                        assert!(short.time >= time * (1.0 - 1e-12), "{from} {rad} {guess} {short:?}");
                        assert!(short.slowest <= 1.0 - start * start);
                    }
                }
            }
        }
    }
    assert!(found.iter().all(|&count| count > 50), "{found:?}");
}

/// Constant rates: the motion along the first coordinate takes d/v, and moves the second one by w d/v.
#[test]
fn a_short_time_holds_straight_motions() {
    let mut found = [0; 2];
    for v in [0.1, 0.3, 0.45, 0.55, 0.7, 1.0, 2.0, -1.0] {
        for w in [0.0, 0.5, 1.5, 1.9, 2.5, 3.5, -3.5, 10.0] {
            let (distance, guess) = (0.1, [1.0, 1.0]);
            let short = until_plane([ZERO; 2], [1.0, 0.0], distance, guess, |_| [v, w].map(point));
            found[usize::from(short.is_some())] += 1;
            let Some(short) = short else { continue };
            let time = distance / v;
            assert!(v > 0.0 && short.time >= time * (1.0 - 1e-12), "{v} {w} {short:?}");
            for time in [time, -time] {
                assert!(
                    holds(short.during[0], v * time) && holds(short.during[1], w * time),
                    "{v} {w} {short:?}"
                );
            }
        }
    }
    assert!(found.iter().all(|&count| count > 10), "{found:?}");
}

/// Wide rates: I − f nᵀ/(n·f) of each of them is held.
#[test]
fn the_projection_along_each_rate_is_held() {
    let mut random = SplitMix64(41);
    for case in 0..400 {
        let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
        let normal: [f64; 2] = [number(0.5, 2.0), number(-0.5, 0.5)];
        let rad = [0.0, 1e-3, 0.5][case % 3];
        let rates = [Interval { mid: number(1.0, 2.0), rad }, Interval { mid: number(-0.5, 0.5), rad: 0.0 }];
        let normal_points = normal.map(point);
        let short =
            ShortTime { normal: normal_points, time: 1.0, during: rates, rates, slowest: 0.1, around: () };
        let found = short.projection();
        for part in [-1.0, -0.5, 0.0, 1.0] {
            let f = rates.map(|c| c.mid + part * c.rad);
            let along = normal[0] * f[0] + normal[1] * f[1];
            for i in 0..2 {
                for j in 0..2 {
                    let exact = if i == j { 1.0 } else { 0.0 } - f[i] * normal[j] / along;
                    assert!(holds(found[i][j], exact), "{i} {j} {exact} {:?}", found[i][j]);
                }
            }
        }
    }
}

/// J = a[[0, 1], [1, 0]] carries (1, 1) to e^{at}(1, 1) and (1, −1) to e^{−at}(1, −1): the change is at most the bound, or there is none.
#[test]
fn the_turning_in_a_short_time_is_bounded() {
    let mut bounded = 0;
    for time in [1e-6, 0.01, 0.1, 0.19, 0.3, 0.499, 0.6, 2.0, 5.0] {
        for slope in [0.1, 1.0, 7.0] {
            let short =
                ShortTime { normal: [ONE], time, during: [ONE], rates: [ONE], slowest: 1.0, around: () };
            let Ok(turning) = short.turning(slope) else { continue };
            bounded += 1;
            assert!(at_least(turning, libm::expm1(slope * time)), "{time} {slope} {turning}");
            assert!(at_least(turning, libm::expm1(-slope * time)));
            // How much what pushes meanwhile grows.
            assert!(libm::exp(slope * time) < 1.65);
        }
    }
    assert!(bounded >= 12, "{bounded}");
    let unknown =
        ShortTime { normal: [ONE], time: f64::NAN, during: [ONE], rates: [ONE], slowest: 1.0, around: () };
    assert!(unknown.turning(1.0).is_err());
}

/// Any constants: what surrounds a short time of an artificial flow has only the fields that are set.
fn around(largest_slope: f64, tube: Tube, tube_rate: f64) -> (Manifold, Tube) {
    let constants = Constants { inertia: ONE, stiffness: ONE, effect_ratio: ONE, law: EvolutionLaw::Slip };
    let mut manifold = Manifold::over(&constants, &[ZERO; 2]);
    // Without a distance, ψ changes as fast as R says.
    (manifold.largest_slope, manifold.residual) = (largest_slope, tube_rate);
    (manifold, tube)
}

/// A motion along the coordinate i to the plane z_i = 0, in a time s: z_i' = 1 + k z_j and z_j' = μ z_j + A. One of both gains
/// ψ = q·p + w t. The numbers k, μ, A, q and w are zero or not, so that each term of the bounds counts alone.
#[derive(Clone, Copy)]
struct Flow {
    /// The coordinate along which it moves, and the time s that the centre takes.
    i: usize,
    time: f64,
    /// k and μ: how the speed grows with the other coordinate, and the growth of this one.
    shear: f64,
    growth: f64,
    /// ∂ψ/∂p and ψ'.
    by_p: [f64; 2],
    tube_rate: f64,
    /// D, of (z_i, z_j).
    derivative: [[f64; 2]; 2],
    /// The other rate A.
    across: f64,
    /// Whether ψ acts on z_j.
    is_pushed_across: bool,
}

impl Flow {
    /// The states (z_i, z_j) in the order of the flow.
    fn placed<T: Copy>(&self, values: [T; 2]) -> [T; 2] {
        if self.i == 0 { values } else { [values[1], values[0]] }
    }

    /// ∂(z_i, z_j)/∂p after the time s, and ∂s/∂p at the plane, around z_j = 0.
    fn after(&self, j: usize) -> ([f64; 2], f64) {
        let [first, second] = [self.derivative[0][j], self.derivative[1][j]];
        let grown = libm::exp(self.growth * self.time);
        let mean = if self.growth == 0.0 { self.time } else { (grown - 1.0) / self.growth };
        let mut moved = [first + self.shear * second * mean, second * grown];
        if self.is_pushed_across {
            // Shear and growth do not come together.
            moved[0] += self.shear * self.by_p[j] * 0.5 * self.time * self.time;
            moved[1] += self.by_p[j] * mean;
        } else {
            moved[0] += self.by_p[j] * self.time;
        }
        (moved, -moved[0])
    }

    /// Itself, and a fast second coordinate that nothing else changes.
    fn with_and_without_cross_rate(self) -> [Self; 2] {
        [self, Self { shear: 0.0, growth: 0.0, across: 1000.0, is_pushed_across: false, ..self }]
    }

    fn set(&self, offset: f64) -> Set<2> {
        let state = self.placed([symmetric(offset), ZERO]);
        Set::new(NO_P, state, self.placed(self.derivative).map(|row| row.map(point)))
    }

    /// A short time that holds the motions, if those from ±`time` on do.
    fn short(&self) -> ShortTime<2, (Manifold, Tube)> {
        let sizes = self.by_p.map(f64::abs);
        let tube = Tube { distance: 0.0, slopes: sizes };
        let largest = (self.shear.abs()).max(self.growth.abs());
        ShortTime {
            normal: self.placed([ONE, ZERO]),
            time: self.time * (1.0 + 1e-12),
            during: self.placed([symmetric(self.time), symmetric(self.across.abs() * self.time)]),
            rates: self.placed([ONE, point(self.across)]),
            slowest: 1.0,
            around: around(largest, tube, self.tube_rate),
        }
    }
}

/// Flows in which one cause at a time changes the derivative.
fn flows() -> impl Iterator<Item = Flow> {
    let unit = [[[1.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [1.0, 1.0]], [[1.0, 1.0], [1.0, -1.0]], [[0.0; 2]; 2]];
    let causes = [(0.0, 0.0), (0.3, 0.0), (0.0, 0.3), (0.0, -0.3), (-0.3, 0.0)];
    let tubes = [[0.0; 2], [0.2, 0.0], [0.0, -0.4]];
    [0, 1].into_iter().flat_map(move |i| {
        unit.into_iter().flat_map(move |derivative| {
            causes.into_iter().flat_map(move |(shear, growth)| {
                tubes.into_iter().flat_map(move |by_p| {
                    [0.0, 1000.0].into_iter().flat_map(move |tube_rate| {
                        [0.01, 0.3, 0.6, 1.0, 2.0, 5.0].into_iter().map(move |time| Flow {
                            i,
                            time,
                            shear,
                            growth,
                            by_p,
                            tube_rate,
                            derivative,
                            across: 0.0,
                            is_pushed_across: i == 1,
                        })
                    })
                })
            })
        })
    })
}

/// Motions that cross the plane at the time s, before or after now: the derivative on the plane and that of ψ are held, or the time is too long.
#[test]
fn a_shift_holds_flows_in_closed_form() {
    let mut found = [0; 2];
    for flow in flows().flat_map(Flow::with_and_without_cross_rate) {
        let short = flow.short();
        let shifted = shifted_slowly(&flow.set(flow.time), &short);
        found[usize::from(shifted.is_ok())] += 1;
        let Ok((set, tube)) = shifted else { continue };
        let derivative = set.derivative();
        for backward in [false, true] {
            let flow = Flow { time: if backward { -flow.time } else { flow.time }, ..flow };
            for j in 0..COORDINATES {
                let (moved, time_by_p) = flow.after(j);
                // On the plane, the change along the flow is taken away.
                let exact = flow.placed([0.0, moved[1] + flow.across * time_by_p]);
                assert!((0..2).all(|i| holds(derivative[i][j], exact[i])), "{exact:?} {derivative:?}");
                let by_p = flow.by_p[j] + flow.tube_rate * time_by_p;
                assert!(at_least(tube.slopes[j], by_p), "{} {by_p} {}", flow.time, tube.slopes[j]);
            }
        }
    }
    assert!(found.iter().all(|&count| count > 100), "{found:?}");
}

/// The same at the section x = 0, with a second coordinate that changes fast.
#[test]
fn a_crossing_holds_flows_in_closed_form() {
    let mut found = [0; 2];
    for flow in flows().filter(|flow| flow.i == 0).flat_map(Flow::with_and_without_cross_rate) {
        let short = flow.short();
        let crossing = crossed_slowly(&flow.set(flow.time), 0.0, &short);
        found[usize::from(crossing.is_ok())] += 1;
        let Ok(CrossingSet { centre, derivative }) = crossing else { continue };
        for backward in [false, true] {
            let flow = Flow { time: if backward { -flow.time } else { flow.time }, ..flow };
            assert!(holds(centre[0], flow.across * flow.time) && centre[1].may_contain(0.0));
            for j in 0..COORDINATES {
                let (moved, time_by_p) = flow.after(j);
                let exact = moved[1] + flow.across * time_by_p;
                assert!(holds(derivative[0][j], exact), "{} {exact} {derivative:?}", flow.time);
                let by_p = flow.by_p[j] + flow.tube_rate * time_by_p;
                assert!(at_least(derivative[1][j].magnitude(), by_p), "{by_p} {derivative:?}");
            }
        }
    }
    assert!(found.iter().all(|&count| count > 50), "{found:?}");
}

/// x' = F, y' = A: the section is reached after −x/F, so that F changes the y of the crossing by A x/F².
#[test]
fn a_crossing_of_a_fast_state_holds_the_derivative_by_the_speed() {
    for (missing, across) in [(0.1, 0.0), (0.1, 30.0), (0.15, -100.0), (0.01, 1e4)] {
        for from in [missing, -missing] {
            let by_speed = [[ZERO; 2], [ZERO; 2], [ONE, ZERO]];
            let set = Set::new(NO_P, [from, 0.0, 1.0].map(point), by_speed);
            let rates = [ONE, point(across), ZERO];
            let mut jacobian = [[ZERO; 3]; 3];
            jacobian[0][2] = ONE;
            let during = [symmetric(missing), symmetric(missing * f64::abs(across)), ONE];
            let short = ShortTime {
                normal: [ONE, ZERO, ZERO],
                time: missing,
                during,
                rates,
                slowest: 1.0,
                around: jacobian,
            };
            let crossing = crossed(&set, 0.0, &short).unwrap();
            assert!(holds(crossing.centre[0], -from * across));
            assert!(holds(crossing.derivative[0][0], from * across), "{crossing:?}");
        }
    }
}

/// Over a wide box the rates and their derivative are those of each state in it.
#[test]
fn rates_and_their_derivative_over_a_box_hold_those_of_its_states() {
    let mut random = SplitMix64(43);
    for case in 0..40 {
        let slider =
            Slider { inertia: 0.5, stiffness: 0.7, effect_ratio: 1.5, law: EvolutionLaw::ALL[case % 2] };
        let constants = slider.constants();
        let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
        let middle = [number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0)];
        let (rates, slopes) = Inertial(&constants).over(&middle.map(|mid| Interval { mid, rad: 0.3 }));
        for _ in 0..20 {
            let at = middle.map(|c| c + number(-0.3, 0.3));
            let exact = slider.rates([at[0], at[1], at[2], 0.0]);
            assert!((0..3).all(|i| holds(rates[i], exact[i])), "{exact:?} {rates:?}");
            let by = |j: usize, step: f64| {
                let [x, y, force] = std::array::from_fn(|i| if i == j { at[i] + step } else { at[i] });
                slider.rates([x, y, force, 0.0])
            };
            for j in [0, 1, 2] {
                let (before, after) = (by(j, -1e-5), by(j, 1e-5));
                for i in 0..3 {
                    let slope = (after[i] - before[i]) / 2e-5;
                    assert!(
                        slopes[i][j].widened(1e-8).may_contain(slope),
                        "{i} {j} {slope} {:?}",
                        slopes[i][j]
                    );
                }
            }
        }
    }
}
