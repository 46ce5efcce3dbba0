//! `[boundary]`: how many points of the boundary, to how many digits.

use crate::scene::section::{ReadSection, Section};

/// `[boundary]`: the exact boundary along its arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundarySection {
    /// Points on each arc.
    pub points: u32,
    /// Certified decimal digits of each coordinate.
    pub digits: u32,
}

/// The largest number of digits that may be requested.
const MOST_DIGITS: u64 = 1_000_000;

impl ReadSection for BoundarySection {
    fn read(section: &mut Section<'_>) -> Self {
        Self { points: section.points(), digits: section.whole("digits", 1..=MOST_DIGITS) }
    }
}
