//! Checks of the whole: linear regime, steady sliding, stated errors, the paper's grid.

mod elsewhere;
mod slow;
mod smooth;
mod transition;

use super::integrator::{Control, Integrator};
use super::long_term::LongTerm;
use super::{Model, Options, Oscillation, Radau, Simulation, Start, simulate_model};
use crate::friction::{EvolutionLaw, Groups, critical_stiffness_group};

/// The paper's values at σ = 10^s Pa and V_l = 10^v m/s.
pub(super) fn paper(v: f64, s: f64) -> Groups<f64> {
    let ten = |exponent: f64| libm::exp10(exponent);
    Groups {
        inertial_parameter: 1000.0 * ten(2.0 * v) / (ten(s) * 0.004 * 1e-5),
        stiffness_group: 1e7 * 1e-5 / (0.004 * ten(s)),
        effect_ratio: 1.5,
    }
}

/// The pair of eq 8 by Newton's iteration from a guess: (Re, Im).
fn pair_near(groups: &Groups<f64>, guess: (f64, f64)) -> (f64, f64) {
    use num_complex::Complex;
    let coefficients = groups.characteristic_cubic();
    let mut p = Complex::new(guess.0, guess.1);
    for _ in 0..50 {
        let value = coefficients.iter().rev().fold(Complex::new(0.0, 0.0), |sum, c| sum * p + c);
        let slope = (1..4).rev().fold(Complex::new(0.0, 0.0), |sum, k| sum * p + coefficients[k] * k as f64);
        p -= value / slope;
    }
    (p.re, p.im)
}

#[test]
fn long_term_decay_matches_the_roots_of_eq_8() {
    for law in EvolutionLaw::ALL {
        // Overdamped-looking to barely damped: inertial and quasi-static, near K = K_c and far from it.
        for (eta, kappa) in [(50.0, 40.0), (5.0, 3.3), (0.5, 1.2), (1e-3, 0.6), (1e-6, 0.7), (2.0, 1.501)] {
            let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: 1.5 };
            let model = Model::new(groups.clone(), law);
            let outcome = simulate_model(&model, &Options::default()).unwrap();
            let LongTerm::Decay(decay) = outcome.long_term() else { unreachable!("K > K_c: {eta} {kappa}") };
            let Oscillation { period, growth_rate: growth } = decay.oscillation.unwrap();
            let angular = std::f64::consts::TAU / period;
            let (re, im) = pair_near(&groups, (growth, angular));
            assert!((angular / im - 1.0).abs() < 1e-8, "{law:?} {eta} {kappa}: {angular} {im}");
            assert!((growth - re).abs() < 1e-8 * re.hypot(im), "{law:?} {eta} {kappa}: {growth} {re}");
        }
    }
}

#[test]
fn steady_sliding_is_kept_over_a_million_time_units() {
    for law in EvolutionLaw::ALL {
        let model = Model::new(paper(-1.5, 4.0), law);
        let control = Control { local_tolerance: 1e-8, most_steps: 100_000 };
        let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), [0.0; 3], control).unwrap();
        while run.time() < 1e6 {
            run.advance(None).unwrap();
        }
        assert_eq!(run.state().map(f64::abs), [0.0; 3]);
    }
}

#[test]
fn the_stated_error_holds_against_a_tighter_run() {
    let cases = [
        (-6.0, 7.5),
        (-5.5, 6.5),
        (-5.0, 5.0),
        (-3.0, 5.0),
        (-1.5, 4.0),
        (-1.0, 2.5),
        (-4.0, 4.0),
        (-2.75, 2.75),
    ];
    for law in EvolutionLaw::ALL {
        for (v, s) in cases {
            let model = Model::new(paper(v, s), law);
            let parameters = unit_parameters();
            let run = |tolerance| {
                let options = Options::at(tolerance);
                simulate_model(&model, &options).unwrap().in_si(&parameters)
            };
            for tolerance in [1e-2, 1e-4, 1e-6] {
                hold_extremes(&run(tolerance), &run(1e-2 * tolerance));
            }
            let (usual, tight) = (run(1e-8), run(1e-10));
            hold_extremes(&usual, &tight);
            let error = (usual.peak_velocity_m_per_s / tight.peak_velocity_m_per_s - 1.0).abs();
            assert!(
                usual.peak_relative_error <= 1e-8 && error <= usual.peak_relative_error,
                "{law:?} {v} {s}: {error:e}"
            );
            if let (Some(a), Some(b)) = (usual.period_s, tight.period_s) {
                assert!((a / b - 1.0).abs() <= usual.period_relative_error.unwrap(), "{law:?} {v} {s}");
            }
        }
    }
}

