//! The end of a decay: period and growth rate of its oscillation, or the rate of an end without one.

use super::history::History;
use super::section_return::{Return, ReturnEnd, next_return};
use super::stepper::Stepper;
use super::{Failure, Integrator, Scalar, State};

/// An oscillation that shrinks or grows by the same factor in every period, in units of D_c/V_l.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation<R> {
    /// The period.
    pub period: R,
    /// The growth rate, negative for a decay.
    pub growth_rate: R,
}

/// A return to steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub struct Decay<R> {
    /// All that happened before it was called linear, as one return.
    pub transient: Return<R>,
    /// The long-term oscillation; none when there is no oscillation.
    pub oscillation: Option<Oscillation<R>>,
    /// Rate at which the state shrank at the very end, when it does not oscillate.
    pub rate: Option<R>,
}

/// Period and growth rate in the linear regime, when returns agree with one another.
pub(super) fn measure_decay<R: Scalar, M: Stepper<R> + Clone>(
    run: &mut Integrator<'_, R, M>,
    mut history: History<R>,
    transient: Return<R>,
) -> Result<Decay<R>, Failure> {
    /// Returns until the fast direction has died out; it shrinks by e^{−2π} a return at least when there is an oscillation.
    const RETURNS: usize = 12;
    for _ in 0..RETURNS {
        let (orbit, end) = next_return(run)?;
        if end == ReturnEnd::AtRest {
            return Ok(Decay { oscillation: None, transient, rate: final_rate(run) });
        }
        history.returns.push(orbit);
        if let Some(oscillation) = last_oscillation(&history)
            && history.returns.len() >= 4
            && steady(&history)
        {
            return Ok(Decay { transient, oscillation: Some(oscillation), rate: None });
        }
    }
    // A real mode that dies about as slowly as the pair keeps the returns unequal: their last one is no measure of the period.
    Ok(Decay { transient, oscillation: None, rate: final_rate(run) })
}

/// Whether the last three returns took the same time to eleven digits.
fn steady<R: Scalar>(history: &History<R>) -> bool {
    let n = history.returns.len();
    let duration = |back: usize| history.returns[n - back].duration.to_f64();
    let last = duration(1);
    (2..=3).all(|back| (duration(back) / last - 1.0).abs() < 1e-11)
}

fn last_oscillation<R: Scalar>(history: &History<R>) -> Option<Oscillation<R>> {
    let n = history.returns.len();
    let (before, last) = (history.returns.get(n.checked_sub(2)?)?, &history.returns[n - 1]);
    // ζ and y shrink by the same factor; the larger one is the better measured.
    let component = if last.end[1].abs() < last.end[2].abs() { 2 } else { 1 };
    let factor = last.end[component].clone() / &before.end[component];
    (factor > R::from(0)).then(|| Oscillation {
        period: last.duration.clone(),
        growth_rate: factor.logarithm() / &last.duration,
    })
}

/// d ln|state|/dt at the end of a decay without oscillation, from the component that moves.
pub(super) fn final_rate<R: Scalar, M: Stepper<R>>(run: &Integrator<'_, R, M>) -> Option<R> {
    let state: &State<R> = run.state();
    let rate = run.model.rate(state);
    let largest = (0..3).fold(0, |best, i| if state[i].abs() > state[best].abs() { i } else { best });
    let value = rate[largest].clone() / &state[largest];
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use crate::dynamics::{LongTerm, Model, Options, Start, simulate_model};
    use crate::friction::{EvolutionLaw, Groups, Parameters};
    use crate::number::Rational;
    use crate::roots::certified_roots;

    /// The spring is in equilibrium at V_l/10, where friction is lower by (1 − β) ln 10.
    #[test]
    fn a_stress_that_only_rises_to_steady_sliding_has_a_range_with_an_error() {
        for (eta, kappa, beta) in [(2e-8, 1.2e-3, 0.84), (0.2, 1.8e-4, 0.64)] {
            let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
            for (law, start) in
                EvolutionLaw::ALL.into_iter().flat_map(|law| Start::ALL.map(|start| (law, start)))
            {
                let options = Options { start, ..Options::at(1e-8) };
                let found = simulate_model(&Model::new(groups.clone(), law), &options).unwrap();
                let found = found.in_si(&Parameters::from([1.0; 7]));
                assert!(found.stress_drop_relative_error.is_finite(), "{found:?}");
                if start == Start::SteadyAtVelocity {
                    let off = found.stress_drop_pa / ((1.0 - beta) * std::f64::consts::LN_10) - 1.0;
                    assert!(off.abs() <= found.stress_drop_relative_error, "{law:?} {found:?}");
                    assert!(found.stress_drop_relative_error < 1e-6, "{law:?} {found:?}");
                }
            }
        }
    }

    #[test]
    fn the_end_of_a_decay_without_oscillation_has_the_rate_of_the_slowest_mode() {
        for (eta, kappa, beta) in [(6.6, 2.1e-4, 0.75), (9.9e-4, 3.5e-4, 0.92), (2.2e-3, 9.0e-3, 0.45)] {
            let groups = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
            let exact = groups.map(|group| Rational::from_f64(*group).unwrap());
            let roots = certified_roots(&exact.characteristic_cubic(), 20).roots;
            let slowest = roots.iter().map(|root| root.re.to_f64()).fold(f64::MIN, f64::max);
            for law in EvolutionLaw::ALL {
                for (tolerance, permitted) in [(1e-2, 1e-2), (1e-4, 1e-3), (1e-8, 1e-5)] {
                    let options = Options::at(tolerance);
                    let run = simulate_model(&Model::new(groups.clone(), law), &options).unwrap();
                    let LongTerm::Decay(decay) = run.long_term() else { panic!("{groups:?} {law:?}") };
                    let off = (decay.rate.unwrap() / slowest - 1.0).abs();
                    assert!(off < permitted, "{groups:?} {law:?} {tolerance:e}: {off:e}");
                }
            }
        }
    }
}
