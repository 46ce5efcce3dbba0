//! `[error_bound]`: how many sliders, and the relative errors requested of their runs.

use crate::scene::AllowedRange;
use crate::scene::section::{Entry, ReadSection};
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
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let most = section.limits().max_points.min(u64::from(u32::MAX));
        let groups = section.whole("groups", 1..=most);
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let allowed = format!("a list of numbers, each {}", range.text());
        let tolerances = section.decimals("tolerances", &allowed, range);
        section.finish();
        Some(Self { groups: u32::try_from(groups?).ok()?, tolerances: tolerances? })
    }
}
