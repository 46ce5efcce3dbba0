//! Every method against references in more digits.

use super::Rodas5P;
use super::multi::Multi;
use slipmode_core::dynamics::{
    Control, Integrator, Model, Radau, Scalar, Start, State, Stepper, Taylor, long_term_behaviour,
    next_return,
};
use slipmode_core::friction::{EvolutionLaw, Groups};
use slipmode_core::number::Dd;

/// The paper's values at σ = 10^s Pa and V_l = 10^v m/s.
fn paper_groups(v: f64, s: f64) -> Groups<f64> {
    let ten = |exponent: f64| libm::exp10(exponent);
    Groups {
        inertial_parameter: 1000.0 * ten(2.0 * v) / (ten(s) * 0.004 * 1e-5),
        stiffness_group: 1e7 * 1e-5 / (0.004 * ten(s)),
        effect_ratio: 1.5,
    }
}

fn return_from<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: M,
    section: &State<f64>,
    tolerance: f64,
) -> [R; 2] {
    let start: State<R> = std::array::from_fn(|i| R::from_f64(section[i]));
    let control = Control { local_tolerance: tolerance, most_steps: 1_000_000 };
    let mut run = Integrator::new(model, method, start, control).unwrap();
    let (orbit, _) = next_return(&mut run).unwrap();
    [orbit.peak, orbit.duration]
}

/// A state on the limit cycle, in f64: the start of reference returns.
fn section(model: &Model<f64>) -> State<f64> {
    let control = Control { local_tolerance: 1e-9, most_steps: 1_000_000 };
    let start = Start::default().at_a_tenth(model);
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control).unwrap();
    long_term_behaviour(&mut run, 1e-9, 1000).unwrap();
    *run.state()
}

/// The reference is Radau IIA of order 13 in double-double at 1e-22, where f64 methods differ by 1e-12 and less.
#[test]
fn every_method_reaches_the_double_double_reference() {
    for (v, s) in [(-5.5, 6.5), (-1.5, 4.0)] {
        for law in EvolutionLaw::ALL {
            let model = Model::new(paper_groups(v, s), law);
            let fine = Model::new(paper_groups(v, s).map(|&g| Dd::from(g)), law);
            let start = section(&model);
            let exact = return_from(&fine, Radau::<Dd, 7>::new(), &start, 1e-20).map(|value| value.to_f64());
            let check = |[peak, duration]: [f64; 2], bound: f64| {
                assert!((peak - exact[0]).abs() < bound, "{v} {s} {law:?}: {peak} {exact:?}");
                assert!((duration / exact[1] - 1.0).abs() < bound, "{v} {s} {law:?}: {duration} {exact:?}");
            };
            check(return_from(&model, Radau::<f64, 3>::new(), &start, 1e-10), 1e-11);
            check(return_from(&model, Radau::<f64, 5>::new(), &start, 1e-9), 1e-11);
            check(return_from(&model, Radau::<f64, 7>::new(), &start, 1e-8), 1e-11);
            check(return_from(&model, Rodas5P::<f64>::new(), &start, 1e-10), 1e-9);
            if v == -1.5 {
                check(return_from(&model, Taylor::<f64, 20>::new(), &start, 1e-11), 1e-10);
            }
        }
    }
}

#[test]
fn double_double_and_mpfr_agree_beyond_f64() {
    let model = Model::new(paper_groups(-1.5, 4.0), EvolutionLaw::Aging);
    let start = section(&model);
    let fine = Model::new(model.groups().map(|&g| Dd::from(g)), EvolutionLaw::Aging);
    let finest = Model::new(model.groups().map(|&g| Multi::<160>::from_f64(g)), EvolutionLaw::Aging);
    let [peak, duration] = return_from(&fine, Radau::<Dd, 7>::new(), &start, 1e-22);
    let [reference, reference_duration] =
        return_from(&finest, Taylor::<Multi<160>, 40>::new(), &start, 1e-30);
    let difference = |value: Dd, exact: Multi<160>| {
        (Multi::<160>::from_f64(value.hi()) + Multi::from_f64(value.lo()) - exact).to_f64().abs()
    };
    assert!(difference(peak, reference) < 1e-22);
    assert!(difference(duration, reference_duration) < 1e-19);
}
