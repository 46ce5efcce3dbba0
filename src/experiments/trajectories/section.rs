//! `[trajectories]`: named points of which the course of the nonlinear slider is drawn.

use crate::scene::laws::read_laws;
use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::{check_points, safe_name};
use crate::scene::{AllowedRange, Faults, Limits, Problem, Quantity, same_name};
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
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerance = section
            .required("tolerance", &range.text(), faults)
            .and_then(|entry| entry.decimal(range, faults));
        let points = section
            .required("point", "a list of points, each under [[trajectories.point]]", faults)
            .and_then(|entry| read_points(&entry, limits, faults));
        section.finish(faults);
        Some(Self { tolerance: tolerance?, points: points? })
    }
}

fn read_points(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Vec<TrajectoryPoint>> {
    let mut ids: Vec<String> = Vec::new();
    let points = entry.list(faults, |member, faults| {
        let point = TrajectoryPoint::read(member, faults)?;
        if ids.iter().any(|id| same_name(id, &point.id)) {
            let of = format!("an earlier id `{}`", point.id);
            faults.push(member.fault(Problem::Duplicate { of, folded: false }));
            return None;
        }
        ids.push(point.id.clone());
        Some(point)
    })?;
    let runs: u64 = points.iter().map(|point| point.laws.len() as u64).sum();
    check_points(entry, runs, limits, faults)?;
    Some(points)
}

impl TrajectoryPoint {
    fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let id = section
            .required("id", "the name of the point", faults)
            .and_then(|entry| safe_name(&entry, faults));
        let range = AllowedRange::PHYSICAL;
        let mut positive =
            |key| section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
        let normal_stress = positive(Quantity::NormalStress.key());
        let loading_velocity = positive(Quantity::LoadingVelocity.key());
        let duration = positive("duration_s");
        let laws = section
            .required("laws", "a list of \"slip\" and \"aging\"", faults)
            .and_then(|entry| read_laws(&entry, faults));
        section.finish(faults);
        Some(Self {
            id: id?,
            normal_stress_pa: normal_stress?,
            loading_velocity_m_per_s: loading_velocity?,
            laws: laws?,
            duration_s: duration?,
        })
    }
}
