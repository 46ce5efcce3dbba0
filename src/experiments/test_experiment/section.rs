//! `[test_experiment]`: normal stresses.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::decimals;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::number::Rational;

/// `[test_experiment]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestExperimentSection {
    /// Normal stresses, Pa.
    pub normal_stress_pa: Vec<Rational>,
}

impl ReadSection for TestExperimentSection {
    fn read(entry: &Entry<'_>, _: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let normal_stress_pa = decimals(&mut section, "normal_stress_pa", AllowedRange::PHYSICAL, faults);
        section.finish(faults);
        Some(Self { normal_stress_pa: normal_stress_pa? })
    }
}
