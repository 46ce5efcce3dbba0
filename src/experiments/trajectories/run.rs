//! The nonlinear slider followed from its start at named points (figs 3b to 3g and 6b to 6d), thinned for drawing.

use crate::parallel;

use crate::experiments::trajectories::{TrajectoriesSection, TrajectoryPoint};
use slipmode_core::dynamics::{
    Control, Failure, Model, Options, Radau, Sample, Simulation, State, simulate, trajectory,
};
use slipmode_core::friction::{EvolutionLaw, Parameters, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::{Classification, InertialThreshold, classify};
use slipmode_plot::figure::kept;

/// One run at a named point.
#[derive(Debug, Clone)]
pub struct TrajectoryRun {
    /// The point, as the scene states it.
    pub point: TrajectoryPoint,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// The exact classification of the linear theory.
    pub theory: Classification,
    /// What the whole run showed, with its errors, or why it has no result.
    pub simulation: Result<Simulation, Failure>,
    /// The run as it is drawn, or why it stopped.
    pub course: Result<Course, Failure>,
}

/// A run as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// The moments that a drawing needs, in order of time: those left out lie within [`DRAWING_TOLERANCE`] of the line through them.
    pub moments: Vec<Moment>,
    /// Steps of the integrator's polynomial that were sampled.
    pub sampled: usize,
    /// Largest difference between the spring stress as integrated and as it follows from the slip integrated apart, Pa.
    pub free_residual_pa: f64,
}

/// The slider at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Time since the start, s.
    pub time_s: f64,
    /// ln(V/V_l).
    pub log_velocity_ratio: f64,
    /// Shear stress beyond that of steady sliding at V_l, Pa.
    pub stress_change_pa: f64,
}

/// How far the line through the moments kept may pass from one left out, as a share of the curve's extent: half a
/// pixel of a figure 500 pixels wide.
pub const DRAWING_TOLERANCE: f64 = 1e-3;
/// Samples of a step: the steps of a method of order 9 are too long for a smooth line.
const SAMPLES_PER_STEP: usize = 12;
/// Most steps of a run that is drawn.
const MOST_STEPS: u64 = 200_000;

/// Follows every point of the section with each of its laws.
pub(crate) fn trajectories(
    parameters: &Slider<Rational>,
    section: &TrajectoriesSection,
    threshold: &InertialThreshold,
) -> Vec<TrajectoryRun> {
    let options = Options::at(nearest_f64(&section.tolerance));
    let runs: Vec<(&TrajectoryPoint, EvolutionLaw)> =
        section.points.iter().flat_map(|point| point.laws.iter().map(move |&law| (point, law))).collect();
    parallel::map(&runs, |&(point, law)| follow(parameters, point, law, threshold, &options))
}

fn follow(
    slider: &Slider<Rational>,
    point: &TrajectoryPoint,
    law: EvolutionLaw,
    threshold: &InertialThreshold,
    options: &Options,
) -> TrajectoryRun {
    let parameters = slider.at(point.normal_stress_pa.clone(), point.loading_velocity_m_per_s.clone());
    let simulation = simulate(&parameters, law, options);
    let course = simulation.as_ref().map_err(Clone::clone).and_then(|found| {
        course(&parameters, law, options, found.local_tolerance, nearest_f64(&point.duration_s))
    });
    TrajectoryRun { point: point.clone(), law, theory: classify(&parameters, threshold), simulation, course }
}

fn course(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    options: &Options,
    local_tolerance: f64,
    duration_s: f64,
) -> Result<Course, Failure> {
    let model = Model::new(parameters.groups().map(nearest_f64), law);
    let rate_per_s = nearest_f64(&parameters.rate_per_s());
    let direct_stress_pa = nearest_f64(&parameters.direct_stress_pa());
    let control = Control { local_tolerance, most_steps: MOST_STEPS };
    let start = options.start.state(&model, &libm::log(options.velocity_ratio));
    let until = duration_s * rate_per_s;
    let run = trajectory(&model, Radau::<f64, 5>::new(), start, control, until, SAMPLES_PER_STEP)?;
    let keep = kept(&places(&run.samples), |_, _, far| far <= DRAWING_TOLERANCE);
    let moment = |sample: &Sample| Moment {
        time_s: sample.time / rate_per_s,
        log_velocity_ratio: sample.state[0],
        stress_change_pa: sample.state[2] * direct_stress_pa,
    };
    let moments = run.samples.iter().zip(keep).filter(|(_, keep)| *keep).map(|(sample, _)| moment(sample));
    Ok(Course {
        moments: moments.collect(),
        sampled: run.samples.len(),
        free_residual_pa: run.free_residual * direct_stress_pa,
    })
}

