//! Where oscillation begins along lines of constant normal stress (figs 4 and 6).

pub(crate) mod figures;
pub(crate) mod first_swing;
pub(crate) mod run;
pub(crate) mod search;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod theory;

pub use first_swing::Swing;
pub use run::{Onset, OnsetOutcome, OtherUnit, ShownRun, StressOnset, onset};
pub use search::{Located, SeenOnset};
pub use section::OnsetSection;

use crate::experiments::work::SEARCH_RUNS;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};
use slipmode_core::number::nearest_f64;

impl Experiment for OnsetSection {
    type Outcome = OnsetOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        let runs = SEARCH_RUNS * self.laws.len() as f64 + self.velocity_over_asymptote.len() as f64;
        let stress_runs = SEARCH_RUNS * (self.laws.len() * self.loading_velocity_m_per_s.len()) as f64;
        let runs = runs * self.normal_stress_pa.len() as f64 + stress_runs;
        Work::simulations(runs, nearest_f64(&self.tolerance))
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(onset(setting.slider()?, self, &setting.threshold()))
    }
}
