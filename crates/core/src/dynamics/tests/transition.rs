//! Runs next to a transition between slip modes end, with the right verdict, at every tolerance.

use super::paper;
use crate::dynamics::long_term::LongTerm;
use crate::dynamics::{Model, Options, simulate_model};
use crate::friction::{EvolutionLaw, Groups};

/// Next to K = K_c a slow decay looks like the approach to a cycle; next to a double root the period magnifies errors.
#[test]
fn runs_next_to_a_transition_end_at_every_tolerance() {
    let near_transition = |eta: f64, distance: f64| Groups {
        inertial_parameter: eta,
        stiffness_group: (1.0 + distance) * 0.5 * (1.0 + eta),
        effect_ratio: 1.5,
    };
    let at = |v: f64, s: f64| paper(libm::log10(v), libm::log10(s));
    let cases = [
        (at(2.069_138_081_11e-5, 1000.0), EvolutionLaw::Aging),
        (at(4.641_588_83e-5, 2_154.434_69), EvolutionLaw::Aging),
        (at(4.641_588_83e-5, 2_154.434_69), EvolutionLaw::Slip),
        (at(1.283_439e-6, 4.997_587e4), EvolutionLaw::Slip),
        (near_transition(1e-6, 1e-4), EvolutionLaw::Slip),
        (near_transition(1e-6, -1e-4), EvolutionLaw::Slip),
        (near_transition(100.0, 1e-4), EvolutionLaw::Aging),
        (near_transition(100.0, -3e-3), EvolutionLaw::Slip),
    ];
    for (groups, law) in cases {
        let unstable = groups.transition_margin() < 0.0;
        let model = Model::new(groups.clone(), law);
        for tolerance in [1e-2, 1e-8, 1e-10] {
            let outcome = simulate_model(&model, &Options::at(tolerance)).unwrap();
            assert_eq!(
                matches!(outcome.long_term(), LongTerm::Cycle(_)),
                unstable,
                "{groups:?} {law:?} {tolerance:e}"
            );
        }
    }
}

/// For η ≫ 1 a return takes a part in 10^8 of a vibration, which every return at a loose tolerance errs by: no cycle may be seen there.
#[test]
fn vibrations_that_die_in_a_hundred_million_returns_are_no_cycles() {
    let groups = [
        [1.65e7, 2.00e7, 2.136],
        [1.87e6, 2.27e6, 2.155],
        [3.780_876e7, 8.237_744e7, 3.051],
        [9.883_094e5, 5.940_641e4, 1.058_802],
        [1.867_2e4, 2.022_342e4, 2.082_898],
    ];
    for [eta, kappa, beta] in groups {
        let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
        assert!(groups.transition_margin() > 0.0);
        for law in EvolutionLaw::ALL {
            for tolerance in [1e-2, 1e-4, 1e-8] {
                let options = Options::at(tolerance);
                let outcome = simulate_model(&Model::new(groups.clone(), law), &options).unwrap();
                assert!(
                    matches!(outcome.long_term(), LongTerm::Decay(_)),
                    "{groups:?} {law:?} {tolerance:e}"
                );
            }
        }
    }
}

/// Next to the unstable cycle of the aging law, a return moves a run by a part in 10^5 and Newton's iteration would find that cycle.
#[test]
fn no_run_ends_on_an_unstable_cycle() {
    // η, K/K_c − 1, and ln(V_l/V) of the start from which a run stays next to the unstable cycle.
    for [eta, distance, threshold] in
        [[1e-5, 3.1257e-5, 1.50982], [0.12, 1.5398e-4, 0.192_408], [0.13, 3.2139e-5, 0.128_54]]
    {
        let groups = Groups {
            inertial_parameter: eta,
            stiffness_group: (1.0 + distance) * 0.5 * (1.0 + eta),
            effect_ratio: 1.5,
        };
        let model = Model::new(groups, EvolutionLaw::Aging);
        for (part, periodic) in [(0.98, false), (1.02, true)] {
            let options = Options { velocity_ratio: libm::exp(-part * threshold), ..Options::at(1e-6) };
            let outcome = simulate_model(&model, &options).unwrap();
            let on_cycle = matches!(outcome.long_term(), LongTerm::Cycle(_));
            assert_eq!(on_cycle, periodic, "η = {eta}, {part}: {:?}", outcome.contraction());
            assert!(outcome.contraction().is_none_or(|known| known < 1.0), "{outcome:?}");
        }
    }
}
