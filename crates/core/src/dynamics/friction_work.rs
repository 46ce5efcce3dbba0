//! The work of friction over a return, which says how the amplitude changes where the change itself is lost in rounding errors.
//!
//! E = η (V − 1)²/2 + ζ²/(2κ), with V in V_l, obeys E' = −(V − 1) φ, and V = 1 at every crossing: over a return ζ² changes by −2κ ∮(V − 1) φ dt.
//! For η ≫ 1 friction is small beside inertia and spring, and the integral keeps all digits of this small change.

use super::integrator::{Control, Integrator, Work};
use super::stepper::Stepper;
use super::{Failure, Model, State, Taylor};

/// Coefficients of the series.
const TERMS: usize = 20;

/// Local tolerance: the integral errs by about as much, relative to itself.
const LOCAL_TOLERANCE: f64 = 1e-12;

/// Most steps of one return.
const MOST_STEPS: u64 = 10_000;

/// ln(ζ_end/ζ_start) of the return that begins at a crossing and lasts this long, and what it cost.
pub(super) fn log_ratio(
    model: &Model<f64>,
    crossing: &State<f64>,
    duration: f64,
) -> Result<(f64, Work), Failure> {
    let control = Control { local_tolerance: LOCAL_TOLERANCE, most_steps: MOST_STEPS };
    let method = Taylor::<f64, TERMS>::new().with_stress_unit(model.stress_swing().max(1.0));
    let mut run = Integrator::new(model, method, *crossing, control)?;
    let mut work = 0.0;
    loop {
        let rest = duration - run.time();
        if rest <= duration * 8.0 * f64::EPSILON {
            break;
        }
        run.advance(Some(&rest))?;
        work += work_of_step(&run);
    }
    let stress = crossing[2];
    let change = -2.0 * model.groups().stiffness_group * work / (stress * stress);
    Ok((0.5 * libm::log1p(change), run.work()))
}

/// ∫(V − 1) φ dt over the last step, by the rule of Gauss with five points.
fn work_of_step<M: Stepper<f64>>(run: &Integrator<'_, f64, M>) -> f64 {
    let (inner, outer) = (2.0 * (10.0f64 / 7.0).sqrt(), 13.0 * 70.0f64.sqrt());
    let [near, far] = [5.0 - inner, 5.0 + inner].map(|square| square.sqrt() / 3.0);
    let [of_near, of_far] = [322.0 + outer, 322.0 - outer].map(|weight| weight / 900.0);
    let points = [(0.0, 128.0 / 225.0), (near, of_near), (-near, of_near), (far, of_far), (-far, of_far)];
    let power = |place: f64| {
        let state = run.state_within(&(0.5 + 0.5 * place));
        libm::expm1(state[0]) * run.model.friction(&state)
    };
    0.5 * run.step() * points.iter().map(|&(place, weight)| weight * power(place)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{Radau, next_return};
    use crate::friction::{EvolutionLaw, Groups};
    use crate::number::Dd;

    #[test]
    fn the_work_of_friction_is_what_a_return_in_double_double_takes_from_the_stress() {
        for (eta, law) in [1e2, 1e6, 1e12].into_iter().flat_map(|eta| EvolutionLaw::ALL.map(|law| (eta, law)))
        {
            let groups = Groups { inertial_parameter: eta, stiffness_group: 1.3 * eta, effect_ratio: 1.5 };
            let start = [0.0, 0.4, 0.7 * eta];
            let model = Model::new(groups.map(|&group| Dd::from(group)), law);
            let control = Control { local_tolerance: 1e-22, most_steps: 100_000 };
            let mut run =
                Integrator::new(&model, Radau::<Dd, 7>::new(), start.map(Dd::from), control).unwrap();
            let orbit = next_return(&mut run).unwrap().0;
            let exact = crate::dynamics::Scalar::logarithm(&(orbit.end[2] / Dd::from(start[2]))).hi();
            let (found, _) = log_ratio(&Model::new(groups, law), &start, orbit.duration.hi()).unwrap();
            assert!((found / exact - 1.0).abs() < 1e-8, "{eta:e} {law:?}: {found:e} {exact:e}");
        }
    }
}
