//! A limit cycle to a hundredth or a thousandth: one attempt with Radau IIA of order 5.
//!
//! Order 5 takes the least work where long steps lead to a cycle that contracts fast: two more returns, at tolerances in proportion to the
//! request, show its errors. Everywhere else order 9 takes less work: for decays, which last many returns; for Newton's iteration,
//! whose derivatives need exact returns; for cycles that may stop or not. These are left to order 9 as soon as they are seen, with
//! the cycle that was found, so that no request is cheaper to meet when it is tighter.

use super::barely_stops::may_stop_or_not;
use super::integrator::{Control, Integrator, Work};
use super::long_term::{Cycle, LongTerm, PermittedDistance, SLOW, long_term_within};
use super::outcome::Outcome;
use super::refine::{Accuracy, follow};
use super::return_map::ReturnMap;
use super::search::{FINER, FOLLOW_FROM, Leftover, NEWTON_FROM};
use super::{Model, Options, Radau};

/// The least requested error that order 5 is used for. Its work grows as the fourth root of the inverse tolerance and passes that of order 9 near here.
const LEAST_ERROR: f64 = 3e-4;

/// Local tolerance of the run that finds the cycle.
const ROUGH: f64 = 1e-2;

/// Local tolerance of the coarser of the two returns that are compared, over the requested error. Of 1, 1.5, 2 and 3 this takes the least
/// work: with a larger one more cycles miss the request, and order 9 has to refine them.
const COARSE_IN_ERRORS: f64 = 2.0;

/// Steps of a return whose errors are as large as their estimates.
const BAD_STEPS: f64 = 20.0;

/// Returns after which the method is called unsuited: many of them are cheaper with one of higher order.
const MOST_RETURNS: u64 = 40;

/// The limit cycle, when order 5 is the cheapest way to it.
pub(super) fn loose_cycle(model: &Model<f64>, options: &Options) -> Result<Outcome, Leftover> {
    let mut leftover = Leftover::default();
    if options.tolerance < LEAST_ERROR || steady_sliding_is_stable(model) {
        return Err(leftover);
    }
    let Some(cycle) = rough_cycle(model, options, &mut leftover.work) else { return Err(leftover) };
    let slow = cycle.contraction.is_some_and(|known| known >= SLOW);
    if slow || cycle.returns_per_cycle > 1 {
        leftover.known = Some((cycle, ROUGH));
        return Err(leftover);
    }
    let coarse = ROUGH.min(COARSE_IN_ERRORS * options.tolerance);
    let fine = FINER * coarse;
    let accuracy = Accuracy { coarse, fine, floor: BAD_STEPS * fine, requested: options.tolerance };
    let returns = cycle.returns_per_cycle;
    let mut map = ReturnMap::new(model, Radau::<f64, 3>::new(), returns, options.most_steps);
    let followed = follow(&mut map, &cycle, ROUGH, accuracy);
    leftover.work += map.work;
    let Ok(Some(refined)) = followed else {
        leftover.known = Some((Cycle { contraction: Some(SLOW), ..cycle }, ROUGH));
        return Err(leftover);
    };
    let undecided = may_stop_or_not(&refined, &map);
    let (cycle, errors) = refined.cycle(returns, cycle.contraction);
    leftover.known = Some((cycle.clone(), fine));
    let outcome = Outcome::new(model, LongTerm::Cycle(cycle), errors, leftover.work, fine);
    if undecided || outcome.largest_error() > options.tolerance { Err(leftover) } else { Ok(outcome) }
}

/// The cycle that a run of long steps ends on.
fn rough_cycle(model: &Model<f64>, options: &Options, work: &mut Work) -> Option<Cycle<f64>> {
    let start = options.start.state(model, &libm::log(options.velocity_ratio));
    let control = Control { local_tolerance: ROUGH, most_steps: options.most_steps };
    let mut run = Integrator::new(model, Radau::<f64, 3>::new(), start, control).ok()?;
    let permitted = PermittedDistance { fast: FOLLOW_FROM * ROUGH, slow: NEWTON_FROM };
    let found = long_term_within(&mut run, permitted, options.most_returns.min(MOST_RETURNS));
    *work += run.work();
    match found {
        Ok(LongTerm::Cycle(cycle)) => Some(cycle),
        _ => None,
    }
}

