//! What one step notes, and the tube around it, against single motions and the equation of the whole slider.

use crate::inertial::Inertial;
use crate::interval::Interval;
use crate::manifold::{Manifold, Tube};
use crate::motion::{Motion, States};
use crate::observed::{Moment, Passed};
use crate::set::{COORDINATES, Set};
use crate::slow::Slow;
use crate::step::Expansion;
use crate::sticking::{InTube, LastStep};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::split_mix::SplitMix64;

use super::members::{Slider, passing};

const ZERO: Interval = Interval::ZERO;
const NO_P: [Interval; COORDINATES] = [ZERO; COORDINATES];
const NO_TUBE: Tube = Tube { distance: 0.0, slopes: [0.0; COORDINATES] };

fn point(value: f64) -> Interval {
    Interval::point(value)
}

/// Of numbers that are computed without bounds.
fn holds(interval: Interval, value: f64) -> bool {
    interval.widened(1e-10 * (1.0 + value.abs())).may_contain(value)
}

/// A set around a state, where nothing depends on p.
fn around<const N: usize>(state: [f64; N], errors: [f64; N]) -> Set<N> {
    Set::new(NO_P, std::array::from_fn(|i| Interval { mid: state[i], rad: errors[i] }), [NO_P; N])
}

/// x'' of the whole slider in t, from x, y and x'.
fn acceleration(slider: Slider, [x, y]: [f64; 2], speed: f64) -> f64 {
    let plain = -slider.stiffness * libm::expm1(x) - slider.effect_ratio * slider.state_rate(x, y);
    (plain - speed) / (slider.inertia * libm::exp(x)) - speed * speed
}

/// ψ' at a state, from the same equation.
fn psi_rate(slider: Slider, [x, y]: [f64; 2]) -> impl Fn(f64) -> f64 {
    let here = Manifold::over(&slider.constants(), &[x, y].map(point));
    let ([by_x, by_y], rate) = (here.rate_gradient.map(|c| c.mid), here.rate.mid);
    move |psi| {
        let speed = rate + psi;
        acceleration(slider, [x, y], speed) - by_x * speed - by_y * slider.state_rate(x, y)
    }
}

/// x = c(t − r)(t − s)(t − u) for t from 0 to 1, from below zero: it crosses zero upward once, if this is said of a step with its rates.
#[test]
fn a_step_that_crosses_once_does_not_cross_again() {
    let mut random = SplitMix64(51);
    let mut said = [0; 2];
    for _ in 0..3000 {
        let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
        let (scale, [r, s, u]) = (number(-1.0, 1.0), [0; 3].map(|_| number(-1.5, 1.5)));
        let x = |t: f64| scale * (t - r) * (t - s) * (t - u);
        let sum = r + s + u;
        let speed = |t: f64| scale * (3.0 * t * t - 2.0 * sum * t + r * s + s * u + u * r);
        let bend = |t: f64| scale * (6.0 * t - 2.0 * sum);
        // The speed is extreme at an end or where the bend is zero.
        let turn = (sum / 3.0).clamp(0.0, 1.0);
        let hull = |values: &[f64]| values.iter().copied().map(point).reduce(Interval::hull).unwrap();
        let step = Passed {
            acceleration: hull(&[bend(0.0), bend(1.0)]),
            ..passing(point(x(0.0)), hull(&[speed(0.0), speed(turn), speed(1.0)]))
        };
        let is_single = step.crosses_once(0.0);
        said[usize::from(is_single)] += 1;
        if is_single {
            assert!(x(0.0) < 0.0);
            let at = |k: i32| x(f64::from(k) / 500.0);
            let upward = (0..500).filter(|&k| at(k) < 0.0 && at(k + 1) >= 0.0).count();
            let downward = (0..500).filter(|&k| at(k) > 0.0 && at(k + 1) <= 0.0).count();
            assert!(upward <= 1 && downward == 0, "{scale} {r} {s} {u}");
        }
    }
    assert!(said.iter().all(|&count| count > 300), "{said:?}");
}

