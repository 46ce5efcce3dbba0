//! max Im(s), spectral class and slip mode on a (V, σ) grid (figs 1, 6a and 7).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{MapPoint, classify_rectangle};
pub use section::MapSection;

use crate::experiments::shared::Grid;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for MapSection {
    type Outcome = Grid<MapPoint>;
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];

    fn work(&self) -> Work {
        Work::map(&self.rectangle)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(classify_rectangle(setting.slider()?, &self.rectangle, &setting.threshold()))
    }
}
