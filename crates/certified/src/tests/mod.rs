//! Certificates against references of quadruple precision and the simulator, and planted faults that no certificate survives.

pub(super) mod exact;
pub(super) mod members;
mod planted;
mod short_time;
mod steps;
mod wide_sets;

use super::cycle::Test;
use super::interval::Interval;
use super::*;
use slipmode_core::dynamics::simulate;
use slipmode_core::number::parse_decimal;

const REFERENCES: &str = include_str!("../estimated-errors.txt");

fn parameters(texts: [&str; 7]) -> Parameters<Rational> {
    Parameters::from(texts.map(|text| parse_decimal(text).unwrap()))
}

/// The paper's slider.
fn paper(normal_stress: &str, velocity: &str) -> Parameters<Rational> {
    parameters(["0.004", "0.006", "1e-5", "1e7", "1000", normal_stress, velocity])
}

/// Inertial and quasi-static vibration, and stick-slip.
const CYCLES: [[&str; 2]; 3] = [["1e4", "1e-2"], ["3e4", "1e-3"], ["1e5", "1e-3"]];

#[test]
fn enclosures_contain_references_of_quadruple_precision() {
    // The references that lose enough energy in a return for a certificate.
    const CERTIFIED: [&str; 8] = [
        "slip,0.0116,8.504e+10,",
        "slip,0.01188,1.638e+10,",
        "aging,0.01188,1.638e+10,",
        "slip,0.01679,1.418e+11,",
        "slip,0.011,1.034e+08,",
        "aging,0.011,1.034e+08,",
        "slip,0.01332,1.771e+11,",
        "aging,0.01332,1.771e+11,",
    ];
    let is_certified = |line: &&str| CERTIFIED.iter().any(|start| line.starts_with(start));
    let lines: Vec<&str> = REFERENCES.lines().filter(is_certified).collect();
    assert_eq!(lines.len(), CERTIFIED.len());
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let law = EvolutionLaw::ALL.into_iter().find(|law| law.as_str() == cells[0]).unwrap();
        let slider = parameters(["0.01", cells[1], "1e-5", cells[2], cells[3], "1e6", "1"]);
        let found = certify(&slider, law, Start::default()).unwrap();
        let Proved::Cycle { period_s, .. } = found.proved else { panic!("{line}: {found:?}") };
        let number = |i: usize| cells[i].parse::<f64>().unwrap();
        let holds = |[low, high]: [f64; 2], reference: f64, error: f64| {
            // Units and the exponential add three roundings to the reference.
            let error = error + 1e-15 * reference;
            low <= reference + error && reference - error <= high && high - low < 1e-6 * reference
        };
        let peak = libm::exp(number(5));
        assert!(holds(found.peak_velocity_m_per_s, peak, peak * number(6)), "{line}: {found:?}");
        assert!(holds(found.stress_drop_pa, 1e4 * number(9), 1e4 * number(10)), "{line}: {found:?}");
        assert!(holds(period_s, 1e-5 * number(11), 1e-5 * number(12)), "{line}: {found:?}");
    }
}

#[test]
fn enclosures_of_stick_slip_agree_with_the_simulator() {
    for law in EvolutionLaw::ALL {
        for [stress, velocity] in CYCLES {
            let slider = paper(stress, velocity);
            let found = certify(&slider, law, Start::default()).unwrap();
            let simulated = simulate(&slider, law, &Options::at(1e-9)).unwrap();
            let agrees = |[low, high]: [f64; 2], value: f64, error: f64| {
                low <= value * (1.0 + error) && value * (1.0 - error) <= high && high / low - 1.0 < 1e-6
            };
            let Proved::Cycle { period_s, contraction, .. } = found.proved else { panic!("{found:?}") };
            assert!(contraction < 1.0);
            let (peak, peak_error) = (simulated.peak_velocity_m_per_s, simulated.peak_relative_error);
            assert!(agrees(found.peak_velocity_m_per_s, peak, peak_error), "{found:?} {peak:e}");
            let (period, error) = (simulated.period_s.unwrap(), simulated.period_relative_error.unwrap());
            assert!(agrees(period_s, period, error), "{found:?} {period:e}");
        }
    }
}

