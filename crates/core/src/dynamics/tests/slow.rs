//! Runs whose amplitude changes by less in a return than f64 resolves: large η, and both sides of K = K_c.

use crate::dynamics::Behaviour;
use crate::dynamics::integrator::{Control, Integrator};
use crate::dynamics::long_term::{Cycle, LongTerm};
use crate::dynamics::section_return::{Return, next_return};
use crate::dynamics::slow_pair::{Pace, SlowPair};
use crate::dynamics::small_cycle::small_cycle;
use crate::dynamics::{Failure, Model, Options, Radau, Start, simulate, simulate_model};
use crate::friction::{EvolutionLaw, Groups, Parameters, critical_stiffness_group};
use crate::number::{Dd, Rational, parse_decimal};

/// A slider with these η, β and K/K_c, whose D_c/V_l, V_l and aσ are 1.
fn slider(eta: &str, beta: &str, ratio: &Rational) -> Parameters<Rational> {
    let [eta, beta] = [eta, beta].map(|text| parse_decimal(text).unwrap());
    let stiffness = critical_stiffness_group(&beta, &eta) * ratio;
    let one = Rational::from(1);
    Parameters::from([one.clone(), beta, one.clone(), stiffness, eta, one.clone(), one])
}

/// 1 + 10^exponent, or 1 − 10^exponent.
fn next_to_one(above: bool, exponent: i32) -> Rational {
    let distance = parse_decimal(&format!("1e{exponent}")).unwrap();
    if above { 1 + distance } else { 1 - distance }
}

fn model_of(slider: &Parameters<Rational>, law: EvolutionLaw) -> Model<f64> {
    Model::new(slider.groups().map(crate::number::nearest_f64), law)
}

/// The first returns in double-double by Radau IIA of order 13.
fn first_returns(model: &Model<f64>, start: Start) -> Return<f64> {
    let model = Model::new(model.groups().map(|&group| Dd::from(group)), model.law());
    let start = start.at_a_tenth(&model);
    let control = Control { local_tolerance: 1e-20, most_steps: 100_000 };
    let mut run = Integrator::new(&model, Radau::<Dd, 7>::new(), start, control).unwrap();
    let mut next = || next_return(&mut run).unwrap().0;
    next().joined(next()).joined(next()).rounded()
}

#[test]
fn vibrations_decay_at_any_inertia_and_their_extremes_are_those_of_double_double() {
    for (beta, ratio) in [("1.5", 2.0), ("1.1", 10.0), ("5", 1.01), ("1.5", 1.0001)] {
        for (eta, law) in
            ["1e8", "1e12", "1e16"].into_iter().flat_map(|eta| EvolutionLaw::ALL.map(|law| (eta, law)))
        {
            let slider = slider(eta, beta, &Rational::from_f64(ratio).unwrap());
            let outcome = simulate_model(&model_of(&slider, law), &Options::at(1e-8)).unwrap();
            assert!(matches!(outcome.long_term(), LongTerm::Decay(_)), "{eta} {beta} {law:?}");
            assert!(outcome.steps() < 2_000, "{eta} {beta} {law:?}: {}", outcome.steps());
            let found = outcome.in_si(&slider.map(crate::number::nearest_f64));
            let exact = first_returns(&model_of(&slider, law), Start::default());
            let peak = libm::expm1(outcome.log_peak() - exact.peak).abs();
            let drop = found.stress_drop_pa / (exact.highest_stress - exact.lowest_stress) - 1.0;
            assert!(peak <= found.peak_relative_error && found.peak_relative_error <= 1e-8);
            assert!(drop.abs() <= found.stress_drop_relative_error, "{eta} {beta} {law:?}: {drop:e}");
        }
    }
}

/// η, κ, β, law and start of decays whose stress swings by up to 3e7 times as much as ln V.
fn stiff_decays() -> Vec<(Groups<f64>, EvolutionLaw, Start)> {
    let groups = [
        [50.0, 70.0, 1.5],
        [763.0, 5_740.0, 1.658],
        [1e3, 2e3, 0.8],
        [1e4, 3e5, 1.1],
        [2.29e5, 691_650.0, 1.106],
        [3.34e5, 6.55e6, 0.817],
        [5.04e6, 2.13e8, 1.899],
        // A mode that relaxes slowly.
        [1e7, 5e3, 0.6],
        [2e5, 50.0, 0.6],
    ];
    let starts =
        [Start::SteadyAtVelocity, Start::SteadyStateSpringAtLoading, Start::VelocityStepInEquilibrium];
    let cases = groups.into_iter().flat_map(|group| EvolutionLaw::ALL.map(|law| (group, law)));
    let of = |[inertial_parameter, stiffness_group, effect_ratio]: [f64; 3]| Groups {
        inertial_parameter,
        stiffness_group,
        effect_ratio,
    };
    cases.enumerate().map(|(n, (group, law))| (of(group), law, starts[n % 3])).collect()
}