/// Whether the moment at an end of a step holds x, x' and ζ.
fn is_at(moment: Moment, x: f64, speed: f64, stress: f64) -> bool {
    holds(moment.x, x) && holds(moment.speed, speed) && holds(moment.stress, stress)
}

/// Steps of the whole slider: all that is noted holds along each motion.
#[test]
fn a_step_of_the_whole_slider_notes_what_its_members_do() {
    const PARTS: i32 = 32;
    let mut random = SplitMix64(53);
    let mut taken = 0;
    for case in 0..300 {
        let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
        let slider = Slider {
            inertia: number(0.05, 2.0),
            stiffness: number(0.1, 2.0),
            effect_ratio: number(0.3, 3.0),
            law: EvolutionLaw::ALL[case % 2],
        };
        // Every third set is at an extreme of V.
        let force = if case % 3 == 0 { number(-0.1, 0.1) } else { number(-0.8, 0.8) };
        let state = [number(-1.0, 0.6), number(-0.6, 1.0), force];
        let size = [0.0, 1e-6, 1e-3, 0.02][case % 4];
        let errors = [size * number(0.0, 1.0), size * number(0.0, 1.0), size * number(0.0, 1.0)];
        let (set, constants) = (around(state, errors), slider.constants());
        let system = Inertial(&constants);
        let expansion = Expansion::new(&system, &set);
        let h = number(0.1, 0.7) * expansion.length();
        let Some(step) = expansion.step(&system, &set, h, 0.0) else { continue };
        taken += 1;
        let end = set.mapped(step.image, &step.slope, &[NO_P; 3]);
        let motion = Motion::new(&constants, States::Inertial(set.clone()), 1);
        let passed = motion.passed([&set.hull(), &end.hull()], &step, h);
        assert_eq!(passed.length, h);
        for sign in [[0.0; 3], [1.0, 1.0, 1.0], [-1.0, -1.0, -1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]] {
            let mut member = slider.member(std::array::from_fn(|i| state[i] + sign[i] * errors[i]));
            for part in 0..=PARTS {
                let [x, y, force, time] = member.state;
                let stress = force + x + slider.effect_ratio * y;
                let loading = slider.stiffness * slider.inertia * libm::exp(x);
                assert!(holds(passed.x, x) && holds(passed.speed, force), "{case} {part} {passed:?}");
                assert!(
                    holds(passed.acceleration, slider.rates(member.state)[2]),
                    "{case} {part} {passed:?}"
                );
                assert!(holds(passed.loading, loading), "{case} {part} {loading} {passed:?}");
                match part {
                    0 => assert!(is_at(passed.start, x, force, stress), "{case} {passed:?}"),
                    PARTS => {
                        assert!(is_at(passed.end, x, force, stress), "{case} {passed:?}");
                        assert!(holds(passed.duration, time), "{case} {time} {passed:?}");
                    }
                    _ => (),
                }
                member = slider.step(member, h / f64::from(PARTS));
            }
        }
    }
    assert!(taken > 200, "{taken}");
}