/// Whether small deviations from steady sliding die out, by the criterion of Hurwitz on the Jacobian; the run is then expected to be a decay.
fn steady_sliding_is_stable(model: &Model<f64>) -> bool {
    let j = model.jacobian(&[0.0; 3]);
    let damping = -(j.xx + j.yy);
    let minors = j.xx * j.yy - j.xy * j.yx - j.xz * j.zx;
    let constant = j.xz * j.yy * j.zx;
    damping > 0.0 && constant > 0.0 && damping * minors > constant
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::simulate_model;
    use crate::friction::{EvolutionLaw, Groups, critical_stiffness_group};

    fn model([eta, kappa, beta]: [f64; 3], law: EvolutionLaw) -> Model<f64> {
        Model::new(Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta }, law)
    }

    #[test]
    fn steady_sliding_is_stable_above_the_critical_stiffness() {
        for (eta, beta) in [(1e-6, 1.1), (0.3, 1.5), (50.0, 3.0), (1e5, 5.0)] {
            let critical = critical_stiffness_group(&beta, &eta);
            for law in EvolutionLaw::ALL {
                assert!(steady_sliding_is_stable(&model([eta, 1.001 * critical, beta], law)), "{eta} {beta}");
                assert!(
                    !steady_sliding_is_stable(&model([eta, 0.999 * critical, beta], law)),
                    "{eta} {beta}"
                );
                assert!(steady_sliding_is_stable(&model([eta, critical, 0.8], law)), "{eta}");
            }
        }
    }

    #[test]
    fn cycles_have_their_errors_at_every_tolerance_of_order_5() {
        let groups = [[2.2e-7, 1.6e-2, 3.0], [3.4e-4, 2.0, 3.0], [79.0, 0.79, 1.5], [6.4e-2, 5.7e-2, 5.0]];
        for (groups, law) in groups.into_iter().flat_map(|groups| EvolutionLaw::ALL.map(|law| (groups, law)))
        {
            let model = model(groups, law);
            let exact = simulate_model(&model, &Options::at(1e-9)).unwrap();
            for tolerance in [1e-1, 1e-2, 3e-3, 1e-3, LEAST_ERROR] {
                let found = simulate_model(&model, &Options::at(tolerance)).unwrap();
                let error = (found.log_peak() - exact.log_peak()).abs();
                let estimate = found.largest_error();
                assert!(
                    estimate <= tolerance && error <= estimate,
                    "{groups:?} {law:?}: {error:e} {estimate:e}"
                );
            }
        }
    }

    #[test]
    fn a_slow_decay_is_not_taken_for_a_cycle_by_a_loose_request() {
        for groups in
            [[5004.309687472012, 180729.61580831214, 4.921196150907184], [4870.98, 187537.74, 5.3105]]
        {
            let decaying = model(groups, EvolutionLaw::Aging);
            let [loose, tight] = [1e-2, 1e-6].map(|tolerance| {
                let found = simulate_model(&decaying, &Options::at(tolerance)).unwrap();
                assert!(matches!(found.long_term(), LongTerm::Decay(_)), "{groups:?}");
                (found.log_peak(), found.largest_error())
            });
            assert!((loose.0 - tight.0).abs() <= loose.1, "{loose:?} {tight:?}");
        }
    }

    #[test]
    fn a_slow_cycle_is_left_to_order_9_with_what_it_cost() {
        // κη ≫ 1: a return changes the amplitude of the vibration by a small part only.
        let vibrating = model([3.4e3, 11.0, 3.0], EvolutionLaw::Slip);
        let leftover = loose_cycle(&vibrating, &Options::at(1e-2)).unwrap_err();
        assert!(leftover.known.is_some() && leftover.work.evaluations > 0);
        let whole = simulate_model(&vibrating, &Options::at(1e-2)).unwrap();
        assert!(whole.steps() > leftover.work.steps);
        assert_eq!(loose_cycle(&vibrating, &Options::at(1e-4)).unwrap_err().work, Work::default());
    }
}
