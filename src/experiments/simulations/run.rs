//! The nonlinear slider simulated on a (V, σ) grid, next to the exact classification of the linear theory (figs 3a and 6).

use crate::parallel;

use crate::experiments::map::run::exactly;
use crate::experiments::shared::Grid;
use crate::experiments::simulations::least_peak::{LeastPeak, least_peaks};
use crate::experiments::simulations::vibration_limit::{StrongVibration, strong_vibrations};
use crate::experiments::simulations::{CYCLE_TOLERANCE, SimulationsSection};
use slipmode_core::dynamics::{
    Behaviour, Estimate, Failure, LongTerm, Model, Options, Outcome, Profile, Simulation, simulate_model,
};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::{Classification, InertialThreshold, classify};

/// One simulation and what the linear theory says of the same point.
#[derive(Debug, Clone)]
pub struct SimulatedPoint {
    /// What the simulation showed, or why it has no result.
    pub simulation: Result<Simulation, Failure>,
    /// Friction and harmonics along the run of a slider with a transition; none where a pass has no result.
    pub course: Option<RunCourse>,
    /// The exact classification.
    pub theory: Classification,
    /// K/K_c; none where there is no transition (a ≥ b).
    pub stiffness_over_critical: Option<f64>,
    /// η.
    pub inertial_parameter: f64,
}

/// What a run shows along its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunCourse {
    /// From the start on: over two periods of the limit cycle, or over the transient of a decay.
    pub from_start: Profile,
    /// Over the limit cycle; none for a decay.
    pub on_cycle: Option<Profile>,
}

/// Local tolerance of the pass from the start.
const START_TOLERANCE: f64 = 1e-7;

impl RunCourse {
    fn of(model: &Model<f64>, long_term: &LongTerm<f64>, options: &Options) -> Result<Self, Failure> {
        let start = options.start.state(model, &libm::log(options.velocity_ratio));
        let from_start = |duration: f64| Profile::of(model, start, duration, START_TOLERANCE);
        match long_term {
            LongTerm::Decay(decay) => {
                Ok(Self { from_start: from_start(decay.transient.duration)?, on_cycle: None })
            }
            LongTerm::Cycle(cycle) => {
                let period = cycle.orbit.duration;
                let on_cycle = Profile::of(model, cycle.from, period, CYCLE_TOLERANCE)?;
                Ok(Self { from_start: from_start(2.0 * period)?, on_cycle: Some(on_cycle) })
            }
        }
    }

    /// Least (μ − μ0)/a by eq 1 from the start on and on the cycle.
    pub(crate) fn least_friction(&self) -> Estimate {
        let passes = [Some(self.from_start), self.on_cycle].into_iter().flatten();
        let least = passes.map(|pass| pass.least_friction).min_by(|a, b| a.value.total_cmp(&b.value));
        least.unwrap_or(self.from_start.least_friction)
    }

    /// Largest x − 2φ from the start on and on the cycle.
    pub(crate) fn regularisation(&self) -> Estimate {
        let start = self.from_start.regularisation;
        let cycle = self.on_cycle.map(|pass| pass.regularisation);
        cycle.filter(|cycle| cycle.value > start.value).unwrap_or(start)
    }
}

/// The simulations of a scene.
#[derive(Debug, Clone)]
pub struct SimulationsOutcome {
    /// One grid for each law, in the order of the scene.
    pub grids: Vec<(EvolutionLaw, Grid<SimulatedPoint>)>,
    /// The velocity of the least peak at each normal stress of the grid that is unstable at every velocity.
    pub least_peaks: Vec<LeastPeak>,
    /// Limit cycles of strong vibration; none where there is no transition.
    pub strong_vibrations: Vec<StrongVibration>,
}

impl SimulatedPoint {
    /// Whether the simulation ended on a limit cycle; none when it failed.
    pub(crate) fn periodic(&self) -> Option<bool> {
        self.simulation.as_ref().ok().map(|simulation| simulation.behaviour == Behaviour::Periodic)
    }

    /// Whether the simulation's slip mode is the theory's; a failed simulation agrees with nothing.
    pub(crate) fn agrees(&self) -> bool {
        self.simulation.as_ref().is_ok_and(|simulation| simulation.slip_mode == self.theory.slip_mode)
    }
}

