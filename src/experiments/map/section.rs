//! `[map]`: the points that are classified.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{Faults, Limits, Rectangle};

/// `[map]`: the points that are classified.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for MapSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        Some(Self { rectangle: Rectangle::read(entry, limits, faults)? })
    }
}
