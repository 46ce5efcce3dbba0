//! `[map]`: the points that are classified.

use crate::scene::Rectangle;
use crate::scene::section::{Entry, ReadSection};

/// `[map]`: the points that are classified.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for MapSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        Some(Self { rectangle: Rectangle::read(entry)? })
    }
}
