//! One simulation, ended by observables that are numbers or by a reason in words.

use crate::cli::simulate::range;
use slipmode::csv::{Column, Datum};
use slipmode_core::dynamics::{
    self, Control, Failure, Model, Options, Radau, Sample, Simulation, trajectory, trajectory_at,
};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::{Rational, nearest_f64};

/// Samples of a step: the steps of a method of order 9 are too long for a smooth line.
const SAMPLES_PER_STEP: usize = 8;
/// Most steps of a trajectory, so that its samples stay below half a gigabyte.
const MOST_STEPS: u64 = 1_000_000;

/// What a simulation showed, or why it showed nothing.
pub type Shown = Result<Simulation, String>;

/// Simulates a point.
pub fn simulate_point(parameters: &Parameters<Rational>, law: EvolutionLaw, options: Options) -> Shown {
    let found = dynamics::simulate(parameters, law, &options);
    let simulation = found.map_err(|failure| failure.to_string())?;
    let positive = [Some(simulation.peak_velocity_m_per_s), simulation.period_s, simulation.frequency_hz];
    if positive.into_iter().flatten().all(f64::is_normal) && simulation.stress_drop_pa.is_finite() {
        Ok(simulation)
    } else {
        Err("peak velocity, period or stress drop is beyond the range of 64-bit numbers".into())
    }
}

/// Integrates from the start again until a time of the model, as accurately as the finest run of the simulation: the samples of
/// its steps, or so many at equal steps of time, both ends included.
///
/// # Errors
/// When the integrator fails.
pub fn follow(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    options: Options,
    simulation: &Simulation,
    (until, count): (f64, Option<u64>),
) -> Result<Vec<Sample>, Failure> {
    let model = Model::new(parameters.groups().map(nearest_f64), law);
    let control = Control { local_tolerance: simulation.local_tolerance, most_steps: MOST_STEPS };
    let start = options.start.state(&model, &libm::log(options.velocity_ratio));
    let method = Radau::<f64, 5>::new();
    let Some(count) = count else {
        return Ok(trajectory(&model, method, start, control, until, SAMPLES_PER_STEP)?.samples);
    };
    let last = (count - 1) as f64;
    let times: Vec<f64> = (0..count).map(|index| until * (index as f64 / last)).collect();
    trajectory_at(&model, method, start, control, &times)
}

/// A point that was simulated.
#[derive(Debug)]
pub struct Simulated {
    /// The simulation, or why there is none.
    pub found: Shown,
    /// Whether a group lies outside the ranges over which simulations were tested.
    pub outside_tested_range: bool,
}

impl Simulated {
    /// What is reported of a simulation with these parameters.
    pub fn new(found: Shown, parameters: &Parameters<Rational>) -> Self {
        Self { found, outside_tested_range: range::outside_tested(parameters).next().is_some() }
    }
}

/// The appended columns, which are also the keys of the object of one point; without a result all but the last two are empty.
pub const COLUMNS: [Column<Simulated>; 13] = [
    ("mode", |it| found(it, |run| Datum::Text(run.behaviour.as_str().into()))),
    ("slip_mode", |it| found(it, |run| Datum::Text(run.slip_mode.as_str().into()))),
    ("peak_velocity_m_per_s", |it| found(it, |run| Datum::Number(Some(run.peak_velocity_m_per_s)))),
    ("minimum_velocity_log10_ratio", |it| {
        found(it, |run| Datum::Number(Some(run.minimum_velocity_log10_ratio)))
    }),
    ("period_s", |it| found(it, |run| Datum::Number(run.period_s))),
    ("stress_drop_pa", |it| found(it, |run| Datum::Number(Some(run.stress_drop_pa)))),
    ("frequency_hz", |it| found(it, |run| Datum::Number(run.frequency_hz))),
    ("peak_relative_error", |it| found(it, |run| Datum::Number(Some(run.peak_relative_error)))),
    ("period_relative_error", |it| found(it, |run| Datum::Number(run.period_relative_error))),
    ("steps", |it| found(it, |run| Datum::Count(run.steps))),
    ("evaluations", |it| found(it, |run| Datum::Count(run.evaluations))),
    ("outside_tested_range", |answer| Datum::Flag(answer.outside_tested_range)),
    ("status", |answer| Datum::Text(answer.found.as_ref().err().map_or(ANSWERED, String::as_str).into())),
];

/// The status of a simulation that has an answer.
const ANSWERED: &str = "ok";

fn found(simulated: &Simulated, datum: fn(&Simulation) -> Datum) -> Datum {
    simulated.found.as_ref().map_or(Datum::Number(None), datum)
}