/// Steps of a sticking slider, at steady sliding too, from any ψ in the tube: the box and all that is noted hold along each motion.
#[test]
fn a_step_of_a_sticking_slider_notes_what_its_members_do() {
    let mut random = SplitMix64(57);
    let mut taken = 0;
    for case in 0..120 {
        let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
        let slider = Slider {
            inertia: libm::pow(10.0, number(-2.3, -1.5)),
            stiffness: number(0.1, 1.0),
            effect_ratio: number(0.3, 2.0),
            law: EvolutionLaw::ALL[case % 2],
        };
        let state = if case % 3 == 0 { [0.0; 2] } else { [number(-1.6, 0.2), number(-0.3, 1.8)] };
        let size = [0.0, 1e-6, 1e-3][case % 3];
        let errors = [size * number(0.0, 1.0), size * number(0.0, 1.0)];
        let tube = Tube { distance: libm::pow(10.0, number(-4.0, -0.5)), ..NO_TUBE };
        let (set, constants) = (around(state, errors), slider.constants());
        let expansion = Expansion::new(&Slow(&constants), &set);
        let inertia = slider.inertia * libm::exp(state[0]);
        let h = (number(0.5, 8.0) * inertia).min(0.7 * expansion.length());
        // The first one allows nothing, the second one a third of what ψ moves at most.
        let mut allowed = 1e-18;
        let mut attempts = (0..4).filter_map(|attempt| {
            if attempt == 1 {
                allowed /= 12.0;
            }
            InTube::of(&constants, &expansion, &set, tube, h, &mut allowed)
        });
        let Some(in_tube) = attempts.next() else { continue };
        taken += 1;
        let motion = Motion::new(&constants, States::Stuck(set.clone(), tube), 1);
        let manifold = |at: [Interval; 2]| Manifold::over(&constants, &at);
        let start = motion.slow_moment(&set.hull(), &manifold(set.hull()), tube.distance);
        let end = in_tube.end(&set, h);
        let passed = motion.slow_passed(start, &end.hull(), &in_tube, h);
        assert!(passed.length == h && holds(passed.loading, slider.stiffness) && holds(passed.duration, h));
        for sign in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, 0.0]]
        {
            let [x, y] = std::array::from_fn(|i| state[i] + sign[i] * errors[i]);
            let speed = manifold([x, y].map(point)).rate.mid + sign[2] * tube.distance;
            let mut member = slider.member([x, y, slider.inertia * libm::exp(x) * speed]);
            let (mut is_first, mut is_last) = (true, false);
            loop {
                let [x, y, force, time] = member.state;
                let clock = slider.inertia * libm::exp(x);
                let (speed, stress) = (force / clock, force + x + slider.effect_ratio * y);
                let bend = acceleration(slider, [x, y], speed);
                assert!(holds(passed.x, x) && holds(in_tube.step.during[1], y), "{case} {time} {passed:?}");
                assert!(passed.speed.widened(1e-9).may_contain(speed), "{case} {time} {speed} {passed:?}");
                let error = 1e-8 * (1.0 + bend.abs()) / clock;
                assert!(
                    passed.acceleration.widened(error).may_contain(bend),
                    "{case} {time} {bend} {passed:?}"
                );
                if is_first {
                    assert!(is_at(passed.start, x, speed, stress), "{case} {passed:?}");
                }
                if is_last {
                    assert!(holds(passed.end.x, x) && holds(passed.end.stress, stress), "{case} {passed:?}");
                    assert!(passed.end.speed.widened(1e-8).may_contain(speed), "{case} {speed} {passed:?}");
                    break;
                }
                is_first = false;
                let left = (h - time) / clock;
                is_last = left <= 0.02;
                member = slider.step(member, left.min(0.02));
                if is_last {
                    for _ in 0..4 {
                        let clock = slider.inertia * libm::exp(member.state[0]);
                        member = slider.step(member, (h - member.state[3]) / clock);
                    }
                }
            }
        }
    }
    assert!(taken > 60, "{taken}");
}

