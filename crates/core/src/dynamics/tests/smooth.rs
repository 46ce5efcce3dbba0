//! Decays whose forces balance slowly: against other integrators, the roots of eq 8 and the search, and what they cost.

use crate::dynamics::integrator::{Control, Integrator};
use crate::dynamics::long_term::LongTerm;
use crate::dynamics::search::{Leftover, Search};
use crate::dynamics::section_return::{Return, ReturnEnd, next_return};
use crate::dynamics::smooth_decay::smooth_decay;
use crate::dynamics::{Model, Options, Radau, Start};
use crate::friction::{EvolutionLaw, Groups, Parameters, critical_stiffness_group};
use crate::number::Rational;
use crate::roots::certified_roots;

/// The paper's values for b < a at σ = 10^4 Pa.
fn stable(loading_velocity: f64) -> Groups<f64> {
    Groups {
        inertial_parameter: 1e9 * loading_velocity * loading_velocity / 0.6,
        stiffness_group: 5.0 / 3.0,
        effect_ratio: 2.0 / 3.0,
    }
}

/// β, η and K/K_c of decays of quality 1 to 1e4; K instead of K/K_c where β < 1.
const CASES: [[f64; 3]; 14] = [
    [0.5, 20.0, 0.5],
    [0.5, 3e3, 40.0],
    [0.7, 0.3, 9.0],
    [0.9, 5e4, 1.5],
    [0.93, 11.54, 0.01],
    [0.99, 1e2, 80.0],
    [1.5, 0.5, 3.0],
    [1.5, 20.0, 1.3],
    [1.5, 1e4, 2.0],
    [3.0, 2.0, 1.1],
    [4.2, 0.4, 7.0],
    [5.0, 50.0, 2.5],
    // Stresses fall for several returns here.
    [1.5, 0.25, 126.0],
    [1.5, 0.79, 28.0],
];

fn groups_of([effect_ratio, inertial_parameter, stiffness]: [f64; 3]) -> Groups<f64> {
    let unit =
        if effect_ratio > 1.0 { critical_stiffness_group(&effect_ratio, &inertial_parameter) } else { 1.0 };
    Groups { inertial_parameter, stiffness_group: stiffness * unit, effect_ratio }
}

/// Every return until the state is a thousandth, or sixty of them, by Radau IIA of order 13.
fn transient(model: &Model<f64>) -> Return<f64> {
    let start = Start::default().at_a_tenth(model);
    let control = Control { local_tolerance: 1e-12, most_steps: 100_000 };
    let mut run = Integrator::new(model, Radau::<f64, 7>::new(), start, control).unwrap();
    let mut whole: Option<Return<f64>> = None;
    for _ in 0..60 {
        let (orbit, end) = next_return(&mut run).unwrap();
        whole = Some(whole.map_or_else(|| orbit.clone(), |whole| whole.joined(orbit.clone())));
        if end == ReturnEnd::AtRest || run.state().iter().all(|component| component.abs() < 1e-3) {
            break;
        }
    }
    whole.unwrap()
}

#[test]
fn extremes_and_periods_agree_with_another_integrator_and_with_eq_8() {
    for (case, law) in CASES.into_iter().flat_map(|case| EvolutionLaw::ALL.map(|law| (case, law))) {
        let groups = groups_of(case);
        let model = Model::new(groups.clone(), law);
        let exact = transient(&model);
        let cubic = groups.map(|group| Rational::from_f64(*group).unwrap()).characteristic_cubic();
        let roots = certified_roots(&cubic, 20).roots;
        let angular = roots.iter().map(|root| root.im.to_f64()).fold(0.0, f64::max);
        for tolerance in [1e-2, 1e-5, 1e-8] {
            let outcome = smooth_decay(&model, &Options::at(tolerance)).unwrap();
            let found = outcome.in_si(&Parameters::from([1.0; 7]));
            let check = |what: &str, difference: f64, estimated: f64| {
                // The reference errs by less than 1e-11.
                assert!(
                    difference.abs() <= estimated + 1e-11 && estimated < 10.0 * tolerance,
                    "{case:?} {law:?} {tolerance:e} {what}: {difference:e} {estimated:e}"
                );
            };
            check("peak", libm::expm1(outcome.log_peak() - exact.peak), found.peak_relative_error);
            let lowest = exact.trough.min(-std::f64::consts::LN_10) / std::f64::consts::LN_10;
            let of_lowest = found.minimum_velocity_log10_error;
            check("trough", found.minimum_velocity_log10_ratio - lowest, of_lowest);
            // Every decay ends at ζ = 0.
            let drop = exact.highest_stress.max(0.0) - exact.lowest_stress.min(0.0);
            check("drop", found.stress_drop_pa / drop - 1.0, found.stress_drop_relative_error);
            let period = found.period_s.unwrap() * angular / std::f64::consts::TAU - 1.0;
            check("period", period, found.period_relative_error.unwrap());
        }
    }
}

/// Next to K = K_c a cycle may attract from far away: then the search decides.
#[test]
fn no_cycle_is_taken_for_a_decay() {
    let mut decays = 0;
    for eta in [0.3, 3.0, 30.0, 300.0] {
        for ratio in [0.999, 1.0001, 1.003, 1.03] {
            for law in EvolutionLaw::ALL {
                let model = Model::new(groups_of([1.5, eta, ratio]), law);
                let options = Options::at(1e-5);
                if smooth_decay(&model, &options).is_some() {
                    let exact = model.groups().map(|&group| Rational::from_f64(group).unwrap());
                    let method = Radau::<f64, 5>::new();
                    let search = Search::new(&model, &exact, method, &options, Leftover::default());
                    let found = search.answer().unwrap();
                    assert!(matches!(found.long_term(), LongTerm::Decay(_)), "{eta} {ratio} {law:?}");
                    decays += 1;
                }
            }
        }
    }
    assert!(decays > 0);
}

#[test]
fn a_decay_at_any_loading_velocity_takes_a_few_hundred_steps() {
    for law in EvolutionLaw::ALL {
        for tenths in -30..=-5 {
            let model = Model::new(stable(libm::exp10(0.1 * f64::from(tenths))), law);
            let steps = smooth_decay(&model, &Options::at(1e-8)).unwrap().steps();
            assert!(steps < 500, "{law:?} 10^{tenths}/10 m/s: {steps}");
        }
    }
}

#[test]
fn limit_cycles_stiff_decays_and_regularised_friction_are_left_to_the_search() {
    let options = Options::at(1e-6);
    for law in EvolutionLaw::ALL {
        for case in [[1.5, 20.0, 0.8], [1.5, 1e-6, 2.0], [0.5, 1e-6, 1.0]] {
            assert!(smooth_decay(&Model::new(groups_of(case), law), &options).is_none(), "{case:?}");
        }
        let balance = crate::dynamics::Balance::Regularised(60.0);
        assert!(smooth_decay(&Model::with_balance(stable(0.01), law, balance), &options).is_none());
    }
}
