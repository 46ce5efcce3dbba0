//! Where oscillation begins along lines of constant normal stress (figs 4 and 6).

pub(crate) mod figures;
pub(crate) mod first_swing;
pub(crate) mod run;
pub(crate) mod search;
pub(crate) mod section;
pub(crate) mod tables;
pub(crate) mod theory;

pub use run::{Onset, OnsetOutcome, OtherUnit, ShownRun, onset};
pub use search::{Located, SeenOnset};
pub use section::OnsetSection;

use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker};

impl Experiment for OnsetSection {
    type Outcome = OnsetOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(onset(setting.slider()?, self, &setting.threshold()))
    }
}