/// Steady sliding that repels: x, y and F grow together with the derivative of ψ, by linear equations. What a prolonged step states of ∂ψ/∂p
/// holds for as long as it lasts.
#[test]
fn a_prolonged_step_holds_the_derivative_of_psi() {
    let mut held = 0;
    for law in EvolutionLaw::ALL {
        for inertia in [0.005, 0.02] {
            for (h, time) in [(0.01, 0.02), (0.01, 0.3), (0.01, 0.6), (0.01, 0.9), (0.6, 0.02)] {
                let slider = Slider { inertia, stiffness: 0.05, effect_ratio: 3.0, law };
                let constants = slider.constants();
                let here = Manifold::over(&constants, &[ZERO; 2]);
                let [by_x, by_y] = here.rate_gradient.map(|c| c.mid);
                let start = Set::new(NO_P, [ZERO; 2], [[point(1.0), ZERO], [point(-1.0), point(0.5)]]);
                let last = LastStep { during: [ZERO; 2], start: &start, tube: NO_TUBE, h };
                let Ok((_, (_, tube))) = last.over(&constants, &[ZERO; 2], time) else { continue };
                held += 1;
                for start in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]] {
                    let [x, y] = start;
                    let mut state = [x, y, inertia * (by_x * x + by_y * y)];
                    let rates = |[x, y, force]: [f64; 3]| {
                        [force / inertia, -(x + y), -0.05 * x - force / inertia + 3.0 * (x + y)]
                    };
                    let dt = 0.05 * inertia;
                    let moved =
                        |state: [f64; 3], by: [f64; 3], h: f64| std::array::from_fn(|i| state[i] + h * by[i]);
                    let mut largest = 0.0;
                    for _ in 0..libm::floor((h + time) / dt) as usize {
                        let first = rates(state);
                        let second = rates(moved(state, first, 0.5 * dt));
                        let third = rates(moved(state, second, 0.5 * dt));
                        let fourth = rates(moved(state, third, dt));
                        state = std::array::from_fn(|i| {
                            state[i] + dt / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i])
                        });
                        let psi = state[2] / inertia - by_x * state[0] - by_y * state[1];
                        largest = f64::max(largest, psi.abs());
                    }
                    let bounds = tube.slopes;
                    assert!(bounds[0] >= largest * (1.0 - 1e-6), "{slider:?} {time} {largest} {bounds:?}");
                    assert!(
                        bounds[1] >= 0.5 * largest * (1.0 - 1e-6),
                        "{slider:?} {time} {largest} {bounds:?}"
                    );
                }
            }
        }
    }
    assert!(held > 6, "{held}");
}

/// A step into another box: ψ settles there, or still fades from where it began, by its equation at each state of either box.
#[test]
fn a_prolonged_step_holds_psi_in_both_boxes() {
    let near = [[-1.5, 1.4], [-1.3, 1.0]];
    let far = [[-0.9, 0.8], [-0.7, 0.9], [-0.8, 1.3]];
    for (law, [from, to]) in EvolutionLaw::ALL.into_iter().flat_map(|law| {
        near.into_iter().flat_map(move |near| {
            far.into_iter().flat_map(move |far| [(law, [near, far]), (law, [far, near])])
        })
    }) {
        let slider = Slider { inertia: 0.005, stiffness: 0.3, effect_ratio: 1.5, law };
        let constants = slider.constants();
        for (distance, time) in [(0.0, 0.05), (0.05, 0.05), (0.05, 0.0995)] {
            let tube = Tube { distance, ..NO_TUBE };
            let start = around(from, [0.0; 2]);
            let last = LastStep { during: from.map(point), start: &start, tube, h: 0.1 };
            let wide = to.map(|mid| Interval { mid, rad: 0.15 });
            let (rates, (manifold, found)) = last.over(&constants, &wide, time).unwrap();
            for at in [from, to, [to[0] - 0.15, to[1] + 0.15], [to[0] + 0.15, to[1] - 0.15]] {
                // ψ at a state that does not move, from the largest at first until the earliest time.
                let (steps, psi_rate) = (500, psi_rate(slider, at));
                let dt = (0.1 - time) / f64::from(steps);
                let mut psi = distance;
                for _ in 0..steps {
                    psi += dt * psi_rate(psi + 0.5 * dt * psi_rate(psi));
                }
                assert!(found.distance >= psi.abs() * (1.0 - 1e-6), "{at:?} {psi} {:?}", found);
                if at == from {
                    continue;
                }
                let here = Manifold::over(&constants, &at.map(point));
                for sign in [1.0, -1.0] {
                    let psi = sign * found.distance;
                    assert!(holds(rates[0], here.rate.mid + psi), "{at:?} {psi} {rates:?}");
                    assert!(manifold.tube_rate(found.distance) >= psi_rate(psi).abs() * (1.0 - 1e-9) - 1e-12);
                }
                assert!(holds(rates[1], slider.state_rate(at[0], at[1])));
                assert!(manifold.largest_slope >= here.largest_slope * (1.0 - 1e-12));
            }
        }
    }
}

