//! `[map]`: the points that are classified.

use crate::scene::Rectangle;
use crate::scene::section::{ReadSection, Section};

/// `[map]`: the points that are classified.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MapSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for MapSection {
    fn read(section: &mut Section<'_>) -> Self {
        Self { rectangle: section.checked_rectangle() }
    }
}
