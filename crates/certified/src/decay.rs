//! A decay: the enclosed run from the start, until it is inside an ellipsoid or a cone that steady sliding attracts.

use crate::attraction::Ellipsoid;
use crate::interval::{Interval, generously_up, worse};
use crate::manifold::Manifold;
use crate::motion::{Motion, States};
use crate::observed::Observed;
use crate::set::{COORDINATES, Set};
use crate::sticking::ENTRY_DELAY;
use crate::{Certificate, Constants, MOST_STEPS, Proved, Reason, Units};
use slipmode_core::dynamics::Start;

/// What follows a run is no longer enclosed when it changes ln V and ζ by less.
const NEGLIGIBLE: f64 = 1e-9;

/// Steps that a decay takes in the time of inertia, times η.
const STEPS: f64 = 10.0;
/// Where these are too many and the delay by inertia at steady sliding is below `LATEST` times that of the entry of the slow manifold, the
/// manifold is entered at `LATE` times the delay at steady sliding.
const LATEST: f64 = 16.0;
const LATE: f64 = 4.0;

/// Certifies that the run from V = V_l/10 decays.
pub(super) fn certify(constants: &Constants, start: Start, units: &Units) -> Result<Certificate, Reason> {
    let ellipsoid = Ellipsoid::around_steady_sliding(constants).ok_or(Reason::NoAttraction)?;
    let state = start_state(constants, start);
    let set = Set::new([Interval::ZERO; COORDINATES], state, [[Interval::ZERO; COORDINATES]; 3]);
    let mut motion = Motion::new(constants, States::Inertial(set), MOST_STEPS);
    // The slider may stick before x has fallen.
    motion.has_fallen = true;
    let at_rest = Manifold::over(constants, &[Interval::ZERO; 2]).delay() / ENTRY_DELAY;
    let steps_of_inertia = STEPS / constants.inertia.mid;
    if steps_of_inertia > MOST_STEPS as f64 && at_rest > 1.0 && at_rest < LATEST {
        motion.lateness = LATE * at_rest;
    }
    // The stress of the limit, steady sliding, counts too; its velocity is approached.
    motion.observed.state(Interval::ZERO, Interval::ZERO);
    let observed = loop {
        if let Some(observed) = completed(&motion, &ellipsoid) {
            break observed;
        }
        motion.advance(None)?;
    };
    Ok(Certificate {
        proved: Proved::Decay { captured_after_s: units.duration(observed.duration)[1] },
        peak_velocity_m_per_s: units.peak(observed.peak()),
        stress_drop_pa: units.drop(observed.stress_drop()),
    })
}

/// What the whole motion shows, if what follows from here on cannot widen the enclosures by more than [`NEGLIGIBLE`].
fn completed(motion: &Motion<'_>, ellipsoid: &Ellipsoid) -> Option<Observed> {
    let bounds = captured(motion, ellipsoid)?;
    let seen = motion.observed.least_extremes();
    let are_seen = bounds.iter().zip(seen).all(|(bound, seen)| *bound <= worse(seen, NEGLIGIBLE));
    are_seen.then(|| motion.observed.clone().with_rest(bounds))
}

/// x, y and F/η of all states.
fn coordinates(motion: &Motion<'_>) -> [Interval; 3] {
    match &motion.states {
        States::Inertial(set) => {
            let [x, y, force] = set.hull();
            [x, y, force * motion.constants.inertia.reciprocal()]
        }
        States::Stuck(set, tube) => {
            let [x, y] = set.hull();
            let rate = Manifold::over(motion.constants, &[x, y]).rate.widened(tube.distance);
            [x, y, x.exp() * rate]
        }
    }
}

/// x, ζ and −ζ as linear forms of x, y and F/η.
fn extremes(constants: &Constants) -> [[Interval; 3]; 3] {
    let stress = [Interval::ONE, constants.effect_ratio, constants.inertia];
    [[Interval::ONE, Interval::ZERO, Interval::ZERO], stress, stress.map(|c| -c)]
}

