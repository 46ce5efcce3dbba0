//! `[zones]`: the points whose slip modes are compared.

use crate::scene::Rectangle;
use crate::scene::section::{Entry, ReadSection};

/// `[zones]`: the points whose slip modes are compared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ZonesSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for ZonesSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        Some(Self { rectangle: Rectangle::read(entry)? })
    }
}