#[test]
fn decays_are_certified_and_enclose_the_largest_velocity() {
    for [stress, velocity] in [["1e3", "3e-4"], ["1e4", "1e-4"], ["316.2278", "1e-5"]] {
        for law in EvolutionLaw::ALL {
            let slider = paper(stress, velocity);
            let found = certify(&slider, law, Start::default()).unwrap();
            assert!(matches!(found.proved, Proved::Decay { .. }), "{found:?}");
            let [low, high] = found.peak_velocity_m_per_s;
            let simulated = simulate(&slider, law, &Options::at(1e-9)).unwrap();
            let error = 1e-9 + simulated.peak_relative_error;
            let peak = simulated.peak_velocity_m_per_s;
            assert!(low <= peak * (1.0 + error) && peak * (1.0 - error) <= high, "{found:?} {peak:e}");
        }
    }
}

/// A stiff slider, whose inertia delays it little, and a cycle whose velocity is least where a step ends.
#[test]
fn slow_sliders_are_certified_within_few_steps() {
    let decay = certify(&paper("1e3", "1e-6"), EvolutionLaw::Aging, Start::default()).unwrap();
    assert!(matches!(decay.proved, Proved::Decay { .. }), "{decay:?}");
    let cycle = certify(&paper("177827.9", "1e-6"), EvolutionLaw::Aging, Start::default()).unwrap();
    assert!(matches!(cycle.proved, Proved::Cycle { .. }), "{cycle:?}");
    // From the ordinary simulation, to seven digits.
    for (found, simulated) in [(&decay, 1.055_258e-6), (&cycle, 6.219_542e-2)] {
        let [low, high] = found.peak_velocity_m_per_s;
        assert!(low <= simulated * (1.0 + 1e-6) && simulated * (1.0 - 1e-6) <= high, "{found:?}");
        assert!(high / low - 1.0 < 1e-9, "{found:?}");
    }
}

/// Bounds over a box of all seven values hold those of corners and of a slider inside, and not those of one outside.
#[test]
fn bounds_over_a_box_hold_those_of_each_slider() {
    /// In parts of 10⁻⁹: bounds over a box are about a thousand times as wide as the box.
    const FAR: i32 = 100_000;
    let moved = |slider: &Parameters<Rational>, parts: [i32; 7]| {
        let values: [Rational; 7] = slider.clone().into();
        let step = Rational::from((1, 1_000_000_000));
        let moved = |i: usize| values[i].clone() * (1 + step.clone() * parts[i]);
        Parameters::from(std::array::from_fn::<_, 7, _>(moved))
    };
    let holds = |[low, high]: [f64; 2], [least, largest]: [f64; 2]| low < least && largest < high;
    for ([stress, velocity], is_cycle) in [(["3e4", "1e-3"], true), (["1e4", "1e-4"], false)] {
        let slider = paper(stress, velocity);
        let region = ParameterBox::new(moved(&slider, [-2; 7]), moved(&slider, [2; 7])).unwrap();
        for law in EvolutionLaw::ALL {
            let over = certify_over(&region, law, Start::default()).unwrap();
            assert_eq!(over.period_s().is_some(), is_cycle);
            let inside = [[-2, 2, -2, -2, 2, 2, 2], [2, -2, 2, 2, -2, -2, -2], [1, 0, -1, 2, -2, 1, 0]];
            let outside = [[0, FAR, 0, 0, 0, 0, 0], [0, 0, 0, -FAR, 0, 0, 0], [0, 0, 0, 0, 0, 0, FAR]];
            for (parts, is_inside) in
                inside.map(|parts| (parts, true)).into_iter().chain(outside.map(|parts| (parts, false)))
            {
                let found = certify(&moved(&slider, parts), law, Start::default()).unwrap();
                let peak = holds(over.peak_velocity_m_per_s, found.peak_velocity_m_per_s);
                let drop = holds(over.stress_drop_pa, found.stress_drop_pa);
                let period = over.period_s().zip(found.period_s());
                let all = peak && drop && period.is_none_or(|(over, found)| holds(over, found));
                assert_eq!(all, is_inside, "{parts:?} {over:?} {found:?}");
            }
        }
    }
}

