//! `[work_precision]`: the cycles on which integrators are compared.

use crate::scene::Place;
use crate::scene::section::{Entry, ReadSection};

/// `[work_precision]`: work against error of the integrators on one period of the limit cycle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkPrecisionSection {
    /// The returns.
    pub places: Vec<Place>,
}

impl ReadSection for WorkPrecisionSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let places = section.places("places");
        section.finish();
        Some(Self { places: places? })
    }
}
