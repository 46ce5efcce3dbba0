//! Work against error of the integrators on one period of the limit cycle, by counts that no machine changes.
//!
//! Every method runs one return from the same state on V = V_l. The reference is Radau IIA of order 13 in double-double at
//! a local tolerance of 1e-20.

use rayon::prelude::*;

use crate::experiments::original_scheme::scheme::{highest, model_at};
use crate::experiments::work_precision::WorkPrecisionSection;
use crate::scene::Place;
use slipmode_core::dynamics::{
    Control, Failure, Integrator, LongTerm, Model, OriginalScheme, Radau, Rodas5P, Scalar, Start, State,
    Stepper, Taylor, long_term_behaviour, next_return,
};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Dd, Rational};

/// A return: [ln(V_peak/V_l), duration], and its work.
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

/// One method at one tolerance or step.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkPoint {
    /// The method's name.
    pub method: &'static str,
    /// Local tolerance, or the original scheme's step in units of √(M/K).
    pub setting: f64,
    /// Steps, refused ones included.
    pub steps: u64,
    /// Evaluations of the right-hand side; of the original scheme, Newton iterations.
    pub evaluations: u64,
    /// |error of ln(V_peak/V_l)|.
    pub peak_error: f64,
}

/// One return by all the methods.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkCase {
    /// Where.
    pub place: Place,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// ln(V_peak/V_l) of the return, by the reference.
    pub log_peak: f64,
    /// Method by method from loose to tight; a method that does not finish has no point.
    pub points: Vec<WorkPoint>,
}

/// The most steps of one return.
const MOST_STEPS: u64 = 100_000;

/// The law of the diagram.
const LAW: EvolutionLaw = EvolutionLaw::Slip;

/// One return of a method; none when it does not finish.
#[must_use]
pub fn return_of<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: M,
    section: &State<f64>,
    local_tolerance: f64,
) -> Option<MeasuredReturn<R>> {
    return_within(model, method, section, local_tolerance, MOST_STEPS).ok()
}

/// One return of a method in at most so many steps.
///
/// # Errors
/// Why it does not finish.
pub(crate) fn return_within<R: Scalar, M: Stepper<R> + Clone>(
    model: &Model<R>,
    method: M,
    section: &State<f64>,
    local_tolerance: f64,
    most_steps: u64,
) -> Result<MeasuredReturn<R>, Failure> {
    let control = Control { local_tolerance, most_steps };
    let start: State<R> = std::array::from_fn(|i| R::from_f64(section[i]));
    let mut run = Integrator::new(model, method, start, control)?;
    let (orbit, _) = next_return(&mut run)?;
    let (accepted, refused) = run.step_counts();
    let evaluations = run.method().evaluations();
    Ok(MeasuredReturn { peak: orbit.peak, duration: orbit.duration, steps: accepted + refused, evaluations })
}

/// A method: its name, and its return from a state at a local tolerance.
pub type NamedMethod = (&'static str, fn(&Model<f64>, &State<f64>, f64) -> Option<MeasuredReturn<f64>>);

/// The methods of the diagram.
#[must_use]
pub fn return_methods() -> [NamedMethod; 5] {
    [
        ("Rodas5P", |model, section, local| return_of(model, Rodas5P::new(), section, local)),
        ("Radau IIA 5", |model, section, local| return_of(model, Radau::<f64, 3>::new(), section, local)),
        ("Radau IIA 9", |model, section, local| return_of(model, Radau::<f64, 5>::new(), section, local)),
        ("Radau IIA 13", |model, section, local| return_of(model, Radau::<f64, 7>::new(), section, local)),
        ("Taylor 20", |model, section, local| return_of(model, Taylor::<f64, 20>::new(), section, local)),
    ]
}

/// The state on V = V_l that the limit cycle passes, and the reference return from there; none without a limit cycle.
#[must_use]
pub fn reference_return(model: &Model<f64>) -> Option<(State<f64>, MeasuredReturn<f64>)> {
    let control = Control { local_tolerance: 1e-9, most_steps: 10_000_000 };
    let start = Start::default().at_a_tenth(model);
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control).ok()?;
    let Ok(LongTerm::Cycle(_)) = long_term_behaviour(&mut run, 1e-9, 10_000) else { return None };
    let section = *run.state();
    let fine = Model::new(model.groups().map(|&group| Dd::from(group)), model.law());
    let orbit = return_of(&fine, Radau::<Dd, 7>::new(), &section, 1e-20)?;
    let rounded = MeasuredReturn {
        peak: orbit.peak.to_f64(),
        duration: orbit.duration.to_f64(),
        steps: orbit.steps,
        evaluations: orbit.evaluations,
    };
    Some((section, rounded))
}

