//! Our integrator against methods of another crate, which share no line with it, and our model against the regularised law.

use differential_equations::prelude::*;

use super::paper;
use crate::dynamics::integrator::{Control, Integrator};
use crate::dynamics::{Balance, Model, Options, Radau, Start, State, simulate_model};
use crate::friction::{EvolutionLaw, Groups};

/// The equations written out for another crate's Radau method, sharing no code with ours.
struct Slider(Groups<f64>, EvolutionLaw);

impl ODE<f64, [f64; 3]> for Slider {
    fn diff(&self, _time: f64, s: &[f64; 3], d: &mut [f64; 3]) {
        let Self(groups, law) = self;
        let velocity = libm::exp(s[0]);
        d[0] = (s[2] - s[0] - groups.effect_ratio * s[1]) / velocity / groups.inertial_parameter;
        d[1] = match law {
            EvolutionLaw::Slip => -velocity * (s[0] + s[1]),
            EvolutionLaw::Aging => libm::exp(-s[1]) - velocity,
        };
        d[2] = groups.stiffness_group * (1.0 - velocity);
    }
}

fn ours_at(groups: &Groups<f64>, law: EvolutionLaw, until: f64) -> State<f64> {
    let model = Model::new(groups.clone(), law);
    let control = Control { local_tolerance: 1e-10, most_steps: 1_000_000 };
    let start = Start::default().at_a_tenth(&model);
    let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control).unwrap();
    while until - run.time() > 1e-14 * until {
        let rest = until - run.time();
        run.advance(Some(&rest)).unwrap();
    }
    *run.state()
}

fn start_of(groups: &Groups<f64>, law: EvolutionLaw) -> State<f64> {
    Start::default().at_a_tenth(&Model::new(groups.clone(), law))
}

#[test]
fn an_unrelated_explicit_method_agrees_on_vibration() {
    for law in EvolutionLaw::ALL {
        // Seventeen oscillations at σ = 10^4.5 Pa and V_l = 10^-2 m/s.
        let groups = paper(-2.0, 4.5);
        let slider = Slider(groups.clone(), law);
        let method = ExplicitRungeKutta::dop853().rtol([1e-12; 3]).atol([1e-12; 3]).max_steps(1_000_000);
        let solution = IVP::ode(&slider, 0.0, 1000.0, start_of(&groups, law)).method(method).solve().unwrap();
        let theirs = solution.y.last().unwrap();
        let ours = ours_at(&groups, law, 1000.0);
        for (a, b) in ours.iter().zip(theirs) {
            assert!((a - b).abs() < 1e-8, "{law:?}: {ours:?} {theirs:?}");
        }
    }
}

#[test]
fn an_unrelated_stiff_method_agrees_through_a_stick_slip_event() {
    for law in EvolutionLaw::ALL {
        // The first event at σ = 10^5 Pa and V_l = 10^-5 m/s, and a good part of the stick phase after it.
        let groups = paper(-5.0, 5.0);
        let slider = Slider(groups.clone(), law);
        let method = ImplicitRungeKutta::radau5().rtol([1e-10; 3]).atol([1e-10; 3]).max_steps(10_000_000);
        let solution = IVP::ode(&slider, 0.0, 40.0, start_of(&groups, law)).method(method).solve().unwrap();
        let theirs = solution.y.last().unwrap();
        let ours = ours_at(&groups, law, 40.0);
        // Order 5 at this tolerance: an error of 1e-7 in the time of the event moves the stick phase by as much.
        for (a, b) in ours.iter().zip(theirs) {
            assert!((a - b).abs() < 1e-6, "{law:?}: {ours:?} {theirs:?}");
        }
    }
}

#[test]
fn the_regularised_law_changes_nothing_at_the_friction_of_rocks() {
    // μ0/a = 150: e^{-300} is far below rounding as long as friction does not approach zero.
    for (v, s) in [(-5.0, 5.0), (-1.5, 4.0), (-4.0, 3.0)] {
        for law in EvolutionLaw::ALL {
            let groups = paper(v, s);
            let usual = simulate_model(&Model::new(groups.clone(), law), &Options::default()).unwrap();
            let regularised = Model::with_balance(groups, law, Balance::Regularised(150.0));
            let regularised = simulate_model(&regularised, &Options::default()).unwrap();
            assert!((usual.log_peak() - regularised.log_peak()).abs() < 1e-9, "{v} {s} {law:?}");
        }
    }
}
