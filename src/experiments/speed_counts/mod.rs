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

use crate::experiments::work::{DECISION_S, certified_point_s};
use crate::experiments::{Experiment, FigureMaker, Setting, TableMaker, Work};

impl Experiment for SpeedCountsSection {
    type Outcome = SpeedCounts;
    const TABLES: &'static [&'static [TableMaker]] = &[tables::TABLES];
    const FIGURES: &'static [&'static [FigureMaker]] = &[figures::FIGURES];

    fn work(&self) -> Work {
        let points = f64::from(self.points) + f64::from(self.textbook_points) * 10.0;
        let digits = self.digits.iter().map(|digits| f64::from(*digits));
        let certified: f64 = digits.clone().map(certified_point_s).sum();
        let runs = f64::from(self.sweep_side) * f64::from(self.sweep_side);
        let runs = Work::simulations_at_each(runs, &self.tolerances);
        Work {
            what: format!("{points} points and {}", runs.what),
            core_seconds: points * DECISION_S + f64::from(self.cubics) * certified + runs.core_seconds,
            digits: digits.fold(0.0, f64::max),
            ..Work::points(points / 10.0, DECISION_S)
        }
    }

    fn run(&self, setting: &Setting<'_>) -> Option<Self::Outcome> {
        Some(speed_counts(setting.slider()?, self))
    }
}