/// Time, velocity, its logarithm and stress, each from 0 to 1 over the run: what figures draw against each other.
fn places(samples: &[Sample]) -> Vec<[f64; 4]> {
    let place = |sample: &Sample| {
        let [x, _, zeta]: State<f64> = sample.state;
        [sample.time, libm::exp(x), x, zeta]
    };
    let mut places: Vec<[f64; 4]> = samples.iter().map(place).collect();
    for coordinate in 0..4 {
        let values = || places.iter().map(|place| place[coordinate]);
        let least = values().fold(f64::INFINITY, f64::min);
        let extent = values().fold(f64::NEG_INFINITY, f64::max) - least;
        let unit = if extent > 0.0 { extent } else { 1.0 };
        places.iter_mut().for_each(|place| place[coordinate] = (place[coordinate] - least) / unit);
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::dynamics::Behaviour;
    use slipmode_core::number::parse_decimal;

    fn run(stress: &str, velocity: &str, duration: &str) -> TrajectoryRun {
        let decimal = |text| parse_decimal(text).unwrap();
        let parameters = paper();
        let point = TrajectoryPoint {
            id: "point".into(),
            normal_stress_pa: decimal(stress),
            loading_velocity_m_per_s: decimal(velocity),
            laws: vec![EvolutionLaw::Slip],
            duration_s: decimal(duration),
        };
        let section = TrajectoriesSection { tolerance: decimal("1e-8"), points: vec![point] };
        trajectories(&parameters, &section, &InertialThreshold::default()).remove(0)
    }

    #[test]
    fn the_drawn_curve_of_a_limit_cycle_has_the_peak_and_the_stress_drop_of_the_cycle() {
        let run = run("1e5", "1e-5", "150");
        let (found, course) = (run.simulation.unwrap(), run.course.unwrap());
        assert_eq!(found.behaviour, Behaviour::Periodic);
        let period = found.period_s.unwrap();
        let last = || course.moments.iter().filter(|moment| moment.time_s > 150.0 - period);
        let peak = last().map(|moment| moment.log_velocity_ratio).fold(f64::NEG_INFINITY, f64::max);
        let highest = last().map(|moment| moment.stress_change_pa).fold(f64::NEG_INFINITY, f64::max);
        let lowest = last().map(|moment| moment.stress_change_pa).fold(f64::INFINITY, f64::min);
        // What thinning may leave out, as a share of the extent: the peak is the extent of the velocity itself.
        let exact_peak = libm::log(found.peak_velocity_m_per_s / 1e-5);
        assert!((peak - exact_peak).abs() < 4.0 * DRAWING_TOLERANCE, "{peak} {exact_peak}");
        let drop = highest - lowest;
        assert!((drop / found.stress_drop_pa - 1.0).abs() < 4.0 * DRAWING_TOLERANCE, "{drop}");
        assert!(course.moments.len() * 2 < course.sampled && course.free_residual_pa < 1e-10 * 1e5);
    }

    #[test]
    fn a_course_ends_at_its_duration_and_starts_at_a_tenth_of_the_loading_velocity() {
        let course = run("1e3", "3e-4", "0.4").course.unwrap();
        let (first, last) = (course.moments[0], course.moments.last().unwrap());
        assert_eq!((first.time_s, first.log_velocity_ratio), (0.0, libm::log(0.1)));
        assert!((last.time_s / 0.4 - 1.0).abs() < 1e-12);
        // Steady sliding at a tenth: (a - b) sigma ln(1/10).
        assert!((first.stress_change_pa - 2.0 * std::f64::consts::LN_10).abs() < 1e-12);
    }
}