/// A set whose farthest state gets ahead of the others by the shift across the flow: a section that it passes by this is not left out.
#[test]
fn no_step_and_no_shift_passes_a_section_unseen() {
    for law in EvolutionLaw::ALL {
        let slider = Slider { inertia: 0.01, stiffness: 0.5, effect_ratio: 1.5, law };
        let constants = slider.constants();
        let (at, off) = ([-1.0, 1.8], [0.0, 0.02]);
        let (mut passed, mut refused) = ([0; 2], [0; 2]);
        // The whole slider.
        let fast = Slider { inertia: 1.0, ..slider };
        let set = around([0.0, 1.0, 0.5], [0.0, 0.005, 0.0]);
        let normal = fast.rates([0.0, 1.0, 0.5, 0.0]);
        let distance =
            |state: [f64; 4]| (0..3).map(|i| normal[i] * (state[i] - [0.0, 1.0, 0.5][i])).sum::<f64>();
        let mut ahead = fast.member([0.0, 1.0 - 0.005 * f64::signum(normal[1]), 0.5]);
        while distance(ahead.state) < 0.0 {
            ahead = fast.step(ahead, 1e-4);
        }
        for part in [0.01, 0.1, 0.5, 0.9, 5.0] {
            let section = part * ahead.state[0];
            let fast = fast.constants();
            let mut motion = Motion::new(&fast, States::Inertial(set.clone()), 1);
            let is_shifted = motion.without_flow(&set, Some(section)).is_some();
            assert!(part > 1.0 || !is_shifted, "{law:?} {section} {ahead:?}");
            passed[usize::from(is_shifted)] += 1;
        }
        // The sticking one, by its last step alone and by whole steps.
        let set = around(at, off);
        let hull = set.hull();
        let whole_step = |section: f64| {
            let mut motion = Motion::new(&constants, States::Stuck(set.clone(), NO_TUBE), 1);
            (motion.reach, motion.lateness) = (0.25, 1e9);
            motion.refuse_other_crossings(&passing(point(-50.0), point(-1.0)), section).unwrap();
            let found = motion.slow_step(&set, NO_TUBE, Some(section));
            let States::Stuck(end, _) = &motion.states else { panic!("it does not stick") };
            (matches!(found, Ok(None)), end.hull()[0].upper(), motion.observed.duration.rad)
        };
        let last = LastStep { during: hull, start: &set, tube: NO_TUBE, h: 0.1 };
        let shift = |section: f64| {
            let mut motion = Motion::new(&constants, States::Stuck(set.clone(), NO_TUBE), 1);
            motion.slow_without_flow(&set, &last, Some(section)).map(|(moved, _)| moved.hull()[0].upper())
        };
        // The farthest places that are reached with a section far ahead.
        let (_, after_step, is_shifted) = whole_step(10.0);
        let after_shift = shift(10.0).unwrap();
        assert!(
            is_shifted > 1e-4 && after_shift > hull[0].upper() + 1e-3,
            "{law:?} {is_shifted} {after_shift}"
        );
        for k in 0..60 {
            let back = 2e-4 * f64::from(k);
            let section = after_step - back;
            let (has_not_crossed, upper, _) = whole_step(section);
            assert!(!has_not_crossed || upper < section, "{law:?} {section} {upper}");
            refused[0] += usize::from(!has_not_crossed);
            let section = after_shift - back;
            let found = shift(section);
            assert!(
                found.is_none_or(|upper| upper < section || section < hull[0].lower()),
                "{law:?} {section}"
            );
            refused[1] += usize::from(found.is_none());
        }
        assert!([passed, refused].iter().flatten().all(|&count| count > 0), "{passed:?} {refused:?}");
    }
}

