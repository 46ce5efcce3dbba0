//! `[tolerance]`: relative errors.

use crate::scene::AllowedRange;
use crate::scene::section::{ReadSection, Section};
use slipmode_core::number::Rational;

/// `[tolerance]`: where each asymptote is good to a relative error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToleranceSection {
    /// Relative errors, each strictly between 0 and 1.
    pub relative: Vec<Rational>,
}

impl ReadSection for ToleranceSection {
    fn read(section: &mut Section<'_>) -> Self {
        let allowed = "a list of relative errors, each 0 < value < 1";
        Self { relative: section.decimals("relative", allowed, AllowedRange::OPEN_UNIT) }
    }
}
