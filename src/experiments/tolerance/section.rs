//! `[tolerance]`: relative errors.

use crate::scene::AllowedRange;
use crate::scene::section::{Entry, ReadSection};
use slipmode_core::number::Rational;

/// `[tolerance]`: where each asymptote is good to a relative error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToleranceSection {
    /// Relative errors, each strictly between 0 and 1.
    pub relative: Vec<Rational>,
}

impl ReadSection for ToleranceSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let allowed = "a list of relative errors, each 0 < value < 1";
        let relative = section.decimals("relative", allowed, AllowedRange::OPEN_UNIT);
        section.finish();
        Some(Self { relative: relative? })
    }
}
