//! The way of ln V to its slow value when a slider comes to a stop, in one step with a bound of its error.
//!
//! With s = ζ − βy the distance d = x − s obeys d' = −d e^{−x}/η − s'. A slider that stops with d > 0 has |s'| ≤ R = κ + β max|y'|, and
//! while x falls from x0 every rate of d is at least 1/(η V), V = e^{x0}. So after τ = ηV ln(d0/ε) the distance is below ε + RηV, whatever
//! happened in between, and y and ζ went by y' and ζ' of a slider at rest: −V(|x| + |y|) ≤ y' ≤ 0 for the slip law, e^{−y} (which changes by
//! less than (e^{−y0} τ)² in all) less V for the aging law, κ(1 − V) for ζ. Where the sum of these is a small part of what a step is
//! permitted, x = s is as good as hundreds of steps, each of which would follow the singularity of ln V by the factor of two.

use super::{Balance, Model, Scalar, State};
use crate::friction::EvolutionLaw;

/// Part of a step's permitted error that each of the two halves of the bound may take.
const PART: f64 = 0.03;

/// The least fall that is worth it.
const LEAST_FALL: f64 = 3.0;

/// Velocities below this meet the floor of the model's momentum.
const LEAST_VELOCITY: f64 = 1e-280;

/// Where an arrest ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arrest<R> {
    pub to: State<R>,
    /// How long it takes.
    pub time: R,
    /// R: no slow variable changes faster at its end.
    pub slow_rate: f64,
}

/// The arrest from a state, when its error is within the permitted one; none when there is none or it is not.
pub(super) fn arrest<R: Scalar>(model: &Model<R>, from: &State<R>, permitted: f64) -> Option<Arrest<R>> {
    if from[0].to_f64() > 0.0 || model.balance != Balance::Inertial {
        return None;
    }
    let imbalance = model.imbalance(from);
    let fall = -imbalance.to_f64();
    if fall < LEAST_FALL {
        return None;
    }
    let [x, y] = [from[0].to_f64(), from[1].to_f64()];
    let groups = model.groups().map(Scalar::to_f64);
    let (eta, kappa, beta) = (groups.inertial_parameter, groups.stiffness_group, groups.effect_ratio);
    let velocity = libm::exp(x);
    let healing = if model.law() == EvolutionLaw::Aging { libm::exp(-y) } else { 0.0 };
    let slow_rate = kappa + beta * (healing + velocity * (x.abs() + fall + y.abs() + 1.0));
    let time = eta * velocity * libm::log(fall / (PART * permitted));
    // An error of y is one of x = ζ − βy as well, and counts by itself where β < 1.
    let weight = beta.max(1.0);
    let moving = time * velocity * (kappa + weight * (1.0 + y.abs() + x.abs() + fall));
    let error = slow_rate * eta * velocity + moving + weight * (healing * time) * (healing * time);
    // Written so that a value that is not a number refuses.
    let is_good = error <= PART * permitted && velocity > LEAST_VELOCITY;
    if !is_good {
        return None;
    }
    let time = R::from_f64(time);
    let healed = match model.law() {
        EvolutionLaw::Slip => R::from(0),
        EvolutionLaw::Aging => (-from[1].clone()).exponentials().0 * &time,
    };
    let loaded = model.groups().stiffness_group.clone() * &time;
    let to_slow = imbalance + &loaded - model.groups().effect_ratio.clone() * &healed;
    let to = [from[0].clone() + to_slow, from[1].clone() + healed, from[2].clone() + loaded];
    Some(Arrest { to, time, slow_rate })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{Control, Integrator, Radau};
    use crate::friction::Groups;

    #[test]
    fn an_arrest_ends_where_hundreds_of_steps_end() {
        let groups = Groups { inertial_parameter: 7.9e5, stiffness_group: 79.0, effect_ratio: 1.5 };
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups.clone(), law);
            let from = [-32.0, 2.9, -140.0];
            let arrest = arrest(&model, &from, 1e-4).unwrap();
            let control = Control { local_tolerance: 1e-12, most_steps: 100_000 };
            let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), from, control).unwrap();
            while run.time() < arrest.time * (1.0 - 1e-12) {
                run.advance(Some(&(arrest.time - run.time()))).unwrap();
            }
            for c in 0..3 {
                let error = (run.state()[c] - arrest.to[c]).abs();
                assert!(error < 2.0 * PART * 1e-4, "{law:?} {c}: {error:e}");
            }
            assert!(run.step_counts().0 > 100 && arrest.to[0] < -140.0);
        }
    }

    #[test]
    fn healing_that_hardly_acts_on_the_velocity_is_bounded_by_itself() {
        // β = 1/1000: the error of y, 3e-4, is a thousandth of that in ln V, but still more than is permitted.
        let groups = Groups { inertial_parameter: 1.0, stiffness_group: 1e-3, effect_ratio: 1e-3 };
        let model = Model::new(groups, EvolutionLaw::Aging);
        assert!(arrest(&model, &[-11.5, -5.0, -111.5], 1e-4).is_none());
        assert!(arrest(&model, &[-16.5, -5.0, -116.5], 1e-4).is_some());
    }

    #[test]
    fn an_arrest_whose_error_would_show_is_declined() {
        let groups = Groups { inertial_parameter: 7.9e5, stiffness_group: 79.0, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        assert!(arrest(&model, &[-10.0, 2.9, -140.0], 1e-2).is_none());
        // Above its slow value nothing is arrested, nor where no fall is left.
        assert!(arrest(&model, &[-40.0, 2.9, 10.0], 1e-2).is_none());
        assert!(arrest(&model, &[-40.0, 0.0, -40.0], 1e-2).is_none());
    }
}
