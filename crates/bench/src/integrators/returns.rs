//! One return of a method: from a state on V = V_l to the next upward crossing of V = V_l.

use super::Rodas5P;
use slipmode_core::dynamics::{
    Control, Failure, Integrator, LongTerm, Model, Radau, Scalar, Start, State, Stepper, Taylor,
    long_term_behaviour, next_return,
};
use slipmode_core::number::Dd;

/// A return, and its work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredReturn<R> {
    /// ln(V_peak/V_l).
    pub peak: R,
    /// Duration, D_c/V_l.
    pub duration: R,
    /// Steps, refused ones included.
    pub steps: u64,
    /// Evaluations of the right-hand side; of the original scheme, Newton iterations.
    pub evaluations: u64,
}

/// A method: its name, and its return from a state.
pub type ReturnMethod =
    (&'static str, fn(&Model<f64>, &State<f64>, Control) -> Result<MeasuredReturn<f64>, Failure>);

/// The methods, those of the library and two others.
pub const METHODS: [ReturnMethod; 5] = [
    ("Rodas5P", |model, start, control| return_of(model, Rodas5P::new(), start, control)),
    ("Radau IIA 5", |model, start, control| return_of(model, Radau::<f64, 3>::new(), start, control)),
    ("Radau IIA 9", |model, start, control| return_of(model, Radau::<f64, 5>::new(), start, control)),
    ("Radau IIA 13", |model, start, control| return_of(model, Radau::<f64, 7>::new(), start, control)),
    ("Taylor 20", |model, start, control| return_of(model, Taylor::<f64, 20>::new(), start, control)),
];

fn return_of<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: M,
    start: &State<f64>,
    control: Control,
) -> Result<MeasuredReturn<R>, Failure> {
    let start: State<R> = std::array::from_fn(|i| R::from_f64(start[i]));
    let mut run = Integrator::new(model, method, start, control)?;
    let (orbit, _) = next_return(&mut run)?;
    let (accepted, refused) = run.step_counts();
    let evaluations = run.method().evaluations();
    Ok(MeasuredReturn { peak: orbit.peak, duration: orbit.duration, steps: accepted + refused, evaluations })
}

/// The most steps of a return, where nothing else is stated.
pub(super) const MOST_STEPS: u64 = 100_000;

/// The state on V = V_l that the limit cycle passes, and the reference return from there: Radau IIA of order 13 in double-double
/// at a local tolerance of 1e-20. None without a limit cycle.
#[must_use]
pub fn reference_return(model: &Model<f64>) -> Option<(State<f64>, MeasuredReturn<f64>)> {
    let control = Control { local_tolerance: 1e-9, most_steps: 10_000_000 };
    let start = Start::default().at_a_tenth(model);
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control).ok()?;
    let Ok(LongTerm::Cycle(_)) = long_term_behaviour(&mut run, 1e-9, 10_000) else { return None };
    let section = *run.state();
    let fine = Model::new(model.groups().map(|&group| Dd::from(group)), model.law());
    let control = Control { local_tolerance: 1e-20, most_steps: MOST_STEPS };
    let orbit = return_of(&fine, Radau::<Dd, 7>::new(), &section, control).ok()?;
    let rounded = MeasuredReturn {
        peak: orbit.peak.to_f64(),
        duration: orbit.duration.to_f64(),
        steps: orbit.steps,
        evaluations: orbit.evaluations,
    };
    Some((section, rounded))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::{EvolutionLaw, Groups};

    #[test]
    fn order_nine_reaches_ten_digits_of_a_harmonic_return_with_fewer_evaluations_than_order_five() {
        let groups = Groups { inertial_parameter: 79.06, stiffness_group: 0.7906, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let (section, exact) = reference_return(&model).unwrap();
        let control = |local_tolerance| Control { local_tolerance, most_steps: MOST_STEPS };
        let five = return_of(&model, Radau::<f64, 3>::new(), &section, control(1e-9)).unwrap();
        let nine = return_of(&model, Radau::<f64, 5>::new(), &section, control(1e-6)).unwrap();
        assert!((nine.peak - exact.peak).abs() < 1e-10, "{:e}", nine.peak - exact.peak);
        assert!((five.peak - exact.peak).abs() < 1e-8, "{:e}", five.peak - exact.peak);
        assert!(nine.evaluations < five.evaluations);
    }
}
