//! One simulation, ended by observables that are numbers or by a reason in words.

use slipmode_core::dynamics::{self, Simulation, Start};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;

/// What is the same for every simulation of a command.
#[derive(Debug, Clone, Copy)]
pub struct Settings {
    /// Permitted relative error of peak velocity and period.
    pub tolerance: f64,
    /// How the start is completed.
    pub start: Start,
}

impl Settings {
    /// The options of the simulation.
    pub fn options(self) -> dynamics::Options {
        dynamics::Options::at(self.tolerance).with_start(self.start)
    }
}

/// What a simulation showed, or why it showed nothing.
pub type Found = Result<Simulation, String>;

/// Simulates a point.
pub fn simulate_point(parameters: &Parameters<Rational>, law: EvolutionLaw, settings: Settings) -> Found {
    let found = dynamics::simulate(parameters, law, &settings.options());
    let simulation = found.map_err(|failure| failure.to_string())?;
    let positive = [Some(simulation.peak_velocity_m_per_s), simulation.period_s, simulation.frequency_hz];
    if positive.into_iter().flatten().all(f64::is_normal) && simulation.stress_drop_pa.is_finite() {
        Ok(simulation)
    } else {
        Err("peak velocity, period or stress drop is beyond the range of 64-bit numbers".into())
    }
}