/// All methods on all returns of the section.
#[must_use]
pub fn work_precision(parameters: &Slider<Rational>, section: &WorkPrecisionSection) -> Vec<WorkCase> {
    section.places.par_iter().filter_map(|place| work_case(parameters, place)).collect()
}

fn work_case(parameters: &Slider<Rational>, place: &Place) -> Option<WorkCase> {
    let (velocity, stress) = (place.loading_velocity_m_per_s.clone(), place.normal_stress_pa.clone());
    let model = model_at(parameters, velocity, stress, LAW);
    let (section, exact) = reference_return(&model)?;
    let tolerances = [3, 4, 5, 6, 7, 8, 9, 10, 11, 12].map(|digits| libm::exp10(-f64::from(digits)));
    let adaptive = return_methods().into_iter().flat_map(|(method, orbit)| {
        let (model, section) = (&model, &section);
        // Tighter than a tolerance that does not finish, no other does.
        tolerances.into_iter().map_while(move |setting| {
            let orbit = orbit(model, section, setting)?;
            Some(work_point(method, setting, &orbit, &exact))
        })
    });
    let fixed = [0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003125].into_iter().map_while(|setting| {
        let orbit = scheme_return(&model, section, exact.duration, setting)?;
        Some(work_point("original scheme", setting, &orbit, &exact))
    });
    let points = adaptive.chain(fixed).collect();
    Some(WorkCase { place: place.clone(), law: LAW, log_peak: exact.peak, points })
}

fn work_point(
    method: &'static str,
    setting: f64,
    orbit: &MeasuredReturn<f64>,
    exact: &MeasuredReturn<f64>,
) -> WorkPoint {
    let peak_error = (orbit.peak - exact.peak).abs();
    WorkPoint { method, setting, steps: orbit.steps, evaluations: orbit.evaluations, peak_error }
}

/// One return of the original scheme; its peak lies between steps by a parabola. None when it needs too many steps.
fn scheme_return(
    model: &Model<f64>,
    section: State<f64>,
    duration: f64,
    fraction: f64,
) -> Option<MeasuredReturn<f64>> {
    let mut scheme = OriginalScheme::new(model, section, fraction);
    let steps = libm::ceil(duration / scheme.step());
    if steps > MOST_STEPS as f64 {
        return None;
    }
    let steps = steps as u64;
    let peak = highest(&mut scheme, steps).ok()?;
    Some(MeasuredReturn { peak, duration, steps, evaluations: scheme.iterations() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::Groups;

    #[test]
    fn order_nine_reaches_ten_digits_of_a_harmonic_return_with_fewer_evaluations_than_order_five() {
        let groups = Groups { inertial_parameter: 79.06, stiffness_group: 0.7906, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let (section, exact) = reference_return(&model).unwrap();
        let five = return_of(&model, Radau::<f64, 3>::new(), &section, 1e-9).unwrap();
        let nine = return_of(&model, Radau::<f64, 5>::new(), &section, 1e-6).unwrap();
        assert!((nine.peak - exact.peak).abs() < 1e-10, "{:e}", nine.peak - exact.peak);
        assert!((five.peak - exact.peak).abs() < 1e-8, "{:e}", five.peak - exact.peak);
        assert!(nine.evaluations < five.evaluations);
    }
}
