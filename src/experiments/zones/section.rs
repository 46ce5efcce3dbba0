//! `[zones]`: the points whose slip modes are compared.

use crate::scene::Rectangle;
use crate::scene::section::{ReadSection, Section};

/// `[zones]`: the points whose slip modes are compared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ZonesSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for ZonesSection {
    fn read(section: &mut Section<'_>) -> Self {
        Self { rectangle: section.checked_rectangle() }
    }
}
