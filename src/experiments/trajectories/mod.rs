//! The nonlinear slider over time at named points (figs 3b to 3g and 6b to 6d).

pub(crate) mod curves;
pub(crate) mod figures;
pub(crate) mod own_runs;
pub(crate) mod run;
pub(crate) mod tables;

pub(crate) use own_runs::own_run_words;
pub use run::{Course, DRAWING_TOLERANCE, Moment, TrajectoryRun};

use crate::experiments::{Work, experiment};
use crate::scene::section::{Entry, ReadSection, keys};
use crate::scene::{AllowedRange, Problem, same_name};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::{Rational, nearest_f64};

experiment! {
    /// `[trajectories]`: named points of which the course of the nonlinear slider is drawn.
    pub struct TrajectoriesSection {
        /// Permitted relative error of peak velocity and period of each run.
        pub tolerance: Rational = |section, key| section.decimal(key, AllowedRange::SIMULATION_TOLERANCE),
        /// The points, in the order of the file.
        pub points: Vec<TrajectoryPoint> = |section, _| {
            section.read("point", "a list of points, each under [[trajectories.point]]", read_points)
        },
    }
    outcome: Vec<TrajectoryRun>,
    tables: [tables::TABLES, own_runs::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let runs = section.points.iter().map(|point| point.laws.len()).sum::<usize>();
        Work::simulations(runs as f64, nearest_f64(&section.tolerance))
    },
    run: |section, earlier, _| Some(run::trajectories(earlier.slider()?, section, &earlier.scene.threshold())),
}

keys! {
    /// `[[trajectories.point]]`: one point of operation.
    pub struct TrajectoryPoint {
        /// The name by which figures and tables refer to the point, safe as a file name.
        pub id: String = |section, key| section.name(key, "the name of the point"),
        /// σ, Pa.
        pub normal_stress_pa: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// V_l, m/s.
        pub loading_velocity_m_per_s: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// How long the run is followed from its start, s.
        pub duration_s: Rational = |section, key| section.decimal(key, AllowedRange::PHYSICAL),
        /// The evolution laws, each once.
        pub laws: Vec<EvolutionLaw> = |section, _| section.laws(),
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