/// Seven faults for each of three cycles: the test of the box that was proved without fault refuses all of them.
#[test]
fn a_box_of_the_right_cycle_is_refused_after_each_planted_fault() {
    let mut refused = 0;
    for law in EvolutionLaw::ALL {
        for [stress, velocity] in CYCLES {
            let groups = paper(stress, velocity).groups();
            let model = Model::new(groups.clone().map(nearest_f64), law);
            let found = simulate_model(&model, &Options::at(1e-8)).unwrap();
            let LongTerm::Cycle(cycle) = found.long_term() else { panic!("no cycle at {stress} {velocity}") };
            let right = Constants::of(&groups, law);
            let (test, ..) = Test::near(&right, &model, cycle).unwrap();
            assert!(test.holds(&right), "{law:?} {stress} {velocity}");
            // Twice as many steps round more often.
            assert!(test.altered(0.0, 4.0).with_short_steps().holds(&right), "{law:?} {stress} {velocity}");
            let scaled = |value: Interval, by: f64| value * Interval::point(by);
            let other = EvolutionLaw::ALL.into_iter().find(|other| *other != law).unwrap();
            let wrong = [
                Constants { law: other, ..right },
                Constants { inertia: scaled(right.inertia, 1.0 + 1e-9), ..right },
                Constants { stiffness: scaled(right.stiffness, 1.0 + 1e-9), ..right },
                Constants { effect_ratio: scaled(right.effect_ratio, 1.0 + 1e-9), ..right },
                Constants { effect_ratio: -right.effect_ratio, ..right },
            ];
            refused += wrong.iter().filter(|wrong| !test.holds(wrong)).count();
            let altered = [test.altered(1e-9, 1.0), test.altered(0.0, 1e-4)];
            refused += altered.iter().filter(|altered| !altered.holds(&right)).count();
        }
    }
    assert_eq!(refused, 7 * 2 * CYCLES.len());
}

/// A cycle is proved again from its stated box, and not from a part of the box, from one beside it, or from one without an end.
#[test]
fn only_a_box_that_returns_into_itself_proves_a_cycle_again() {
    let slider = paper("1e4", "1e-2");
    for law in EvolutionLaw::ALL {
        let prove = |stated: &Proved| prove_again(&slider, law, Start::default(), stated);
        let found = certify(&slider, law, Start::default()).unwrap();
        let again = prove(&found.proved).unwrap();
        assert!(again.period_s().is_some());
        let Proved::Cycle { state_box, second_box, .. } = found.proved.clone() else { panic!("{found:?}") };
        let with = |boxes: [[f64; 2]; 2]| {
            let mut stated = found.proved.clone();
            if let Proved::Cycle { state_box, second_box, .. } = &mut stated {
                [*state_box, *second_box] = boxes;
            }
            stated
        };
        let widths = [state_box, second_box].map(|[low, high]| high - low);
        let scaled = |part: f64, moved: f64| {
            with(std::array::from_fn(|i| {
                let [low, high] = [state_box, second_box][i];
                let middle = 0.5 * (low + high) + moved * widths[i];
                [middle - 0.5 * part * widths[i], middle + 0.5 * part * widths[i]]
            }))
        };
        assert!(prove(&scaled(1.5, 0.0)).is_ok());
        for wrong in [
            scaled(1e-3, 0.0),
            scaled(1.0, 10.0),
            scaled(1.0, -10.0),
            scaled(-1.0, 0.0),
            scaled(f64::NAN, 0.0),
        ] {
            assert!(prove(&wrong).is_err(), "{law:?} {wrong:?}");
        }
    }
}
