//! Work against error by counts that no machine changes: roots of a cubic, classes of many points, a point of the boundary, a sweep.
//!
//! The stick-slip cycle, the fifth of the kind, is in `integrators`.

mod boundary_point;
mod classes;
mod cubics;
mod figures;
mod sets;
mod sweep;
mod tables;

pub use boundary_point::BoundaryCount;
pub use classes::ClassCount;
pub use cubics::RootCount;
pub use figures::figures;
pub use sweep::SweepCount;
pub use tables::tables;

use crate::paper::paper;

/// How much is counted, and to which errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Cubics of each of the two sets.
    pub cubics: u32,
    /// Digits requested of certified roots and of boundary points.
    pub digits: &'static [u32],
    /// Points that are classified.
    pub points: u32,
    /// The first of them, which every textbook method classifies too.
    pub textbook_points: u32,
    /// Velocities and stresses of the sweep, each.
    pub sweep_side: u32,
    /// Relative errors requested of the sweep.
    pub tolerances: &'static [f64],
}

impl Sizes {
    /// What the report on the paper shows.
    pub const REPORTED: Self = Self {
        cubics: 200,
        digits: &[16, 32, 100, 1_000, 10_000],
        points: 1_000_000,
        textbook_points: 50_000,
        sweep_side: 6,
        tolerances: &[1e-2, 1e-4, 1e-6, 1e-8, 1e-10],
    };
}

/// Everything that is counted.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedCounts {
    /// Roots of two sets of cubics, method by method.
    pub roots: Vec<RootCount>,
    /// Signs of random points, by precision level and by method.
    pub classes: Vec<ClassCount>,
    /// One point of the boundary by each route.
    pub boundary: Vec<BoundaryCount>,
    /// A sweep of simulations.
    pub sweep: Vec<SweepCount>,
}

/// Makes all counts, those of the boundary and of the sweep for the paper's slider.
#[must_use]
pub fn speed_counts(sizes: &Sizes) -> SpeedCounts {
    SpeedCounts {
        roots: cubics::count(sizes),
        classes: classes::count(sizes.points, sizes.textbook_points),
        boundary: boundary_point::count(&paper(), sizes.digits),
        sweep: sweep::count(&paper(), sizes),
    }
}