/// Random groups: η from 1e-8 to 1e4, K/K_c from 0.01 to 0.99, β from 1.05 to 5. With 400
/// others and tolerances from 1e-2 to 1e-10 no error was more than 0.82 of what is stated, in the median a fiftieth.
#[test]
fn stated_errors_hold_for_random_groups() {
    let mut seed = 20_261_121u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    for case in 0..16 {
        let inertial_parameter = libm::exp10(-8.0 + 12.0 * random());
        let (ratio, effect_ratio) = (0.01 + 0.98 * random(), 1.05 + 3.95 * random());
        let stiffness_group = ratio * critical_stiffness_group(&effect_ratio, &inertial_parameter);
        let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
        let model = Model::new(groups, EvolutionLaw::ALL[case % 2]);
        let run = |tolerance| {
            let found = simulate_model(&model, &Options::at(tolerance));
            found.map(|outcome| outcome.in_si(&unit_parameters()))
        };
        let exact = run(1e-10).or_else(|_| run(1e-9)).unwrap();
        for tolerance in [1e-2, 1e-4, 1e-6, 1e-8] {
            let found = run(tolerance).unwrap();
            let peak = (found.peak_velocity_m_per_s / exact.peak_velocity_m_per_s - 1.0).abs();
            assert!(
                peak <= found.peak_relative_error + exact.peak_relative_error,
                "{model:?} {tolerance:e} {peak:e}"
            );
            let period = (found.period_s.unwrap() / exact.period_s.unwrap() - 1.0).abs();
            let stated = found.period_relative_error.unwrap() + exact.period_relative_error.unwrap();
            assert!(period <= stated, "{model:?} {tolerance:e} {period:e}");
            let lowest = (found.minimum_velocity_log10_ratio - exact.minimum_velocity_log10_ratio).abs();
            let stated = found.minimum_velocity_log10_error + exact.minimum_velocity_log10_error;
            assert!(lowest <= stated, "{model:?} {tolerance:e} {lowest:e}");
            let drop = (found.stress_drop_pa / exact.stress_drop_pa - 1.0).abs();
            let stated = found.stress_drop_relative_error + exact.stress_drop_relative_error;
            assert!(drop <= stated, "{model:?} {tolerance:e} {drop:e}");
        }
    }
}

/// Checks the stated errors of least velocity and stress drop against a tighter run.
fn hold_extremes(usual: &Simulation, tight: &Simulation) {
    let lowest = (usual.minimum_velocity_log10_ratio - tight.minimum_velocity_log10_ratio).abs();
    assert!(lowest <= usual.minimum_velocity_log10_error, "{usual:?} {lowest:e}");
    let drop = (usual.stress_drop_pa / tight.stress_drop_pa - 1.0).abs();
    assert!(drop <= usual.stress_drop_relative_error, "{usual:?} {drop:e}");
}

/// A vibration turns at V = 0 nearly; whether it stops there, 10^-59 V_l or 10^-6 V_l, is decided by a ten-millionth of V_l.
#[test]
fn a_slider_that_barely_stops_states_that_it_might() {
    for (eta, kappa) in [(2.060_979e5, 3.098_527_7e5), (2.060_979e5, 3.098e5), (2.061e5, 3.098_527_7e5)] {
        let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: 8.084_136_5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let run = |tolerance: f64| {
            let found = simulate_model(&model, &Options::at(tolerance));
            found.unwrap().in_si(&unit_parameters())
        };
        let tight = run(1e-9);
        assert!(tight.minimum_velocity_log10_error < 0.5, "{tight:?}");
        for tolerance in [1e-2, 1e-4, 1.46e-5, 1e-6, 3e-7] {
            hold_extremes(&run(tolerance), &tight);
        }
    }
}

/// Parameters of value one: SI and dimensionless values then coincide.
fn unit_parameters() -> crate::friction::Parameters<f64> {
    crate::friction::Parameters::from([1.0; 7])
}

