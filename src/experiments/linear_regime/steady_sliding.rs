//! Steady sliding over a million time units, and the stress of a run against its slip integrated apart.

use crate::parallel;

use crate::experiments::linear_regime::LinearRegimeSection;
use crate::scene::PlanePoint;
use slipmode_core::dynamics::{Control, Failure, Integrator, Model, Radau, Start, State, trajectory};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};

/// How long steady sliding is watched, D_c/V_l.
const WATCHED: f64 = 1e6;

/// The longest step in that time: left to itself the method would cross it in twenty.
const LONGEST_STEP: f64 = 1e3;

/// How long a disturbed start is watched, D_c/V_l, unless it has died before: a hundred turns of a slow pair.
const DISTURBED_WATCHED: f64 = 1e3;

/// The part of the disturbance below which it has died.
const DEAD: f64 = 1e-6;

/// A start that differs from steady sliding by rounding alone: 2^-52 in each variable.
const DISTURBANCE: f64 = f64::EPSILON;

/// How long the free residual gathers on the way to a limit cycle and on it, D_c/V_l: more than a cycle of stick-slip, tens of vibration.
const GATHERED: f64 = 1e3;

/// The same for a decay, which is over long before: 1e3 would take the state below the least 64-bit number.
const GATHERED_FROM_DECAY: f64 = 1e2;

/// Local tolerance of the runs.
const TOLERANCE: f64 = 1e-11;

/// Most steps of one run.
const MOST_STEPS: u64 = 2_000_000;

/// What a point and a law showed.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyRun {
    /// V_l, m/s.
    pub loading_velocity_m_per_s: f64,
    /// σ, Pa.
    pub normal_stress_pa: f64,
    /// The law.
    pub law: EvolutionLaw,
    /// Largest of |x|, |y|, |ζ| at any step of a run that starts in steady sliding.
    pub departure: f64,
    /// The same for a start disturbed by 2^-52 in each variable, over that disturbance; none where steady sliding is unstable.
    pub disturbed_over_disturbance: Option<f64>,
    /// Largest |spring stress − what loading and the separately integrated slip leave of it| over σ, from the paper's start.
    pub free_residual_over_normal_stress: f64,
}

/// Watches steady sliding and gathers the free residual at every point with every law.
pub(crate) fn steady_sliding(
    parameters: &Slider<Rational>,
    section: &LinearRegimeSection,
) -> Vec<Result<SteadyRun, Failure>> {
    let cases: Vec<(&PlanePoint, EvolutionLaw)> =
        section.points.iter().flat_map(|point| section.laws.iter().map(move |&law| (point, law))).collect();
    parallel::map(&cases, |&(point, law)| run_case(parameters, point, law))
}

fn run_case(
    parameters: &Slider<Rational>,
    PlanePoint { loading_velocity_m_per_s: velocity, normal_stress_pa: stress }: &PlanePoint,
    law: EvolutionLaw,
) -> Result<SteadyRun, Failure> {
    let groups = parameters.at(stress.clone(), velocity.clone()).groups();
    let stable = groups.transition_margin() > 0;
    let model = Model::new(groups.map(nearest_f64), law);
    let disturbed =
        stable.then(|| largest_departure(&model, [DISTURBANCE; 3], DISTURBED_WATCHED)).transpose()?;
    let control = Control { local_tolerance: TOLERANCE, most_steps: MOST_STEPS };
    let until = if stable { GATHERED_FROM_DECAY } else { GATHERED };
    let start = Start::default().at_a_tenth(&model);
    let run = trajectory(&model, Radau::<f64, 5>::new(), start, control, until, 1)?;
    Ok(SteadyRun {
        loading_velocity_m_per_s: nearest_f64(velocity),
        normal_stress_pa: nearest_f64(stress),
        law,
        departure: largest_departure(&model, [0.0; 3], WATCHED)?,
        disturbed_over_disturbance: disturbed.map(|largest| largest / DISTURBANCE),
        free_residual_over_normal_stress: run.free_residual * nearest_f64(&parameters.direct_effect),
    })
}

fn largest_departure(model: &Model<f64>, start: State<f64>, until: f64) -> Result<f64, Failure> {
    let control = Control { local_tolerance: TOLERANCE, most_steps: MOST_STEPS };
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
    let size = |state: &State<f64>| state.iter().fold(0.0f64, |size, component| size.max(component.abs()));
    let began = size(&start);
    let mut largest = began;
    while run.time() < until {
        run.advance(Some(&LONGEST_STEP))?;
        let now = size(run.state());
        largest = largest.max(now);
        if now < DEAD * began {
            break;
        }
    }
    Ok(largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::friction::Groups;
    use slipmode_core::number::parse_decimal;

    #[test]
    fn steady_sliding_is_exact_and_the_residual_far_below_its_bound() {
        let decimal = |text| parse_decimal(text).unwrap();
        let parameters = paper();
        let section = LinearRegimeSection {
            points: ["2e4", "1e6"]
                .map(|stress| PlanePoint {
                    loading_velocity_m_per_s: decimal("1e-5"),
                    normal_stress_pa: decimal(stress),
                })
                .into(),
            laws: EvolutionLaw::ALL.to_vec(),
            amplitudes: Vec::new(),
        };
        let runs = steady_sliding(&parameters, &section);
        assert_eq!(runs.len(), 4);
        for run in runs {
            let run = run.unwrap();
            assert_eq!(run.departure, 0.0);
            let residual = run.free_residual_over_normal_stress;
            assert!(residual > 0.0 && residual < 1e-10, "{residual:e}");
            let grown = run.disturbed_over_disturbance;
            assert_eq!(grown.is_some(), run.normal_stress_pa < 5e4);
            assert!(grown.is_none_or(|grown| grown < 10.0), "{grown:?}");
        }
    }

    #[test]
    fn a_disturbance_of_an_unstable_slider_leaves_steady_sliding() {
        let groups = Groups { inertial_parameter: 0.01, stiffness_group: 0.2, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Slip);
        assert!(largest_departure(&model, [DISTURBANCE; 3], DISTURBED_WATCHED).unwrap() > 1.0);
    }
}
