//! Work against error by counts that no machine changes: roots of a cubic, classes of many points, a point of the boundary, a sweep.
//!
//! The stick-slip cycle, the fifth of the kind, is in [`work_precision`](crate::experiments::work_precision::work_precision).

use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;

mod boundary_point;
mod classes;
mod cubics;
pub(crate) mod figures;
mod section;
mod sets;
mod sweep;
pub(crate) mod tables;

pub use boundary_point::BoundaryCount;
pub use classes::{ClassCounts, MethodCount};
pub use cubics::RootCount;
pub use sweep::SweepCount;

/// Everything that is counted.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedCounts {
    /// Roots of two sets of cubics, method by method.
    pub roots: Vec<RootCount>,
    /// Classes of random points.
    pub classes: ClassCounts,
    /// One point of the boundary by each route.
    pub boundary: Vec<BoundaryCount>,
    /// A sweep of simulations.
    pub sweep: Vec<SweepCount>,
}

/// Makes all counts of the section.
#[must_use]
pub fn speed_counts(parameters: &Slider<Rational>, section: &SpeedCountsSection) -> SpeedCounts {
    SpeedCounts {
        roots: cubics::count(section),
        classes: classes::count(section.points, section.textbook_points),
        boundary: boundary_point::count(parameters, &section.digits),
        sweep: sweep::count(parameters, section),
    }
}
pub use section::SpeedCountsSection;

use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker};

impl Experiment for SpeedCountsSection {
    type Outcome = SpeedCounts;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(speed_counts(setting.slider()?, self))
    }
}