/// Simulates every point of the section's grid with each law, and the other computations of the section.
pub(crate) fn simulations(
    parameters: &Slider<Rational>,
    section: &SimulationsSection,
    threshold: &InertialThreshold,
) -> SimulationsOutcome {
    let options = Options::at(nearest_f64(&section.tolerance));
    let grid = |&law: &EvolutionLaw| (law, simulate_grid(parameters, section, law, threshold, &options));
    SimulationsOutcome {
        grids: section.laws.iter().map(grid).collect(),
        least_peaks: least_peaks(parameters, section, threshold, &options),
        strong_vibrations: match parameters.has_transition() {
            true => strong_vibrations(nearest_f64(&parameters.effect_ratio()), &section.laws),
            false => Vec::new(),
        },
    }
}

fn simulate_grid(
    parameters: &Slider<Rational>,
    section: &SimulationsSection,
    law: EvolutionLaw,
    threshold: &InertialThreshold,
    options: &Options,
) -> Grid<SimulatedPoint> {
    let velocities = section.rectangle.loading_velocity_m_per_s.coordinates();
    let stresses = section.rectangle.normal_stress_pa.coordinates();
    let row = |&stress: &f64| velocities.iter().map(move |&velocity| (velocity, stress));
    let places: Vec<(f64, f64)> = stresses.iter().flat_map(row).collect();
    let values = parallel::map(&places, |&(velocity, stress)| {
        let point = parameters.at(exactly(stress), exactly(velocity));
        let ratio = || nearest_f64(&(point.slider.stiffness_pa_per_m.clone() / point.critical_stiffness()));
        let groups = point.groups().map(nearest_f64);
        let inertial_parameter = groups.inertial_parameter;
        let model = Model::new(groups, law);
        let outcome = simulate_model(&model, options);
        let course = |found: &Outcome| RunCourse::of(&model, found.long_term(), options).ok();
        SimulatedPoint {
            course: outcome.as_ref().ok().filter(|_| parameters.has_transition()).and_then(course),
            simulation: outcome.map(|found| found.in_si(&point.map(nearest_f64))),
            theory: classify(&point, threshold),
            stiffness_over_critical: parameters.has_transition().then(ratio),
            inertial_parameter,
        }
    });
    Grid { loading_velocity_m_per_s: velocities, normal_stress_pa: stresses, values }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use crate::scene::{LogAxis, Rectangle};
    use slipmode_core::number::parse_decimal;

    fn section(velocity: [&str; 2], stress: [&str; 2]) -> SimulationsSection {
        let axis = |[from, to]: [&str; 2]| LogAxis {
            from: parse_decimal(from).unwrap(),
            to: parse_decimal(to).unwrap(),
            points: 3,
        };
        SimulationsSection {
            rectangle: Rectangle { loading_velocity_m_per_s: axis(velocity), normal_stress_pa: axis(stress) },
            laws: EvolutionLaw::ALL.to_vec(),
            tolerance: parse_decimal("1e-8").unwrap(),
        }
    }

    #[test]
    fn cycles_stand_where_the_stiffness_is_below_critical() {
        let outcome =
            simulations(&paper(), &section(["1e-5", "1e-1"], ["1e3", "1e7"]), &InertialThreshold::default());
        for (law, grid) in &outcome.grids {
            for point in &grid.values {
                let below = point.stiffness_over_critical.unwrap() < 1.0;
                assert_eq!(point.periodic(), Some(below), "{law:?}");
                assert_eq!(below, point.theory.transition_sign < 0);
            }
        }
    }

    #[test]
    fn a_decay_has_the_period_of_the_exact_pair_even_where_the_real_mode_dies_as_slowly() {
        // At 1e-4 m/s and 10^2.75 Pa the real mode is as slow as the pair, and successive returns differ by percents.
        let section = section(["1e-4", "1e-3"], ["5.623413251903491e2", "1e4"]);
        let outcome = simulations(&paper(), &section, &InertialThreshold::default());
        for point in outcome.grids.iter().flat_map(|(_, grid)| &grid.values) {
            let found = point.simulation.as_ref().unwrap();
            let exact = point.theory.max_imaginary_per_s.to_f64().unwrap();
            assert_eq!(found.period_s.is_some(), exact > 0.0);
            if let Some((period, error)) = found.period_s.zip(found.period_relative_error) {
                let deviation = (period * exact / std::f64::consts::TAU - 1.0).abs();
                assert!(deviation < error.max(1e-9), "{deviation:e} {error:e}");
            }
        }
    }
}
