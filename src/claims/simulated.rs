//! The simulations as the N claims read them: complete grids, neighbours on them, and error estimates.

use crate::claims::certified::contradiction;
use crate::claims::{Evidence, Finding};
use crate::experiments::certificates::Certificates;
use crate::experiments::simulations::{RunCourse, SimulatedPoint, SimulationsOutcome};
use crate::experiments::{Context, Outcome, SceneOutcome};
use slipmode_core::dynamics::certified::Certificate;
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::{Classification, SlipMode};

/// One simulated point.
pub(super) struct Run<'c> {
    pub(super) velocity_m_per_s: f64,
    pub(super) normal_stress_pa: f64,
    pub(super) simulation: &'c Simulation,
    pub(super) course: Option<&'c RunCourse>,
    pub(super) theory: &'c Classification,
    /// What is proved at this point.
    pub(super) certificate: Option<&'c Certificate>,
    pub(super) stiffness_over_critical: Option<f64>,
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

/// The certificates of a scene, if it has any.
pub(super) fn certificates<'c>(context: &'c Context, pick: Pick) -> Option<&'c Certificates> {
    pick(context.outcome)?.certificates.as_ref()
}

/// The grids of a scene, if every run has a result: a claim on every simulation cannot be decided when runs failed. Nor can it where
/// a stored certificate is not proved again, or a run contradicts its certificate.
pub(super) fn grids<'c>(context: &'c Context, pick: Pick) -> Result<Vec<Runs<'c>>, Finding> {
    let certificates = certificates(context, pick);
    if let Some(refusal) = certificates.and_then(Certificates::refusal) {
        return Err(Finding::not_checked(refusal));
    }
    let grids: Vec<Runs<'c>> = outcome(context, pick)?
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
                        theory: &point.theory,
                        certificate: certificates
                            .and_then(|all| all.at(*law, velocity_m_per_s, normal_stress_pa)),
                        stiffness_over_critical: point.stiffness_over_critical,
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
        .collect::<Result<_, _>>()?;
    match grids.iter().flat_map(|grid| &grid.runs).find_map(contradiction) {
        Some(reason) => Err(Finding::not_checked(reason)),
        None => Ok(grids),
    }
}

impl Run<'_> {
    pub(super) fn periodic(&self) -> bool {
        self.simulation.behaviour == Behaviour::Periodic
    }

    pub(super) fn is(&self, mode: SlipMode) -> bool {
        self.simulation.slip_mode == mode
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

    /// Neighbouring limit cycles at the same normal stress, the slower loading first.
    pub(super) fn along_velocity(&self) -> impl Iterator<Item = (&Run<'c>, &Run<'c>)> {
        self.rows().flat_map(|row| row.windows(2)).filter_map(both_periodic)
    }

    /// Neighbouring limit cycles at the same loading velocity, the lower normal stress first.
    pub(super) fn along_stress(&self) -> impl Iterator<Item = (&Run<'c>, &Run<'c>)> {
        let above = self.runs.iter().skip(self.columns);
        self.runs.iter().zip(above).filter(|(lower, upper)| lower.periodic() && upper.periodic())
    }

    /// Neighbouring limit cycles on diagonals: the second has the higher velocity and the higher normal stress.
    pub(super) fn along_both(&self) -> impl Iterator<Item = (&Run<'c>, &Run<'c>)> {
        let is_last = |index: usize| (index + 1).is_multiple_of(self.columns);
        let beyond = self.runs.iter().skip(self.columns + 1);
        let pairs = self.runs.iter().zip(beyond).enumerate();
        pairs
            .filter(move |(index, (one, other))| !is_last(*index) && one.periodic() && other.periodic())
            .map(|(_, pair)| pair)
    }
}

fn both_periodic<'r, 'c>(pair: &'r [Run<'c>]) -> Option<(&'r Run<'c>, &'r Run<'c>)> {
    let [first, second] = pair else { return None };
    (first.periodic() && second.periodic()).then_some((first, second))
}

/// The largest error estimate of the runs.
pub(super) fn error_of(grids: &[Runs]) -> String {
    let errors = grids.iter().flat_map(|grid| &grid.runs).map(|run| {
        run.simulation.peak_relative_error.max(run.simulation.period_relative_error.unwrap_or(0.0))
    });
    format!("{} of peak velocity or period", round_digits(errors.fold(0.0, f64::max), 2))
}

/// Evidence from all runs of the grids, with their largest error estimate.
pub(super) fn evidence(grids: &[Runs], quantity: &str, value: String) -> Evidence {
    Evidence::Simulation {
        quantity: quantity.into(),
        value,
        error: error_of(grids),
        runs: grids.iter().map(|grid| grid.runs.len()).sum(),
    }
}

/// `slip: x; aging: y`.
pub(super) fn for_each_law<'c>(grids: &[Runs<'c>], value: impl Fn(&Runs<'c>) -> String) -> String {
    let each: Vec<String> =
        grids.iter().map(|grid| format!("{}: {}", grid.law.as_str(), value(grid))).collect();
    each.join("; ")
}
