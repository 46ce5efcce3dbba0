//! The exact boundary of a scene: its points, its marks, and the agreement of the three routes to it.

mod columns;
pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod section;
pub(crate) mod tables;

pub use columns::{LinePoint, PointColumn, Stated, vanishes};
pub use run::{BoundaryOutcome, END_ERROR, boundary_outcome};
pub use section::BoundarySection;

use crate::experiments::{Drawer, Experiment, Setting, TableMaker, Work};

impl Experiment for BoundarySection {
    type Outcome = BoundaryOutcome;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [Drawer]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        // On each of two arcs.
        Work::certified_points(f64::from(self.points) * 2.0, self.digits)
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(boundary_outcome(setting.slider()?, *self))
    }
}
