//! `[tolerance]`: relative errors.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::open_unit_list;
use crate::scene::{Faults, Limits};
use slipmode_core::number::Rational;

/// `[tolerance]`: where each asymptote is good to a relative error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToleranceSection {
    /// Relative errors, each strictly between 0 and 1.
    pub relative: Vec<Rational>,
}

impl ReadSection for ToleranceSection {
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let relative = section
            .required("relative", "a list of relative errors, each 0 < value < 1", faults)
            .and_then(|entry| open_unit_list(&entry, faults));
        section.finish(faults);
        Some(Self { relative: relative? })
    }
}
