//! The exact boundary of a scene: its points, its marks, and the agreement of the three routes to it.

mod columns;
pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use columns::{LinePoint, PointColumn, Stated, vanishes};
pub use run::{BoundaryOutcome, END_ERROR};

use crate::experiments::{Work, experiment};

/// The largest number of digits that may be requested.
const MOST_DIGITS: u64 = 1_000_000;

experiment! {
    /// `[boundary]`: the exact boundary along its arcs, how many points of it, to how many digits.
    #[derive(Copy)]
    pub struct BoundarySection {
        /// Points on each arc.
        pub points: u32 = |section, _| section.points(),
        /// Certified decimal digits of each coordinate.
        pub digits: u32 = |section, key| section.whole(key, 1..=MOST_DIGITS),
    }
    outcome: BoundaryOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    // On each of two arcs.
    work: |section| Work::certified_points(f64::from(section.points) * 2.0, section.digits),
    run: |section, earlier, _| Some(run::boundary_outcome(earlier.slider()?, *section)),
}
