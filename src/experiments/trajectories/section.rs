//! `[trajectories]`: named points of which the course of the nonlinear slider is drawn.

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::{AllowedRange, Problem, Quantity, same_name};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[trajectories]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TrajectoriesSection {
    /// Permitted relative error of peak velocity and period of each run.
    pub tolerance: Rational,
    /// The points, in the order of the file.
    pub points: Vec<TrajectoryPoint>,
}

/// `[[trajectories.point]]`: one point of operation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TrajectoryPoint {
    /// The name by which figures and tables refer to the point, safe as a file name.
    pub id: String,
    /// σ, Pa.
    pub normal_stress_pa: Rational,
    /// V_l, m/s.
    pub loading_velocity_m_per_s: Rational,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// How long the run is followed from its start, s.
    pub duration_s: Rational,
}

impl ReadSection for TrajectoriesSection {
    fn read(section: &mut Section<'_>) -> Self {
        let allowed = "a list of points, each under [[trajectories.point]]";
        Self {
            tolerance: section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE),
            points: section.read("point", allowed, read_points),
        }
    }
}

fn read_points(entry: &Entry<'_>) -> Option<Vec<TrajectoryPoint>> {
    let mut ids: Vec<String> = Vec::new();
    let points = entry.list(|member| {
        let point = member.table(TrajectoryPoint::read)?;
        if ids.iter().any(|id| same_name(id, &point.id)) {
            let of = format!("an earlier id `{}`", point.id);
            return member.refuse(Problem::Duplicate { of, folded: false });
        }
        ids.push(point.id.clone());
        Some(point)
    })?;
    entry.check_points(points.iter().map(|point| point.laws.len() as u64).sum())?;
    Some(points)
}

impl TrajectoryPoint {
    fn read(section: &mut Section<'_>) -> Self {
        let [stress, velocity] = [Quantity::NormalStress, Quantity::LoadingVelocity].map(Quantity::as_str);
        Self {
            id: section.name("id", "the name of the point"),
            normal_stress_pa: section.decimal(stress, AllowedRange::PHYSICAL),
            loading_velocity_m_per_s: section.decimal(velocity, AllowedRange::PHYSICAL),
            duration_s: section.decimal("duration_s", AllowedRange::PHYSICAL),
            laws: section.laws(),
        }
    }
}
