//! `[work_precision]`: the cycles on which integrators are compared.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::{Place, places};
use crate::scene::{Faults, Limits};

/// `[work_precision]`: work against error of the integrators on one period of the limit cycle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkPrecisionSection {
    /// The returns.
    pub places: Vec<Place>,
}

impl ReadSection for WorkPrecisionSection {
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let places = places(&mut section, faults);
        section.finish(faults);
        Some(Self { places: places? })
    }
}
