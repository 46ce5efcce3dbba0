//! `[boundary]`: how many points of the boundary, to how many digits.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::points;
use crate::scene::{Faults, Limits};

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
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let points = points(&mut section, limits, faults);
        let digits = section
            .required("digits", &format!("1 to {MOST_DIGITS}"), faults)
            .and_then(|entry| entry.whole(1..=MOST_DIGITS, faults));
        section.finish(faults);
        Some(Self { points: points?, digits: u32::try_from(digits?).ok()? })
    }
}