#[test]
fn stiff_decays_have_their_errors() {
    for (groups, law, start) in stiff_decays() {
        let model = Model::new(groups.clone(), law);
        let exact = first_returns(&model, start).and_steady_sliding();
        for tolerance in [1e-2, 1e-6, 1e-8, 1e-10, 1e-12] {
            let at = format!("{groups:?} {law:?} {start:?} {tolerance:e}");
            let outcome = simulate_model(&model, &Options { start, ..Options::at(tolerance) })
                .unwrap_or_else(|failure| panic!("{at}: {failure}"));
            let found = outcome.in_si(&Parameters::from([1.0; 7]));
            let peak = libm::expm1(outcome.log_peak() - exact.peak.max(0.0)).abs();
            assert!(
                peak <= found.peak_relative_error && found.peak_relative_error <= tolerance,
                "{at}: {peak:e}"
            );
            let drop = (found.stress_drop_pa / (exact.highest_stress - exact.lowest_stress) - 1.0).abs();
            assert!(drop <= found.stress_drop_relative_error, "{at}: {drop:e} {found:?}");
        }
    }
}

/// A search of 4 000 returns took seconds here, at one tolerance or stiffness in three.
#[test]
fn no_search_is_tried_where_the_rounding_errors_of_the_stress_hide_the_decay() {
    let stiffnesses = [2e6, 3e6, 3.11e6, 4e6, 1e7].map(|kappa| [6.4e4, kappa, 0.313]);
    for [inertial_parameter, stiffness_group, effect_ratio] in
        stiffnesses.into_iter().chain([[6.02e5, 7.06e6, 1.39]])
    {
        let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
        let model = Model::new(groups, EvolutionLaw::Aging);
        assert_eq!(Pace::of(&model), Pace::Lost, "{model:?}");
        for tolerance in [1e-2, 1e-4, 1e-8, 1e-10, 1e-12] {
            let outcome = simulate_model(&model, &Options::at(tolerance)).unwrap();
            assert!(outcome.steps() < 500, "{model:?} {tolerance:e}: {}", outcome.steps());
        }
    }
}

#[test]
fn the_sign_of_k_minus_k_c_decides_at_any_distance() {
    for (eta, beta) in [("1e-6", "1.2"), ("1", "1.5"), ("1e3", "5")] {
        for exponent in [-9, -14, -30] {
            for above in [false, true] {
                let slider = slider(eta, beta, &next_to_one(above, exponent));
                let found = simulate(&slider, EvolutionLaw::Slip, &Options::at(1e-6)).unwrap();
                let behaviour = if above { Behaviour::Decaying } else { Behaviour::Periodic };
                assert_eq!(found.behaviour, behaviour, "{eta} {beta} {exponent}");
                assert!(found.growth_rate_per_s.is_none_or(|rate| rate < 0.0));
            }
        }
    }
}

/// ln(V_peak/V_l), ln(V_min/V_l), the period and the stress drop of cycles at η, β and K/K_c − 1 = −10^n, by Taylor series with 45 digits and
/// Newton's method on the return map.
const CYCLES: [(EvolutionLaw, [&str; 2], i32, [f64; 4]); 5] = [
    (
        EvolutionLaw::Slip,
        ["1", "1.5"],
        -9,
        [
            3.999_951_113_199_951e-5,
            -4.000_048_890_977_768_3e-5,
            8.885_765_882_240_577,
            1.131_370_849_836_640_9e-4,
        ],
    ),
    (
        EvolutionLaw::Aging,
        ["1", "1.5"],
        -9,
        [
            5.855_279_808_530_33e-5,
            -5.855_521_078_371_834_4e-5,
            8.885_765_883_509_972,
            1.656_157_342_611_869_3e-4,
        ],
    ),
    (
        EvolutionLaw::Slip,
        ["1e3", "1.1"],
        -9,
        [
            2.379_892_118_606_904e-5,
            -2.379_948_707_591_994_2e-5,
            1.986_917_654_153_010_2e1,
            1.506_699_023_858_579_2e-2,
        ],
    ),
    (
        EvolutionLaw::Aging,
        ["1e3", "5"],
        -12,
        [
            1.720_188_861_715_854_2e-6,
            -1.720_191_820_816_936_2e-6,
            3.141_592_653_591_365,
            6.887_642_126_420_412e-3,
        ],
    ),
    (
        EvolutionLaw::Slip,
        ["1", "5"],
        -8,
        [
            1.264_831_070_278_269e-4,
            -1.264_991_070_279_266_7e-4,
            3.141_592_674_533_744_6,
            1.011_928_846_924_512_6e-3,
        ],
    ),
];

