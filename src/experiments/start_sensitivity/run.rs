//! What the unstated part of the paper's start decides: every completion of V = V_l/10 at a few points, with both laws.

use crate::parallel;

use crate::experiments::start_sensitivity::StartSensitivitySection;
use crate::scene::PlanePoint;
use slipmode_core::dynamics::{
    Control, Failure, Integrator, Model, Options, Radau, ReturnEnd, Simulation, Start, next_return, simulate,
};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

/// Local tolerances of the first peak: the finer run is reported, the difference is its error.
const TOLERANCES: [f64; 2] = [1e-9, 1e-10];

/// Most steps of one run to its first peak.
const MOST_STEPS: u64 = 1_000_000;

/// The part of ln(V/V_l) at the start below which the velocity counts as back at V_l.
const BACK: f64 = 0.01;

/// The early part of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Early {
    /// Largest ln(V/V_l) before the second upward crossing of V = V_l; none when the velocity has no maximum until then.
    pub first_log_peak: Option<f64>,
    /// Time until |ln(V/V_l)| first is below 1 % of its start, D_c/V_l.
    pub time_back: f64,
    /// The larger of |ln(V_l θ/D_c)| and the spring's distance from steady sliding in units of aσ at that moment.
    pub left_over: f64,
}

/// One run.
#[derive(Debug, Clone)]
pub struct StartRun {
    /// How V_l/10 was completed.
    pub start: Start,
    /// Its early part, and the error of the first log peak.
    pub early: Result<(Early, f64), Failure>,
    /// Its long-term behaviour.
    pub long_term: Result<Simulation, Failure>,
}

/// The runs of one point with one law.
#[derive(Debug, Clone)]
pub struct StartGroup {
    /// V_l, m/s.
    pub loading_velocity_m_per_s: f64,
    /// σ, Pa.
    pub normal_stress_pa: f64,
    /// The law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: f64,
    /// K/K_c; none where there is no transition (a ≥ b).
    pub stiffness_over_critical: Option<f64>,
    /// The slip mode of the exact theory.
    pub slip_mode: SlipMode,
    /// One run for each completion, in the order of [`Start::ALL`].
    pub runs: Vec<StartRun>,
}

/// Runs every completion of the start.
pub(crate) fn start_sensitivity(
    parameters: &Slider<Rational>,
    section: &StartSensitivitySection,
    threshold: &InertialThreshold,
) -> Vec<StartGroup> {
    let cases: Vec<(&PlanePoint, EvolutionLaw)> =
        section.points.iter().flat_map(|point| section.laws.iter().map(move |&law| (point, law))).collect();
    parallel::map(&cases, |&(point, law)| group(parameters, section, threshold, point, law))
}

fn group(
    parameters: &Slider<Rational>,
    section: &StartSensitivitySection,
    threshold: &InertialThreshold,
    PlanePoint { loading_velocity_m_per_s: velocity, normal_stress_pa: stress }: &PlanePoint,
    law: EvolutionLaw,
) -> StartGroup {
    let point = parameters.at(stress.clone(), velocity.clone());
    let groups = point.groups().map(nearest_f64);
    let model = Model::new(groups.clone(), law);
    let tolerance = nearest_f64(&section.tolerance);
    let run = |start: Start| StartRun {
        start,
        early: early(&model, start),
        long_term: simulate(&point, law, &Options { start, ..Options::at(tolerance) }),
    };
    let ratio = || nearest_f64(&(point.slider.stiffness_pa_per_m.clone() / point.critical_stiffness()));
    StartGroup {
        loading_velocity_m_per_s: nearest_f64(velocity),
        normal_stress_pa: nearest_f64(stress),
        law,
        inertial_parameter: groups.inertial_parameter,
        stiffness_over_critical: parameters.has_transition().then(ratio),
        slip_mode: classify(&point, threshold).slip_mode,
        runs: parallel::map(&Start::ALL, |&start| run(start)),
    }
}