#[test]
fn an_unreachable_tolerance_says_what_was_reached() {
    let model = Model::new(paper(-3.0, 5.0), EvolutionLaw::Slip);
    let options = Options { tolerance: 1e-18, ..Options::default() };
    match simulate_model(&model, &options) {
        Err(super::Failure::UnreachableTolerance { requested, reached }) => {
            assert!(requested == 1e-18 && reached > 1e-16 && reached < 1e-9, "{reached:e}");
        }
        other => unreachable!("{other:?}"),
    }
}

#[test]
fn inadmissible_groups_are_refused() {
    for (eta, kappa) in [(0.0, 1.0), (f64::NAN, 1.0), (1.0, -1.0), (f64::INFINITY, 1.0), (1e-320, 1.0)] {
        let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: 1.5 };
        let result = simulate_model(&Model::new(groups, EvolutionLaw::Aging), &Options::default());
        assert_eq!(result.unwrap_err(), super::Failure::InvalidStart);
    }
}

#[test]
fn the_start_does_not_change_the_limit_cycle() {
    let model = Model::new(paper(-3.0, 5.0), EvolutionLaw::Aging);
    let peak = |start| simulate_model(&model, &Options { start, ..Options::default() }).unwrap().log_peak();
    let usual = peak(Start::default());
    for start in Start::ALL {
        assert!((peak(start) - usual).abs() < 1e-8, "{start:?}");
    }
}

#[test]
fn one_tenth_of_a_grid_of_the_paper_runs_without_a_failure() {
    for law in EvolutionLaw::ALL {
        for effect_ratio in [1.5, 1.0 / 1.5] {
            for i in 0..7 {
                for j in 0..7 {
                    let groups = Groups {
                        effect_ratio,
                        ..paper(-6.0 + 0.75 * f64::from(i), 2.5 + 0.75 * f64::from(j))
                    };
                    let unstable = groups.transition_margin() < 0.0;
                    let outcome = simulate_model(&Model::new(groups, law), &Options::default()).unwrap();
                    assert_eq!(
                        matches!(outcome.long_term(), LongTerm::Cycle(_)),
                        unstable,
                        "{law:?} {effect_ratio} {i} {j}"
                    );
                }
            }
        }
    }
}

#[test]
fn velocities_below_the_range_of_f64_do_not_stop_a_run() {
    for (inertial_parameter, stiffness_group, effect_ratio) in
        [(8.24e5, 51.0, 9.622), (2.61e5, 9.49e3, 5.299)]
    {
        let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
        let outcome = simulate_model(&Model::new(groups, EvolutionLaw::Slip), &Options::default()).unwrap();
        let seen = outcome.in_si(&unit_parameters());
        assert!(seen.minimum_velocity_log10_ratio < -308.0, "{}", seen.minimum_velocity_log10_ratio);
    }
}

#[test]
fn two_returns_that_differ_by_the_errors_of_a_rough_run_are_not_one_cycle() {
    // At a local tolerance of 1e-3 the steps of successive returns take turns; this cycle was reported with twice its period.
    let groups = Groups {
        inertial_parameter: 2.209_493_948_795_439_3e-7,
        stiffness_group: 1.579_186_219_893_293_6e-2,
        effect_ratio: 3.0,
    };
    let model = Model::new(groups, EvolutionLaw::Slip);
    let [loose, tight] = [1e-4, 1e-8].map(|tolerance| {
        let found = simulate_model(&model, &Options::at(tolerance)).unwrap();
        let LongTerm::Cycle(cycle) = found.long_term() else { unreachable!("K < K_c") };
        (cycle.orbit.duration, cycle.returns_per_cycle)
    });
    assert_eq!((loose.1, tight.1), (1, 1));
    assert!((loose.0 / tight.0 - 1.0).abs() < 1e-4, "{loose:?} {tight:?}");
}

#[test]
fn a_minimum_between_two_long_steps_is_seen() {
    // A loose run of this slider had none, and the stated error of the least velocity was 4e293 decades.
    let values = [
        "0.008870117593700483",
        "0.012819614851638503",
        "7.818812755934857e-6",
        "2e9",
        "2400",
        "5e6",
        "1e-5",
    ];
    let parameters =
        crate::friction::Parameters::from(values.map(|text| crate::number::parse_decimal(text).unwrap()));
    let found = crate::dynamics::simulate(&parameters, EvolutionLaw::Slip, &Options::at(1e-8)).unwrap();
    assert!(found.minimum_velocity_log10_error < 1e-6, "{found:?}");
}
