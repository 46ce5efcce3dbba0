//! `[zones]`: the points whose slip modes are compared.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{Faults, Limits, Rectangle};

/// `[zones]`: the points whose slip modes are compared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ZonesSection {
    /// The grid.
    pub rectangle: Rectangle,
}

impl ReadSection for ZonesSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        Some(Self { rectangle: Rectangle::read(entry, limits, faults)? })
    }
}
