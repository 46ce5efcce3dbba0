//! `[error_bound]`: how many sliders, and the relative errors requested of their runs.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::decimals;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::number::Rational;

/// `[error_bound]`: estimated errors compared with true ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ErrorBoundSection {
    /// Triples of groups; each is run with both laws.
    pub groups: u32,
    /// Relative errors requested.
    pub tolerances: Vec<Rational>,
}

impl ReadSection for ErrorBoundSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let most = limits.max_points.min(u64::from(u32::MAX));
        let groups = section
            .required("groups", &format!("a whole number from 1 to {most}"), faults)
            .and_then(|entry| entry.whole(1..=most, faults));
        let tolerances = decimals(&mut section, "tolerances", AllowedRange::SIMULATION_TOLERANCE, faults);
        section.finish(faults);
        Some(Self { groups: u32::try_from(groups?).ok()?, tolerances: tolerances? })
    }
}