/// Bounds of x, ζ and −ζ from here on, when every state lies inside the ellipsoid or a cone.
fn captured(motion: &Motion<'_>, ellipsoid: &Ellipsoid) -> Option<[f64; 3]> {
    let z = coordinates(motion);
    // Nearly along the slowest mode x and ζ keep their signs.
    if let Some(cone) = ellipsoid.cone(motion.constants, &z) {
        return Some(extremes(motion.constants).map(|form| cone.largest(&form)));
    }
    let [x, y, w] = ellipsoid.reach_from(&z)?;
    let Constants { inertia, effect_ratio, .. } = motion.constants;
    let stress = generously_up(x + effect_ratio.magnitude() * y + inertia.magnitude() * w);
    Some([x, stress, stress])
}

/// x, y and F at V = V_l/10.
fn start_state(constants: &Constants, start: Start) -> [Interval; 3] {
    // The constant is ln 10 rounded to nearest, below 4: its error is at most 2^-52.
    let x = -Interval { mid: std::f64::consts::LN_10, rad: f64::EPSILON };
    let zero = Interval::ZERO;
    match start {
        Start::SteadyAtVelocity => [x, -x, zero],
        Start::SteadyStateSpringAtLoading => [x, -x, (constants.effect_ratio - Interval::ONE) * x],
        Start::VelocityStepInEquilibrium => [x, zero, zero],
        Start::VelocityKick => [x, zero, -x],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifold::Tube;
    use crate::tests::members::Slider;
    use rug::Float;
    use slipmode_core::dynamics::Model;
    use slipmode_core::friction::{EvolutionLaw, Groups, ParameterBox, Parameters};
    use slipmode_core::number::Rational;
    use slipmode_core::number::split_mix::SplitMix64;

    /// What is bounded when a run is captured, by a cone or by an ellipsoid, holds what single motions reach afterwards.
    #[test]
    fn the_bounds_of_a_captured_run_hold_what_follows() {
        let mut captures = 0;
        for law in EvolutionLaw::ALL {
            for (inertia, stiffness, is_stuck) in [
                (0.5, 1.5, false),
                (20.0, 20.0, false),
                (0.01, 20.0, false),
                (0.01, 20.0, true),
                (0.01, 0.7, true),
            ] {
                let slider = Slider { inertia, stiffness, effect_ratio: 1.5, law };
                let constants = slider.constants();
                let ellipsoid = Ellipsoid::around_steady_sliding(&constants).unwrap();
                for direction in
                    [[1.0, 0.3, 0.5], [-1.0, 0.5, 0.4], [0.1, -1.0, -0.3], [0.0, 0.1, 1.0], [0.0, 0.1, -1.0]]
                {
                    let captured_at = |size: f64| {
                        let [x, y, force] = direction.map(|c| Interval::point(size * c));
                        let (none, force) = ([Interval::ZERO; COORDINATES], force * constants.inertia);
                        let states = if is_stuck {
                            let tube =
                                Tube { distance: size * direction[2].abs(), slopes: [0.0; COORDINATES] };
                            States::Stuck(Set::new(none, [x, y], [none; 2]), tube)
                        } else {
                            States::Inertial(Set::new(none, [x, y, force], [none; 3]))
                        };
                        let motion = Motion::new(&constants, states, 1);
                        let force = if is_stuck {
                            let manifold = Manifold::over(&constants, &[x, y]);
                            (manifold.inertia * (manifold.rate + Interval::point(size * direction[2]))).mid
                        } else {
                            force.mid
                        };
                        Some((captured(&motion, &ellipsoid)?, [x.mid, y.mid, force]))
                    };
                    let sizes = [1.0, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-5];
                    let Some((bounds, state)) = sizes.into_iter().find_map(captured_at) else { continue };
                    captures += 1;
                    let mut member = slider.member(state);
                    for _ in 0..2000 {
                        member = slider.step(member, 0.05);
                    }
                    let [x, highest, lowest] = member.largest;
                    let holds = |bound: f64, value: f64| value <= bound * (1.0 + 1e-9) + 1e-15;
                    assert!(holds(bounds[0], x), "{slider:?} {state:?} {x} {}", bounds[0]);
                    assert!(holds(bounds[1], highest), "{slider:?} {state:?} {highest} {}", bounds[1]);
                    assert!(holds(bounds[2], lowest), "{slider:?} {state:?} {lowest} {}", bounds[2]);
                }
            }
        }
        assert!(captures > 30, "{captures}");
    }

    /// The start is that of the simulation, and ln 10 lies inside its x.
    #[test]
    fn each_start_is_enclosed() {
        let slider = Slider { inertia: 0.5, stiffness: 1.5, effect_ratio: 1.5, law: EvolutionLaw::Slip };
        let groups = Groups { inertial_parameter: 0.5, stiffness_group: 1.5, effect_ratio: 1.5 };
        let model = Model::new(groups, slider.law);
        for start in Start::ALL {
            let enclosed = start_state(&slider.constants(), start);
            let [x, y, zeta] = start.at_a_tenth(&model);
            let expected = [x, y, zeta - x - 1.5 * y];
            assert!(
                (0..3).all(|i| enclosed[i].widened(1e-15).may_contain(expected[i])),
                "{start:?} {enclosed:?}"
            );
            let exact = -Float::with_val(400, 10).ln();
            assert!((exact - enclosed[0].mid).abs() <= enclosed[0].rad);
        }
    }

    /// Wide sets of either description, at random sliders: where a set is captured, each of its states lies within the bounds itself, and
    /// lies in the ellipsoid, as a point of the whole slider.
    #[test]
    fn a_captured_set_holds_all_of_its_states() {
        let mut random = SplitMix64(31);
        let (mut captures, mut by_cone) = ([0; 2], 0);
        for case in 0..3000 {
            let law = EvolutionLaw::ALL[case % 2];
            let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
            let slider = Slider {
                inertia: libm::pow(10.0, number(-3.0, 1.5)),
                stiffness: libm::pow(10.0, number(-0.5, 1.5)),
                effect_ratio: libm::pow(10.0, number(-1.0, 1.0)),
                law,
            };
            let constants = slider.constants();
            let Some(ellipsoid) = Ellipsoid::around_steady_sliding(&constants) else { continue };
            // In one coordinate or in all.
            let along = case % 4;
            let direction: [f64; 3] =
                std::array::from_fn(|i| if along == 3 || along == i { number(-1.0, 1.0) } else { 0.0 });
            let widths: [f64; 3] = std::array::from_fn(|_| number(-0.5, 1.0).max(0.0));
            let is_stuck = case % 3 == 0;
            let (steps, by) = if case % 12 == 0 { (240, 0.05) } else { (24, 0.5) };
            for scale in (0..steps).map(|k| libm::pow(10.0, 1.0 - by * f64::from(k))) {
                let at = direction.map(|c| scale * c);
                let radius: [f64; 3] = std::array::from_fn(|i| scale * widths[i]);
                let none = [Interval::ZERO; COORDINATES];
                let sides = |i: usize| Interval { mid: at[i], rad: radius[i] };
                // ψ, of either sign, in the place of w.
                let tube = Tube { distance: at[2].abs() + radius[2], slopes: [0.0; COORDINATES] };
                let states = if is_stuck {
                    States::Stuck(Set::new(none, [sides(0), sides(1)], [none; 2]), tube)
                } else {
                    let force = sides(2) * constants.inertia;
                    States::Inertial(Set::new(none, [sides(0), sides(1), force], [none; 3]))
                };
                let motion = Motion::new(&constants, states, 1);
                let Some(bounds) = captured(&motion, &ellipsoid) else { continue };
                captures[usize::from(is_stuck)] += 1;
                by_cone += usize::from(bounds[1] != bounds[2]);
                for corner in 0..9_u32 {
                    let sign = |i: u32| {
                        if corner == 8 {
                            0.0
                        } else if corner >> i & 1 == 0 {
                            1.0
                        } else {
                            -1.0
                        }
                    };
                    let [x, y] = [at[0] + sign(0) * radius[0], at[1] + sign(1) * radius[1]];
                    let force = if is_stuck {
                        let manifold = Manifold::over(&constants, &[x, y].map(Interval::point));
                        slider.inertia * libm::exp(x) * (manifold.rate.mid + sign(2) * tube.distance)
                    } else {
                        slider.inertia * (at[2] + sign(2) * radius[2])
                    };
                    let stress = force + x + slider.effect_ratio * y;
                    let holds = |bound: f64, value: f64| value <= bound * (1.0 + 1e-9) + 1e-15;
                    assert!(holds(bounds[0], x), "{slider:?} {at:?} {radius:?} {x} {}", bounds[0]);
                    assert!(holds(bounds[1], stress), "{slider:?} {at:?} {stress} {}", bounds[1]);
                    assert!(holds(bounds[2], -stress), "{slider:?} {at:?} {stress} {}", bounds[2]);
                    // A hair inside, for the rounding of this state.
                    let inside = [x, y, force].map(|c| Interval::point(c * (1.0 - 1e-9)));
                    let state = [inside[0], inside[1], inside[2] * constants.inertia.reciprocal()];
                    let is_inside = ellipsoid.reach_from(&state).is_some();
                    // A cone bounds ζ from both sides by different numbers.
                    assert!(is_inside || bounds[1] != bounds[2], "{slider:?} {at:?} {radius:?} {corner}");
                }
                break;
            }
        }
        assert!(captures[0] > 500 && captures[1] > 200 && by_cone > 50, "{captures:?} {by_cone}");
    }

    /// States that are captured before anything but steady sliding is seen: what follows them counts, of each sign.
    #[test]
    fn what_follows_a_run_is_counted() {
        let mut by_cone = 0;
        for law in EvolutionLaw::ALL {
            for (inertia, stiffness) in [(0.5, 1.5), (20.0, 20.0), (0.01, 20.0), (0.1, 10.0)] {
                let slider = Slider { inertia, stiffness, effect_ratio: 1.5, law };
                let constants = slider.constants();
                let ellipsoid = Ellipsoid::around_steady_sliding(&constants).unwrap();
                // The slowest mode, where all are real: from anywhere after a while.
                let mut slowest = slider.member([1e-3, 1e-3, 0.0]);
                (0..4000).for_each(|_| slowest = slider.step(slowest, 0.02));
                let [x, y, force, _] = slowest.state;
                let along = [x, y, force].map(|c| c / x.abs().max(1e-300));
                for direction in [[1.0, 0.3, 0.5], [-1.0, 0.5, 0.4], [0.0, 0.1, -1.0], along] {
                    for size in [1e-11, -1e-11] {
                        let state = direction.map(|c| size * c);
                        let set = Set::new(
                            [Interval::ZERO; 2],
                            state.map(Interval::point),
                            [[Interval::ZERO; 2]; 3],
                        );
                        let mut motion = Motion::new(&constants, States::Inertial(set), 1);
                        motion.observed.state(Interval::ZERO, Interval::ZERO);
                        let [_, highest, lowest] = captured(&motion, &ellipsoid).unwrap();
                        by_cone += usize::from(highest != lowest);
                        let observed = completed(&motion, &ellipsoid).unwrap();
                        let mut member = slider.member(state);
                        (0..4000).for_each(|_| member = slider.step(member, 0.02));
                        let [x, highest, lowest] = member.largest.map(|c| c.max(0.0));
                        let holds = |bound: f64, value: f64| value <= bound * (1.0 + 1e-4) + 1e-15;
                        assert!(holds(observed.peak()[1], x), "{slider:?} {state:?} {x} {observed:?}");
                        let drop = observed.stress_drop()[1];
                        assert!(
                            holds(drop, highest + lowest),
                            "{slider:?} {state:?} {highest} {lowest} {drop}"
                        );
                        // Each end counts alone.
                        let [above, below] = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]
                            .map(|rest| observed.clone().with_rest(rest).stress_drop()[1] - 1.0);
                        assert!(above >= highest - 1e-14 && below >= lowest - 1e-14, "{slider:?} {state:?}");
                    }
                }
            }
        }
        assert!(by_cone >= 8, "{by_cone}");
    }

    /// x, y and F/η of wide sets hold those of each state, and the forms are x, ζ and −ζ.
    #[test]
    fn coordinates_and_forms_are_those_of_each_state() {
        let mut random = SplitMix64(37);
        for case in 0..200 {
            let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
            let law = EvolutionLaw::ALL[case % 2];
            let slider =
                Slider { inertia: 0.01, stiffness: number(0.1, 5.0), effect_ratio: number(0.3, 3.0), law };
            let constants = slider.constants();
            let (at, rad) = ([number(-2.0, 1.0), number(-1.0, 1.0)], [0.05, 0.2][case % 2]);
            let along = [[1.0, 0.0], [0.0, 1.0]].map(|row| row.map(Interval::point));
            let tube = Tube { distance: 0.1, slopes: [0.0; COORDINATES] };
            let set = Set::new([Interval::symmetric(rad); 2], at.map(Interval::point), along);
            let stuck = Motion::new(&constants, States::Stuck(set, tube), 1);
            let z = coordinates(&stuck);
            let force = number(-1.0, 1.0);
            let along = [along[0], along[1], [Interval::ZERO; 2]];
            let set =
                Set::new([Interval::symmetric(rad); 2], [at[0], at[1], force].map(Interval::point), along);
            let whole = coordinates(&Motion::new(&constants, States::Inertial(set), 1));
            let holds = |c: Interval, value: f64| c.widened(1e-12 * (1.0 + value.abs())).may_contain(value);
            for signs in [[0.0; 2], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                let [x, y] = std::array::from_fn(|i| at[i] + signs[i] * rad);
                let rate = Manifold::over(&constants, &[x, y].map(Interval::point)).rate.mid;
                for psi in [0.1, -0.1] {
                    let w = libm::exp(x) * (rate + psi);
                    assert!([x, y, w].into_iter().zip(z).all(|(value, c)| holds(c, value)), "{z:?} {w}");
                }
                let w = force / slider.inertia;
                assert!([x, y, w].into_iter().zip(whole).all(|(value, c)| holds(c, value)), "{whole:?}");
                let stress = force + x + slider.effect_ratio * y;
                let found =
                    extremes(&constants).map(|form| form[0].mid * x + form[1].mid * y + form[2].mid * w);
                let near = |i: usize, value: f64| (found[i] - value).abs() < 1e-12 * (1.0 + value.abs());
                assert!(near(0, x) && near(1, stress) && near(2, -stress), "{found:?} {x} {stress}");
            }
        }
    }

    /// Runs that have come near the slowest mode: x and ζ of the state lie within the bounds of its cone, in which F counts as well.
    #[test]
    fn the_bounds_near_the_slowest_mode_hold_the_state() {
        let mut by_cone = 0;
        for (law, direction) in EvolutionLaw::ALL.into_iter().flat_map(|law| [(law, 1.0), (law, -1.0)]) {
            for inertia in [0.01, 0.1, 0.5, 2.0] {
                for stiffness in [6.0, 10.0, 20.0, 60.0, 200.0] {
                    let slider = Slider { inertia, stiffness, effect_ratio: 1.5, law };
                    let constants = slider.constants();
                    let Some(ellipsoid) = Ellipsoid::around_steady_sliding(&constants) else { continue };
                    let mut member = slider.member([0.05 * direction, 0.1 * direction, 0.0]);
                    for step in 0..20_000 {
                        member = slider.step(member, 0.02);
                        if step % 50 != 0 {
                            continue;
                        }
                        let [x, y, force, _] = member.state;
                        let none = [Interval::ZERO; COORDINATES];
                        let set = Set::new(none, [x, y, force].map(Interval::point), [none; 3]);
                        let Some(bounds) =
                            captured(&Motion::new(&constants, States::Inertial(set), 1), &ellipsoid)
                        else {
                            continue;
                        };
                        if bounds[1] == bounds[2] {
                            continue;
                        }
                        by_cone += 1;
                        let stress = force + x + 1.5 * y;
                        let holds = |bound: f64, value: f64| value <= bound * (1.0 + 1e-9) + 1e-16;
                        assert!(holds(bounds[0], x), "{slider:?} {member:?} {}", bounds[0]);
                        assert!(holds(bounds[1], stress), "{slider:?} {stress} {}", bounds[1]);
                        assert!(holds(bounds[2], -stress), "{slider:?} {stress} {}", bounds[2]);
                        if x.abs() < 1e-9 {
                            break;
                        }
                    }
                }
            }
        }
        assert!(by_cone > 20, "{by_cone}");
    }

    /// Decays from each start against single motions: the largest velocity and the range of the spring stress count the start and the limit, and
    /// the time of the capture is that of the slowest unit of time.
    #[test]
    fn a_decay_counts_its_start_and_its_limit() {
        let parameters = |velocity: (u32, u32)| {
            let [a, b, d, k, m, s] = [(1, 1), (3, 2), (1, 1), (20, 1), (1, 100), (1, 1)].map(Rational::from);
            Parameters::from([a, b, d, k, m, s, Rational::from(velocity)])
        };
        let slow = ParameterBox::of(parameters((9, 10))).unwrap();
        let both = ParameterBox::new(parameters((9, 10)), parameters((11, 10))).unwrap();
        let [slow, both] = [&slow, &both].map(Units::over);
        for (law, start) in EvolutionLaw::ALL.into_iter().flat_map(|law| Start::ALL.map(|start| (law, start)))
        {
            for (inertia, stiffness) in [(0.5, 4.0), (0.2, 20.0), (1.0, 6.0)] {
                let slider = Slider { inertia, stiffness, effect_ratio: 1.5, law };
                let constants = slider.constants();
                let [alone, over] = [&slow, &both].map(|units| certify(&constants, start, units).unwrap());
                let after = |found: &Certificate| match found.proved {
                    Proved::Decay { captured_after_s } => captured_after_s,
                    Proved::Cycle { .. } => f64::NAN,
                };
                assert!(after(&over) >= after(&alone) * (1.0 - 1e-12), "{over:?} {alone:?}");
                let mut member = slider.member(start_state(&constants, start).map(|c| c.mid));
                while member.state[3] < 30.0 {
                    member = slider.step(member, 0.002);
                }
                let [x, highest, lowest] = member.largest.map(|c| c.max(0.0));
                let near = |[low, high]: [f64; 2], value: f64| {
                    // The single motion's maxima lie between its steps.
                    let error = 1e-7 * value;
                    low <= value + error && value - error <= high && high - low < 1e-5 * value
                };
                assert!(
                    near(alone.stress_drop_pa, highest + lowest),
                    "{slider:?} {start:?} {alone:?} {}",
                    highest + lowest
                );
                assert!(
                    near(alone.peak_velocity_m_per_s, 0.9 * libm::exp(x)),
                    "{slider:?} {start:?} {alone:?} {x}"
                );
            }
        }
    }
}