#[test]
fn small_cycles_are_those_of_newtons_method_with_45_digits() {
    for (law, [eta, beta], exponent, [peak, trough, period, drop]) in CYCLES {
        let slider = slider(eta, beta, &next_to_one(false, exponent));
        let found = simulate(&slider, law, &Options::at(1e-8)).unwrap();
        let check = |what: &str, difference: f64, estimated: f64| {
            assert!(difference.abs() <= estimated, "{law:?} {eta} {what}: {difference:e} {estimated:e}");
            assert!(estimated < 1e-10, "{law:?} {eta} {what}: {estimated:e}");
        };
        let of_peak = libm::log(found.peak_velocity_m_per_s) - peak;
        check("peak", of_peak, found.peak_relative_error);
        let lowest = found.minimum_velocity_log10_ratio - trough / std::f64::consts::LN_10;
        check("trough", lowest, found.minimum_velocity_log10_error);
        check("period", found.period_s.unwrap() / period - 1.0, found.period_relative_error.unwrap());
        check("drop", found.stress_drop_pa / drop - 1.0, found.stress_drop_relative_error);
    }
}

/// Where Newton's iteration still finds the cycle, the members of the family give the same.
#[test]
fn the_family_of_cycles_and_the_search_agree_where_both_find_the_cycle() {
    for (eta, beta) in [("0.3", "1.5"), ("1", "3"), ("30", "1.2")] {
        for (exponent, law) in
            [-4, -5].into_iter().flat_map(|exponent| EvolutionLaw::ALL.map(|law| (exponent, law)))
        {
            let slider = slider(eta, beta, &next_to_one(false, exponent));
            let model = model_of(&slider, law);
            let pair = SlowPair::of(&model, &slider.groups()).unwrap();
            let near = pair.near_transition.unwrap();
            let (Cycle { orbit, .. }, errors, _) =
                small_cycle(&model, &near, &pair.modes.oscillation).unwrap();
            let searched = simulate_model(&model, &Options::at(1e-8)).unwrap();
            let LongTerm::Cycle(cycle) = searched.long_term() else { panic!("{eta} {beta} {law:?}") };
            let difference = (orbit.peak - cycle.orbit.peak).abs();
            let permitted = errors.peak + searched.peak_relative_error();
            assert!(difference <= permitted, "{eta} {beta} {exponent} {law:?}: {difference:e} {permitted:e}");
        }
    }
}

/// The aging law at small η: an unstable cycle of amplitude 1e-6 or so stands above K = K_c.
#[test]
fn a_run_outside_a_small_unstable_cycle_is_no_decay() {
    let slider = slider("0.01", "1.5", &next_to_one(true, -12));
    for ratio in [0.1, 0.99, 0.9999] {
        let options = Options { velocity_ratio: ratio, most_returns: 100, ..Options::at(1e-6) };
        match simulate(&slider, EvolutionLaw::Aging, &options) {
            Ok(found) => assert_eq!(found.behaviour, Behaviour::Periodic, "{ratio}"),
            Err(failure) => assert!(matches!(failure, Failure::Undecided { .. }), "{ratio} {failure}"),
        }
    }
}

#[test]
fn a_cycle_that_the_members_do_not_reach_to_the_tolerance_says_what_was_reached() {
    let slider = slider("1e-6", "5", &next_to_one(false, -8));
    let failure = simulate(&slider, EvolutionLaw::Slip, &Options::at(1e-8)).unwrap_err();
    let Failure::UnreachableTolerance { reached, .. } = failure else { panic!("{failure}") };
    assert!(1e-8 < reached && reached < 1e-6, "{reached:e}");
    assert!(simulate(&slider, EvolutionLaw::Slip, &Options::at(1e-6)).is_ok());
}
