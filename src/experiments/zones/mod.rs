//! Exact slip modes compared with the simplified map of the asymptotes (fig 7).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use run::{InertialLine, LineCount, ThresholdShare, ZonesOutcome, compare_zones};
pub use section::ZonesSection;

use crate::experiments::map::classify_rectangle;
use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for ZonesSection {
    type Outcome = ZonesOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        Work::map(&self.rectangle)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        let slider = setting.slider()?;
        // A map of the same rectangle has the exact half already.
        let same = setting.scene().map.as_ref().is_some_and(|map| map.rectangle == self.rectangle);
        Some(match setting.earlier.map.as_ref().filter(|_| same) {
            Some(map) => compare_zones(slider, map),
            None => compare_zones(slider, &classify_rectangle(slider, &self.rectangle, &setting.threshold())),
        })
    }
}
