//! The simulations as the N claims read them: complete grids, neighbours on them, and error estimates.

use crate::claims::Finding;
use crate::experiments::simulations::{RunCourse, SimulatedPoint, SimulationsOutcome};
use crate::experiments::{Context, Outcome, SceneOutcome};
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;

/// One simulated point.
pub(super) struct Run<'c> {
    pub(super) velocity_m_per_s: f64,
    pub(super) normal_stress_pa: f64,
    pub(super) simulation: &'c Simulation,
    pub(super) course: Option<&'c RunCourse>,
    /// η.
    pub(super) inertial_parameter: f64,
}

/// The complete grid of one law, row by row of constant normal stress.
pub(super) struct Runs<'c> {
    pub(super) law: EvolutionLaw,
    pub(super) runs: Vec<Run<'c>>,
    columns: usize,
}

/// The scene whose simulations a claim is about.
pub(super) type Pick = fn(&Outcome) -> Option<&SceneOutcome>;

/// The simulations of a scene.
pub(super) fn outcome<'c>(context: &'c Context, pick: Pick) -> Result<&'c SimulationsOutcome, Finding> {
    pick(context.outcome)
        .and_then(|scene| scene.simulations.as_ref())
        .ok_or_else(|| Finding::not_checked("The report has no simulations of this slider."))
}

/// The grids of a scene, if every run has a result: a claim on every simulation cannot be decided when runs failed.
pub(super) fn grids<'c>(context: &'c Context, pick: Pick) -> Result<Vec<Runs<'c>>, Finding> {
    outcome(context, pick)?
        .grids
        .iter()
        .map(|(law, grid)| {
            let run =
                |(velocity_m_per_s, normal_stress_pa, point): (f64, f64, &'c SimulatedPoint)| match &point
                    .simulation
                {
                    Ok(simulation) => Ok(Run {
                        velocity_m_per_s,
                        normal_stress_pa,
                        simulation,
                        course: point.course.as_ref(),
                        inertial_parameter: point.inertial_parameter,
                    }),
                    Err(failure) => Err(Finding::not_checked(format!(
                        "A run with the {} law has no result: {failure}",
                        law.as_str()
                    ))),
                };
            let runs = grid.points().map(run).collect::<Result<Vec<_>, _>>()?;
            Ok(Runs { law: *law, runs, columns: grid.loading_velocity_m_per_s.len() })
        })
        .collect()
}

impl Run<'_> {
    pub(super) fn periodic(&self) -> bool {
        self.simulation.behaviour == Behaviour::Periodic
    }

    /// Where the run lies, for people.
    pub(super) fn place(&self) -> String {
        format!(
            "σ = {} Pa, V_l = {} m/s",
            round_digits(self.normal_stress_pa, 4),
            round_digits(self.velocity_m_per_s, 4)
        )
    }
}

impl<'c> Runs<'c> {
    /// The rows of constant normal stress.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[Run<'c>]> {
        self.runs.chunks(self.columns)
    }
}

/// The slider of the simulations in 64 bits.
pub(super) fn slider(context: &Context) -> Result<Slider<f64>, Finding> {
    let scene = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    scene
        .map(|slider| slider.map(nearest_f64))
        .ok_or_else(|| Finding::not_checked("The scene has no parameters."))
}

/// Least and greatest of some numbers.
pub(super) fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

pub(super) fn range((low, high): (f64, f64), digits: usize) -> String {
    format!("{} to {}", round_digits(low, digits), round_digits(high, digits))
}
