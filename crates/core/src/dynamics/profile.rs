//! What a stretch of a run shows between its extremes: the least friction by eq 1, what the regularised law would change there, and how
//! harmonic the velocity is.
//!
//! At the same friction and state, eq 1 and the regularised law have the velocities e^{p − m − βy} and 2 sinh(p) e^{−m − βy} in units of V_l,
//! with p = μ/a and m = μ0/a. They differ by e^{x − 2φ − 2m}, where φ = p − m = x + βy.

use super::integrator::{Control, Integrator};
use super::trajectory::GAUSS;
use super::{Failure, Model, Radau, State};

/// A value with its estimated absolute error: the change from a local tolerance ten times as large, doubled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Its error.
    pub error: f64,
}

/// What a stretch of a run shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Least φ = (μ − μ0)/a by eq 1.
    pub least_friction: Estimate,
    /// Largest x − 2φ: ln of the difference of the two laws' velocities in units of V_l, but for −2 μ0/a.
    pub regularisation: Estimate,
    /// Total harmonic distortion of V over the stretch as one period: root of the power of the overtones over that of the fundamental.
    pub distortion: Estimate,
    /// Time average of V/V_l less 1: zero over a whole cycle, so that it checks the quadrature.
    pub mean_excess: f64,
}

/// Steps of one pass, refused ones included.
const MOST_STEPS: u64 = 200_000;

impl Profile {
    /// Follows a run from a state for a time in D_c/V_l.
    ///
    /// # Errors
    /// Those of the integrator.
    pub fn of(
        model: &Model<f64>,
        start: State<f64>,
        duration: f64,
        local_tolerance: f64,
    ) -> Result<Self, Failure> {
        let [coarse, fine] = [10.0, 1.0].map(|factor| {
            let control = Control { local_tolerance: factor * local_tolerance, most_steps: MOST_STEPS };
            Pass::along(model, start, duration, control)
        });
        let (coarse, fine) = (coarse?, fine?);
        let estimate = |of: fn(&Pass) -> f64| {
            let value = of(&fine);
            Estimate { value, error: 2.0 * (value - of(&coarse)).abs() }
        };
        Ok(Self {
            least_friction: estimate(|pass| pass.least_friction),
            regularisation: estimate(|pass| pass.regularisation),
            distortion: estimate(Pass::distortion),
            mean_excess: fine.excess[0],
        })
    }
}

/// One pass over the stretch.
struct Pass {
    least_friction: f64,
    regularisation: f64,
    /// Averages of w = V/V_l − 1, of w² and of w times cosine and sine of the fundamental.
    excess: [f64; 4],
}

impl Pass {
    fn along(
        model: &Model<f64>,
        start: State<f64>,
        duration: f64,
        control: Control,
    ) -> Result<Self, Failure> {
        let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
        let mut pass =
            Self { least_friction: f64::INFINITY, regularisation: f64::NEG_INFINITY, excess: [0.0; 4] };
        pass.note(model, &start);
        while duration - run.time() > 1e-13 * duration {
            let began = run.time();
            run.advance(Some(&(duration - began)))?;
            for [place, weight] in GAUSS {
                let state = run.state_within(&place);
                let excess = libm::expm1(state[0]);
                let angle = std::f64::consts::TAU * (began + place * run.step()) / duration;
                let terms = [1.0, excess, libm::cos(angle), libm::sin(angle)];
                let share = weight * run.step() / duration * excess;
                pass.excess.iter_mut().zip(terms).for_each(|(sum, term)| *sum += share * term);
                pass.note(model, &state);
            }
            pass.note(model, run.state());
        }
        Ok(pass)
    }

    fn note(&mut self, model: &Model<f64>, state: &State<f64>) {
        let friction = model.friction(state);
        self.least_friction = self.least_friction.min(friction);
        self.regularisation = self.regularisation.max(state[0] - 2.0 * friction);
    }

    fn distortion(&self) -> f64 {
        let [mean, square, cosine, sine] = self.excess;
        let fundamental = 2.0 * (cosine * cosine + sine * sine);
        ((square - mean * mean) / fundamental - 1.0).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{LongTerm, Options, simulate_model};
    use crate::friction::{EvolutionLaw, Groups};

    fn of_cycle(law: EvolutionLaw, [inertial_parameter, stiffness_group]: [f64; 2]) -> Profile {
        let model = Model::new(Groups { inertial_parameter, stiffness_group, effect_ratio: 1.5 }, law);
        let found = simulate_model(&model, &Options::at(1e-8)).unwrap();
        let LongTerm::Cycle(cycle) = found.long_term() else { panic!("a limit cycle") };
        Profile::of(&model, cycle.from, cycle.orbit.duration, 1e-9).unwrap()
    }

    #[test]
    fn stick_slip_is_distorted_and_fast_vibration_is_nearly_harmonic() {
        // σ = 10^5 Pa at 10^-4 m/s, and 10^2.5 Pa at 10^-1 m/s.
        let slow = of_cycle(EvolutionLaw::Slip, [2.5e-3, 0.25]);
        let fast = of_cycle(EvolutionLaw::Aging, [7.905_694_150_420_947e5, 79.056_941_504_209_47]);
        assert!(slow.distortion.value > 1.0 && slow.least_friction.value > -10.0, "{slow:?}");
        assert!(fast.distortion.value < 1e-4 && fast.distortion.error < 1e-8, "{fast:?}");
        for profile in [slow, fast] {
            assert!(profile.mean_excess.abs() < 1e-6, "{profile:?}");
        }
        // scipy's Radau in the arc length of ln V, rtol 1e-9, with the stuck phases in closed form: −175.622991.
        assert!((fast.least_friction.value + 175.622_991).abs() < 1e-5, "{fast:?}");
    }

    #[test]
    fn where_friction_stays_positive_the_two_laws_have_the_same_velocity() {
        let found = of_cycle(EvolutionLaw::Slip, [2.5e-3, 0.25]);
        // m = 150: the largest difference of the velocities in units of V_l.
        assert!(found.regularisation.value - 300.0 < -250.0, "{found:?}");
    }
}
