//! max Im(s) along lines of constant normal stress (fig 2).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{FrequencyLine, FrequencyOutcome, frequency_lines};
pub use section::FrequencySection;

use crate::experiments::work::DECISION_S;
use crate::experiments::{Drawer, Experiment, Requirement, Setting, TableMaker, Work};

impl Experiment for FrequencySection {
    type Outcome = FrequencyOutcome;
    const REQUIREMENT: Requirement = Requirement::CriticalNormalStress;
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        let lines = self.normal_stress_over_critical.len() as f64;
        Work::points(f64::from(self.loading_velocity_m_per_s.points) * lines, DECISION_S)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(frequency_lines(setting.slider()?, self))
    }
}
