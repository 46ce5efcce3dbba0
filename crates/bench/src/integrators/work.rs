//! Work against error of the integrators on one period of the limit cycle, by counts that no machine changes.
//!
//! Every method runs one return from the same state on V = V_l.

use rayon::prelude::*;

use super::returns::{METHODS, MOST_STEPS, MeasuredReturn, reference_return};
use crate::paper::{model_at, paper, place};
use crate::scheme::{OriginalScheme, highest};
use slipmode::scene::PlanePoint;
use slipmode_core::dynamics::{Control, Model, State};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::Rational;

/// Stick-slip, harmonic vibration, and the hard case in which V falls to e^-150 V_l: V_l in m/s and σ in Pa.
const PLACES: [[&str; 2]; 3] = [
    ["3.1622776601683795e-6", "3.1622776601683795e6"],
    ["3.1622776601683795e-2", "1e4"],
    ["1e-1", "3.1622776601683795e2"],
];

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
    pub place: PlanePoint,
    /// Method by method from loose to tight; a method that does not finish has no point.
    pub points: Vec<WorkPoint>,
}

/// All methods on the returns that the report shows, with the slip law.
#[must_use]
pub fn work_precision() -> Vec<WorkCase> {
    let parameters = paper();
    PLACES.par_iter().filter_map(|&written| work_case(&parameters, place(written))).collect()
}

fn work_case(parameters: &Slider<Rational>, place: PlanePoint) -> Option<WorkCase> {
    let model = model_at(parameters, &place, EvolutionLaw::Slip);
    let (section, exact) = reference_return(&model)?;
    let tolerances = [3, 4, 5, 6, 7, 8, 9, 10, 11, 12].map(|digits| libm::exp10(-f64::from(digits)));
    let adaptive = METHODS.into_iter().flat_map(|(method, run)| {
        let (model, section) = (&model, &section);
        // Tighter than a tolerance that does not finish, no other does.
        tolerances.into_iter().map_while(move |local_tolerance| {
            let orbit = run(model, section, Control { local_tolerance, most_steps: MOST_STEPS }).ok()?;
            Some(work_point(method, local_tolerance, &orbit, &exact))
        })
    });
    let fixed = [0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003125].into_iter().map_while(|setting| {
        let orbit = scheme_return(&model, section, exact.duration, setting)?;
        Some(work_point("original scheme", setting, &orbit, &exact))
    });
    let points = adaptive.chain(fixed).collect();
    Some(WorkCase { place, points })
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