/// Sets at V = V_l that are wide in y alone, with a range of ζ as small as β or without inertia: on the plane ζ is beyond that range.
#[test]
fn a_shift_notes_the_stress_meanwhile() {
    let range = |stresses: &[f64]| {
        let (low, high) = stresses.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &stress| {
            (low.min(stress), high.max(stress))
        });
        high - low
    };
    for (law, effect_ratio) in EvolutionLaw::ALL.into_iter().flat_map(|law| [(law, 1e-9), (law, 0.3)]) {
        let slider = Slider { inertia: 1.0, stiffness: 1.0, effect_ratio, law };
        let constants = slider.constants();
        let at = [0.0, -1.0, 1.0];
        let set = around(at, [0.0, 0.02, 0.0]);
        let mut motion = Motion::new(&constants, States::Inertial(set.clone()), 1);
        motion.without_flow(&set, None).unwrap();
        let normal = slider.rates([at[0], at[1], at[2], 0.0]);
        let along = |v: [f64; 3]| (0..3).map(|i| normal[i] * v[i]).sum::<f64>();
        let mut stresses = Vec::new();
        for sign in [1.0, -1.0] {
            let mut member = slider.member([at[0], at[1] + sign * 0.02, at[2]]);
            stresses.push(member.largest[1]);
            for _ in 0..6 {
                let rates = slider.rates(member.state);
                let missing = -along(std::array::from_fn(|i| member.state[i] - at[i]));
                member = slider.step(member, missing / along([rates[0], rates[1], rates[2]]));
            }
            let [x, y, force, _] = member.state;
            stresses.push(force + x + effect_ratio * y);
        }
        let [_, drop] = motion.observed.stress_drop();
        assert!(drop >= range(&stresses) && range(&stresses) > 1e-5, "{law:?} {drop} {stresses:?}");
    }
    for law in EvolutionLaw::ALL {
        // Without inertia: x' = κ(1 − e^x) − βg.
        let slider = Slider { inertia: 1e-9, stiffness: 1.0, effect_ratio: 0.5, law };
        let constants = slider.constants();
        let set = around([0.0, -1.0], [0.0, 0.04]);
        let last = LastStep { during: set.hull(), start: &set, tube: NO_TUBE, h: 1.0 };
        let mut motion = Motion::new(&constants, States::Stuck(set.clone(), NO_TUBE), 1);
        motion.slow_without_flow(&set, &last, None).unwrap();
        let rates = |[x, y]: [f64; 2]| {
            let state_rate = slider.state_rate(x, y);
            [-libm::expm1(x) - 0.5 * state_rate, state_rate]
        };
        let normal = rates([0.0, -1.0]);
        let mut stresses = Vec::new();
        for sign in [1.0, -1.0] {
            let mut state = [0.0, -1.0 + sign * 0.04];
            stresses.push(state[0] + 0.5 * state[1]);
            // To the plane, by many steps of the midpoint rule.
            for left in (1..=1000).rev() {
                let distance = normal[0] * state[0] + normal[1] * (state[1] + 1.0);
                let step =
                    |by: [f64; 2]| -distance / (normal[0] * by[0] + normal[1] * by[1]) / f64::from(left);
                let first = rates(state);
                let half = 0.5 * step(first);
                let middle = rates([state[0] + half * first[0], state[1] + half * first[1]]);
                let whole = step(middle);
                state = [state[0] + whole * middle[0], state[1] + whole * middle[1]];
            }
            stresses.push(state[0] + 0.5 * state[1]);
        }
        let [_, drop] = motion.observed.stress_drop();
        let at_start = range(&[stresses[0], stresses[2]]);
        assert!(range(&stresses) > at_start + 1e-5, "{law:?} {stresses:?}");
        assert!(drop >= range(&stresses) - 1e-7, "{law:?} {drop} {stresses:?}");
    }
}