fn early(model: &Model<f64>, start: Start) -> Result<(Early, f64), Failure> {
    let [coarse, fine] = TOLERANCES.map(|tolerance| early_at(model, start, tolerance));
    let (coarse, fine) = (coarse?, fine?);
    let difference = coarse.first_log_peak.zip(fine.first_log_peak).map_or(0.0, |(a, b)| (a - b).abs());
    Ok((fine, 2.0 * difference + 100.0 * f64::EPSILON))
}

fn early_at(model: &Model<f64>, start: Start, local_tolerance: f64) -> Result<Early, Failure> {
    let control = Control { local_tolerance, most_steps: MOST_STEPS };
    let state = start.at_a_tenth(model);
    let (time_back, left_over) =
        back(&mut Integrator::new(model, Radau::<f64, 5>::new(), state, control)?, state[0])?;
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), state, control)?;
    let (mut orbit, end) = next_return(&mut run)?;
    if end == ReturnEnd::Crossing {
        orbit = orbit.joined(next_return(&mut run)?.0);
    }
    // Without a maximum, the start or the end is the largest x.
    let first_log_peak = (orbit.peak > state[0]).then_some(orbit.peak);
    Ok(Early { first_log_peak, time_back, left_over })
}

/// When |x| first falls below its part of the start, and what y and ζ are then, from the step's polynomial.
fn back(run: &mut Integrator<'_, f64, Radau<f64, 5>>, start: f64) -> Result<(f64, f64), Failure> {
    let near = |x: f64| x.abs() < BACK * start.abs() || (x < 0.0) != (start < 0.0);
    loop {
        run.advance(None)?;
        if !near(run.state()[0]) {
            continue;
        }
        let at = |theta: f64| run.state_within(&theta);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if near(at(middle)[0]) { high = middle } else { low = middle }
        }
        let [_, y, zeta] = at(high);
        return Ok((run.time() - (1.0 - high) * run.step(), y.abs().max(zeta.abs())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::dynamics::Behaviour;
    use slipmode_core::number::parse_decimal;

    fn groups_at(velocity: &str, stress: &str) -> Vec<StartGroup> {
        let decimal = |text| parse_decimal(text).unwrap();
        let parameters = paper();
        let section = StartSensitivitySection {
            points: vec![PlanePoint {
                loading_velocity_m_per_s: decimal(velocity),
                normal_stress_pa: decimal(stress),
            }],
            laws: EvolutionLaw::ALL.to_vec(),
            tolerance: decimal("1e-8"),
        };
        start_sensitivity(&parameters, &section, &InertialThreshold::default())
    }

    #[test]
    fn the_limit_cycle_forgets_its_start_and_the_first_peak_does_not() {
        for group in groups_at("1e-5", "1e6") {
            let long_term: Vec<&Simulation> =
                group.runs.iter().map(|run| run.long_term.as_ref().unwrap()).collect();
            for run in &long_term {
                let off = (run.peak_velocity_m_per_s / long_term[0].peak_velocity_m_per_s - 1.0).abs();
                assert_eq!(run.behaviour, Behaviour::Periodic);
                assert!(off <= run.peak_relative_error + long_term[0].peak_relative_error, "{off:e}");
            }
            let first = |i: usize| group.runs[i].early.as_ref().unwrap().0.first_log_peak.unwrap();
            assert!((first(0) - first(2)).abs() > 0.01, "{} {}", first(0), first(2));
        }
    }

    #[test]
    fn a_kick_of_the_velocity_alone_is_over_within_a_few_inertial_times_and_leaves_as_little_behind() {
        for group in groups_at("1e-5", "1e6") {
            let eta = group.inertial_parameter;
            for run in &group.runs {
                let (early, _) = run.early.as_ref().unwrap();
                let kick = run.start == Start::VelocityKick;
                assert_eq!(early.time_back < 10.0 * eta, kick, "{:?} {}", run.start, early.time_back);
                assert_eq!(early.left_over < 10.0 * eta, kick, "{:?} {}", run.start, early.left_over);
            }
        }
    }
}
