//! The nonlinear slider close to K = K_c.

pub(crate) mod bistability;
pub(crate) mod cycle_families;
mod edge_law;
pub(crate) mod figures;
pub(crate) mod kicks;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use bistability::{Edge, Threshold, place_on_transition};
pub use cycle_families::{AmplitudeDeviation, CycleFamilyOutcome, FamilyCycle};
pub use edge_law::EdgeLaw;
pub use kicks::{Border, SmallestKick};
pub use run::{NearRun, NearTransitionOutcome, near_transition};
pub use section::{KicksSection, NearTransitionSection};

use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

impl Experiment for NearTransitionSection {
    type Outcome = NearTransitionOutcome;
    const REQUIREMENT: Requirement = Requirement::CriticalNormalStress;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        let grid = self.inertial_parameter.len() as f64 * self.stiffness_over_critical.len() as f64;
        let runs = (grid + self.edge_inertial_parameter.len() as f64) * 10.0;
        Work::simulations(runs, nearest_f64(&self.tolerance))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(near_transition(setting.slider()?, self))
    }
}
